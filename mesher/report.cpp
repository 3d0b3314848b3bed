// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "mesher/mesh.hpp"

namespace dmp {

namespace {

std::string line_of(const MeshReport::SpheresLine& line) {
    std::string text = fmt::format("spheres of {}: {}, radius {:.4g}", line.part, line.spheres, line.smallest);
    if (line.largest > line.smallest) text += fmt::format(" to {:.4g}", line.largest);
    text += fmt::format(" m, {:.4g} kg together", line.mass);
    if (!line.around.empty())
        text += fmt::format("; they hide {:.4f} of the surface of {}", line.coverage, line.around);
    if (line.volume_fraction > 0) text += fmt::format("; volume fraction {:.4f}", line.volume_fraction);
    return text + "\n";
}

std::string line_of(const MeshReport::WallLine& line) {
    if (line.triangles == 0) return fmt::format("wall {}: a plane\n", line.part);
    return fmt::format("wall {}: {} triangles of {:.4g} mm^2\n", line.part, line.triangles, 1e6 * line.area);
}

}  // namespace

std::string MeshReport::text() const {
    std::string text;
    for (const WallLine& line : walls) text += line_of(line);
    for (const SpheresLine& line : spheres) text += line_of(line);
    if (!spheres.empty())
        text += touching == 0
                    ? "no two of them touch\n"
                    : fmt::format("{} pairs of them touch, the deepest by {:.4g} m\n", touching, deepest_overlap);
    if (!parts.empty())
        text += fmt::format("{:<14} {:<8} {:>9}  {:>22}  {:>13}  {:>16}\n", "part", "kind", "particles",
                            "drawn / filled", "nearest [dx]", "kernel sum");
    for (const PartLine& part : parts) {
        const double scale = part.unit == "m^3" ? 1e9 : part.unit == "m^2" ? 1e6 : 1e3;
        const std::string size =
            part.target > 0 ? fmt::format("{:.4g} / {:.4g} m{}", scale * part.target, scale * part.reached, part.unit)
                            : "-";
        const std::string sum = part.kernel_sum_mean > 0
                                    ? fmt::format("{:.4f} +- {:.4f}", part.kernel_sum_mean, part.kernel_sum_spread)
                                    : "-";
        text += fmt::format("{:<14} {:<8} {:>9}  {:>22}  {:>13.3f}  {:>16}\n", part.name, part.kind, part.particles,
                            size, part.nearest, sum);
    }
    for (const SpringLine& line : springs) {
        const std::string corners = line.cross_stiffness > 0
                                        ? fmt::format("of k_b = {:.4g} N/m along rows and k_c = {:.4g} N/m across",
                                                      line.bond_stiffness, line.cross_stiffness)
                                        : fmt::format("of k_b = {:.4g} N/m, {} hinges of k_a = {:.4g} J",
                                                      line.bond_stiffness, line.hinges, line.hinge_stiffness);
        text += fmt::format(
            "springs of {}: {} {}, {} bonds {}, {} nodes clamped\n"
            "  give EI = {:.4g} N*m^2, EA = {:.4g} N, GA_s = {:.4g} N; {:.4g} kg a node\n",
            line.part, line.bodies, line.bodies == 1 ? "body" : "bodies", line.bonds, corners, line.anchored,
            line.bending_stiffness, line.axial_stiffness, line.shear_stiffness, line.particle_mass);
    }
    for (const std::string& note : notes) text += "note: " + note + "\n";
    return text;
}

}  // namespace dmp
