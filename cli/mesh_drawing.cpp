// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_drawing.hpp"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "cli/text.hpp"
#include "geometry/geometry.hpp"
#include "mesher/mesh_spheres.hpp"

namespace dmp::cli {

namespace {

/// Polylines follow the drawing's curves this closely [spacings].
constexpr double chord_error_in_spacings = 1e-3;

DrawingOptions drawing_of(const Scene& scene) {
    const std::filesystem::path file = *scene.geometry.file;
    DrawingOptions options;
    options.file = file.is_absolute() ? file.string() : (std::filesystem::path(scene.directory) / file).string();
    options.unit = scene.geometry.unit;
    options.chord_error = chord_error_in_spacings * scene.particles.spacing;
    options.place = scene.geometry.file.place;
    for (const auto& [name, value] : scene.geometry.parameters) {
        options.parameters[name] = value;
        options.parameter_places[name] = value.place;
    }
    return options;
}

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

MeshResult mesh_drawing(const Scene& scene) {
    return is_of_spheres(scene) ? mesh_spheres(scene) : mesh(read_drawing(drawing_of(scene)), scene);
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
