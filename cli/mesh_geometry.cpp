// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_geometry.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/geometry_size.hpp"
#include "cli/scene_name.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "geometry/geometry_file.hpp"
#include "geometry/geometry_process.hpp"
#include "geometry/repair_solids.hpp"
#include "geometry/select_faces.hpp"
#include "geometry/solids_that_meet.hpp"
#include "geometry/triangle_file.hpp"
#include "mesher/geometry_options.hpp"
#include "mesher/mesh_spheres.hpp"
#include "postproc/triangle_file.hpp"
#include "scene/read_scene.hpp"

namespace dmp::cli {

namespace {

std::string springs_text(const MeshReport::SpringLine& line) {
    if (line.cells) {
        const CellConstants& cells = line.cells->constants;
        return fmt::format("a solid of E {}, nu {:.3g}; k_b {} and {}", quantity_text(cells.youngs_modulus(), "Pa"),
                           cells.poisson_ratio(), quantity_text(line.cells->stiffened * cells.edge_stiffness, "N/m"),
                           quantity_text(line.cells->stiffened * cells.diagonal_stiffness, "N/m"));
    }
    if (line.elements)
        return fmt::format("a solid of E {}, nu {:.3g}: {} ({})", quantity_text(line.elements->youngs_modulus, "Pa"),
                           line.elements->poisson_ratio, count_text(line.elements->count, "cell"), line.elements->law);
    if (line.network)
        return fmt::format("a solid of E {}, nu {:.3g}; {} of k_b {} to {}",
                           quantity_text(line.network->youngs_modulus, "Pa"), NetworkConstants::poisson_ratio,
                           count_text(line.bonds, "bond"), quantity_text(line.network->softest, "N/m"),
                           quantity_text(line.network->stiffest, "N/m"));
    if (line.shell) {
        const ShellConstants& shell = line.shell->constants;
        return fmt::format("a shell of D {}, E h {}{}; k_b {}, k_d {}", quantity_text(shell.bending_stiffness(), "N m"),
                           quantity_text(shell.membrane_stiffness(), "N/m"),
                           shell.membrane_stiffness() < 0.999 * line.shell->membrane_stiffness_asked
                               ? " (lowered from " + quantity_text(line.shell->membrane_stiffness_asked, "N/m") +
                                     ": the layers cannot hold both at this spacing)"
                               : "",
                           quantity_text(shell.bond_stiffness, "N/m"), quantity_text(shell.dihedral_stiffness, "J"));
    }
    std::string text = "k_b " + quantity_text(line.bond_stiffness, "N/m");
    if (line.cross_stiffness > 0) text += ", k_c " + quantity_text(line.cross_stiffness, "N/m");
    if (line.hinges > 0) text += ", k_a " + quantity_text(line.hinge_stiffness, "J");
    text += fmt::format(", EI {}, EA {}", quantity_text(line.bending_stiffness, "N m^2"),
                        quantity_text(line.axial_stiffness, "N"));
    if (std::abs(line.axial_stiffness / line.axial_stiffness_asked - 1) > 0.001) {
        text += fmt::format(" ({} from {}: the lattice cannot hold both at this spacing)",
                            line.axial_stiffness < line.axial_stiffness_asked ? "lowered" : "raised",
                            quantity_text(line.axial_stiffness_asked, "N"));
    }
    return text + fmt::format(", GA {}", quantity_text(line.shear_stiffness, "N"));
}

/// A geometry and what was changed in it.
struct Repaired {
    Geometry geometry;
    std::vector<std::string> changes;
};

RepairRung rung_of(RepairKind repair) {
    switch (repair) {
        case RepairKind::none:
            return RepairRung::none;
        case RepairKind::weld:
            return RepairRung::weld;
        case RepairKind::fill:
            return RepairRung::fill;
        case RepairKind::vote:
            return RepairRung::vote;
        case RepairKind::wrap:
            break;
    }
    return RepairRung::wrap;
}

/// Closes fluids of which the geometry has an open surface, as far as that can be done.
void repair_fluids(Repaired& cad_geometry, const Scene& scene) {
    const auto fluids = scene.names_of_parts(PartKind::fluid);
    try {
        RepairLimits limits;
        limits.spacing = scene.particles.spacing;
        limits.highest = rung_of(scene.geometry.repair);
        limits.largest_hole = scene.geometry.largest_hole;
        const auto lines = repair_solids(cad_geometry.geometry, fluids, limits);
        cad_geometry.changes.insert(cad_geometry.changes.end(), lines.begin(), lines.end());
    } catch (const UnusableSurface& error) {
        const std::string file = scene_name(scene) + "_bad_triangles.vtp";
        write_triangles(file, error.bad_triangles().corners, error.bad_triangles().triangles);
        throw InputError(error.where(), error.problem(), error.what_to_do() + " (the triangles are in " + file + ")");
    }
}

/// The geometry with its fluids closed, and with the faces that the scene selects of what they are then.
Repaired repaired_geometry(const Scene& scene, const GeometryReading& reading) {
    GeometryOptions options = geometry_options_of(scene);
    const auto selections = std::exchange(options.selections, {});
    if (scene.dimension == 3 && !has_straight_edges_only(options.file)) {
        // Coarsely first: surfaces that follow a spacing far too fine take minutes, and then all memory.
        GeometryOptions coarse = options;
        coarse.chord_error = std::numeric_limits<double>::max();
        check_geometry_size(answer_geometry_request_command(coarse, reading), scene);
    }
    Repaired cad_geometry{answer_geometry_request_command(options, reading), {}};
    if (is_triangle_file(cad_geometry.geometry.file)) cad_geometry.changes = cad_geometry.geometry.warnings;
    check_geometry_size(cad_geometry.geometry, scene);
    if (cad_geometry.geometry.dimension == 3) {
        auto names = scene.names_of_parts(PartKind::rigid);
        for (std::string& name : scene.names_of_parts(PartKind::fluid)) names.push_back(std::move(name));
        for (const SolidMeeting& meeting : solids_that_meet_themselves(cad_geometry.geometry, names))
            cad_geometry.changes.push_back(meeting.text(1e-3, "mm") +
                                           ": what lies inside any part of it counts as inside");
        repair_fluids(cad_geometry, scene);
        // Of curved surfaces that touch, triangles are off by 0.005 spacings or so.
        for (const SolidMeeting& meeting :
             solids_that_overlap(cad_geometry.geometry, names, 0.05 * scene.particles.spacing))
            cad_geometry.changes.push_back(meeting.text(1e-3, "mm") +
                                           ": rigid bodies take the room first, then fluids in the scene's order");
    }
    select_faces(cad_geometry.geometry, selections);
    return cad_geometry;
}

MeshResult with_notes(MeshResult result, const Repaired& cad_geometry) {
    result.report.notes.insert(result.report.notes.end(), cad_geometry.changes.begin(), cad_geometry.changes.end());
    return result;
}

}  // namespace

Geometry answer_geometry_request_command(GeometryOptions options, const GeometryReading& reading) {
    if (reading.trusted) options.trust = Trust::full;
    GeometryProcess process{.command = {"/proc/self/exe", read_geometry_command}};
    if (!reading.time.empty()) {
        const SourceLocation location{"--geometry-time", 0, 0};
        process.seconds = read_quantity(reading.time, "s", location);
        if (!(process.seconds > 0))
            throw InputError(location, "'" + reading.time + "' is no time for this",
                             "Give a time after 0, e.g. --geometry-time \"1 h\".");
    }
    process.still_reading = [&](double seconds, const std::string& stage) {
        print_error(fmt::format("{}: still being read after {:.0f} s: {}. It is given up after {} (--geometry-time)\n",
                                options.file, seconds, stage, duration_text(process.seconds)));
    };
    return read_geometry_in_process(options, process);
}

int execute(const ReadGeometryCommand& /*command*/) { return answer_geometry_request(); }

MeshResult mesh_geometry(const Scene& scene, const GeometryReading& reading) {
    if (is_of_spheres(scene)) return mesh_spheres(scene);
    const Repaired cad_geometry = repaired_geometry(scene, reading);
    return with_notes(mesh(cad_geometry.geometry, scene), cad_geometry);
}

MeshResult mesh_geometry(const Scene& scene, const GeometryReading& reading, MeshDetail& detail) {
    if (is_of_spheres(scene)) return mesh_spheres(scene);
    const Repaired cad_geometry = repaired_geometry(scene, reading);
    MeshResult result = with_notes(mesh(cad_geometry.geometry, scene), cad_geometry);
    detail = inspect(result, cad_geometry.geometry, scene);
    return result;
}

Origin origin_of(const Scene& scene, const MeshReport& report) {
    Origin origin{
        is_of_spheres(scene) ? "spheres" : "geometry", scene.geometry.file, {}, report.notes, report.warnings};
    for (const auto& line : report.springs) origin.springs.emplace_back("springs " + line.part, springs_text(line));
    for (const auto& line : report.joins)
        origin.springs.emplace_back("join " + line.name,
                                    fmt::format("{} of k_b {} between {} and {}", count_text(line.bonds, "bond"),
                                                quantity_text(line.stiffness, "N/m"), line.parts[0], line.parts[1]));
    return origin;
}

}  // namespace dmp::cli
