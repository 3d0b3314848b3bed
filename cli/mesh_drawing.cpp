// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_drawing.hpp"

#include <cmath>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/text.hpp"
#include "geometry/drawing_child.hpp"
#include "geometry/triangle_file.hpp"
#include "mesher/drawing_of.hpp"
#include "mesher/mesh_spheres.hpp"

namespace dmp::cli {

namespace {

std::string springs_text(const MeshReport::SpringLine& line) {
    const std::string corners = line.cross_stiffness > 0 ? "k_c " + quantity_text(line.cross_stiffness, "N/m")
                                                         : "k_a " + quantity_text(line.hinge_stiffness, "J");
    std::string text =
        fmt::format("k_b {}, {}, EI {}, EA {}", quantity_text(line.bond_stiffness, "N/m"), corners,
                    quantity_text(line.bending_stiffness, "N m^2"), quantity_text(line.axial_stiffness, "N"));
    if (std::abs(line.axial_stiffness / line.axial_stiffness_asked - 1) > 0.001) {
        text += fmt::format(" ({} from {}: the lattice cannot hold both at this spacing)",
                            line.axial_stiffness < line.axial_stiffness_asked ? "lowered" : "raised",
                            quantity_text(line.axial_stiffness_asked, "N"));
    }
    return text + fmt::format(", GA {}", quantity_text(line.shear_stiffness, "N"));
}

}  // namespace

Geometry read_drawing_of_a_stranger(const DrawingOptions& options) {
    return read_drawing_apart(options, {.command = {"/proc/self/exe", read_drawing_word}});
}

int execute(const ReadDrawingCommand& /*command*/) { return answer_drawing_request(); }

MeshResult mesh_drawing(const Scene& scene) {
    if (is_of_spheres(scene)) return mesh_spheres(scene);
    const Geometry geometry = read_drawing_of_a_stranger(drawing_of(scene));
    MeshResult result = mesh(geometry, scene);
    if (is_triangle_file(geometry.file))  // what was changed in it
        result.report.notes.insert(result.report.notes.end(), geometry.warnings.begin(), geometry.warnings.end());
    return result;
}

MeshResult mesh_drawing(const Scene& scene, MeshDetail& detail) {
    if (is_of_spheres(scene)) return mesh_spheres(scene);
    const Geometry geometry = read_drawing(drawing_of(scene));
    MeshResult result = mesh(geometry, scene);
    detail = inspect(result, geometry, scene);
    return result;
}

Origin origin_of(const Scene& scene, const MeshReport& report) {
    Origin origin{is_of_spheres(scene) ? "spheres" : "drawing", scene.geometry.file, {}, report.notes};
    for (const auto& line : report.springs) origin.springs.emplace_back(line.part, springs_text(line));
    return origin;
}

}  // namespace dmp::cli
