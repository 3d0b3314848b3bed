// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "base/length_text.hpp"
#include "mesher/mesh.hpp"

namespace dmp::mesher {

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

std::string sums_text(const MeshReport::KernelSums& sums) {
    return fmt::format("{:.4f} +- {:.4f} ({} particles)", sums.mean, sums.spread, sums.particles);
}

/// The tallest bars, by distance; with very many, where the middle ones of ten lie.
std::string nearest_text(const MeshReport::PartLine& part) {
    constexpr std::size_t most_bars = 6;
    std::string bars;
    std::size_t shown = 0, seen = 0;
    double low = 0, high = 0;
    const auto total = static_cast<double>(part.particles);
    for (std::size_t bar = 0; bar < part.nearest_counts.size(); ++bar) {
        const std::size_t count = part.nearest_counts[bar];
        if (count == 0) continue;
        const double distance = static_cast<double>(bar) * MeshReport::nearest_bar;
        if (static_cast<double>(seen) <= 0.1 * total) low = distance;
        if (static_cast<double>(seen) <= 0.9 * total) high = distance;
        seen += count;
        if (shown++ > 0) bars += ", ";
        bars += fmt::format("{:.2f}: {:.4g} %", distance, 100 * static_cast<double>(count) / total);
    }
    return shown <= most_bars ? bars : fmt::format("{} bars, 80 % from {:.2f} to {:.2f}", shown, low, high);
}

std::string deviation_text(const MeshReport::Deviation& deviation, int dimension) {
    return fmt::format("mean {:+.3f}, RMS {:.3f}, largest {:.3f} at {}", deviation.mean, deviation.rms,
                       deviation.largest, position_text(deviation.where, dimension));
}

std::string cost_text(const MeshReport& report) {
    std::size_t particles = 0, walls = 0;
    for (const MeshReport::PartLine& part : report.parts) {
        particles += part.particles;
        if (part.kind == "rigid") walls += part.particles;
    }
    double all = 0;
    std::string stages;
    for (const MeshReport::Stage& stage : report.cost.stages) {
        all += stage.seconds;
        stages += fmt::format("{}{} {:.3g}", stages.empty() ? "" : ", ", stage.name, stage.seconds);
    }
    if (stages.empty()) return "";
    std::string text = fmt::format("cost: {:.3g} s ({})", all, stages);
    const auto rate = [&](std::size_t count, const char* what, std::initializer_list<const char*> names) {
        double seconds = 0;
        for (const char* name : names) seconds += report.cost.of(name).seconds;
        if (count > 0 && seconds > 0) text += fmt::format("; {:.2g} {}/s", static_cast<double>(count) / seconds, what);
    };
    rate(report.cost.candidates, "candidate points", {"lattice", "fluids"});
    rate(walls, "wall particles", {"nearest triangles", "walls"});
    rate(particles, "particles in all", {"lattice", "fluids", "nearest triangles", "walls"});
    if (report.cost.peak_bytes > 0)
        text += fmt::format("; at most {:.3g} MB of memory", 1e-6 * static_cast<double>(report.cost.peak_bytes));
    return text + "\n";
}

/// What inspect() has found.
std::string inspection_text(const MeshReport& report) {
    std::string text;
    for (const MeshReport::SurfaceLine& line : report.surfaces)
        text += fmt::format(
            "surface of {} [spacings]\n"
            "  from its particles: {}\n  from the geometry:   {}; at most {:.3f} from a particle\n",
            line.part, deviation_text(line.from_particles, report.dimension),
            deviation_text(line.from_geometry, report.dimension), line.farthest);
    for (const MeshReport::LayerLine& line : report.layers)
        text += fmt::format("layers of {}: {:.2f} on average, at least {:.2f} of {} (at {})\n", line.part, line.mean,
                            line.fewest, line.asked, position_text(line.where, report.dimension));
    if (!report.leaks) return text;
    if (report.leaks->cells == 0) return text + "leak test: there is nothing outside the fluid\n";
    if (report.leaks->particles == 0)
        return text + fmt::format("leak test: tight ({} cells flooded from outside)\n", report.leaks->cells);
    return text + fmt::format("leak test: LEAKS; a flood from outside reaches {} fluid particles, the first at {}\n",
                              report.leaks->particles, position_text(report.leaks->where, report.dimension));
}

/// What cells in the form of a straight bar stand for.
std::string bar_text(const MeshReport::SpringLine::Bar& bar) {
    std::string text = fmt::format("  as a straight bar {} long: EA = {:.4g} N ({:.4f} of the drawn one)",
                                   length_text(bar.length), bar.axial.value, bar.axial.over_drawn);
    for (const auto& [value, over_drawn] : bar.bending)
        text += fmt::format(", EI = {:.4g} N m^2 ({:.4f})", value, over_drawn);
    return text + "\n";
}

/// What the springs of a part are, and what they give as a solid.
std::string springs_text(const MeshReport::SpringLine& line) {
    const std::string head = fmt::format("springs of {}: {} {}, {} bonds", line.part, line.bodies,
                                         line.bodies == 1 ? "body" : "bodies", line.bonds);
    const std::string clamped = fmt::format(", {} nodes clamped\n", line.anchored);
    if (line.cells) {
        const auto& [constants, stiffened] = *line.cells;
        return head +
               fmt::format(
                   " of k_b = {:.4g} N/m along edges and {:.4g} N/m along diagonals, {} hinges of k_a = {:.4g} J{}"
                   "  give E = {:.4g} Pa, nu = {:.3g}; {:.4g} kg a node. They span 1/{:.3g} of the {}, and "
                   "are {:.3g} times as stiff for it; they stand for {:.4g} of what is drawn, whose mass they have\n",
                   stiffened * constants.edge_stiffness, stiffened * constants.diagonal_stiffness, line.hinges,
                   stiffened * constants.hinge_stiffness, clamped, constants.youngs_modulus(),
                   constants.poisson_ratio(), line.particle_mass, stiffened,
                   constants.dimension == 3 ? "volume" : "area", stiffened, line.counted);
    }
    if (line.elements) {
        const MeshReport::SpringLine::Elements& of = *line.elements;
        const std::string text = fmt::format(
            "cells of {}: {} {}, {} cells ({} cut by the surface) on {} nodes{}  give E = {:.4g} Pa, nu = {:.3g} ({}); "
            "{:.6g} of the drawn volume; {:.4g} kg a whole cell\n",
            line.part, line.bodies, line.bodies == 1 ? "body" : "bodies", of.count, of.cut, of.nodes, clamped,
            of.youngs_modulus, of.poisson_ratio, of.law, of.volume / of.drawn, line.particle_mass);
        return line.bar ? text + bar_text(*line.bar) : text;
    }
    if (line.network)
        return head +
               fmt::format(
                   " of k_b = {:.4g} to {:.4g} N/m{}  give E = {:.4g} Pa, nu = {:.3g} in an even strain; {:.2g} of "
                   "their stiffness depends on direction; {:.4g} kg a node; they stand for {:.4g} of what is drawn, "
                   "whose "
                   "mass they have\n",
                   line.network->softest, line.network->stiffest, clamped, line.network->youngs_modulus,
                   NetworkConstants::poisson_ratio, line.network->anisotropy, line.particle_mass, line.counted);
    if (line.shell) {
        const ShellConstants& shell = line.shell->constants;
        return head + fmt::format(
                          " of k_b = {:.4g} N/m, {} dihedrals of k_d = {:.4g} J{}"
                          "  give D = {:.4g} N*m, E h = {:.4g} N/m (asked: {:.4g}), shear {:.4g} N/m; {:.4g} kg a "
                          "node\n",
                          shell.bond_stiffness, line.dihedrals, shell.dihedral_stiffness, clamped,
                          shell.bending_stiffness(), shell.membrane_stiffness(), line.shell->membrane_stiffness_asked,
                          shell.shear_stiffness(), line.particle_mass);
    }
    std::string constants = fmt::format(" of k_b = {:.4g} N/m", line.bond_stiffness);
    if (line.cross_stiffness > 0)
        constants += fmt::format(" along rows and k_c = {:.4g} N/m across", line.cross_stiffness);
    if (line.hinges > 0) constants += fmt::format(", {} hinges of k_a = {:.4g} J", line.hinges, line.hinge_stiffness);
    return head + constants + clamped +
           fmt::format("  give EI = {:.4g} N*m^2, EA = {:.4g} N, GA_s = {:.4g} N; {:.4g} kg a node\n",
                       line.bending_stiffness, line.axial_stiffness, line.shear_stiffness, line.particle_mass);
}

std::string join_text(const MeshReport::JoinLine& line) {
    std::string text = fmt::format("join {}: {} bonds of k_b = {:.4g} N/m between {} and {}, {} to {} long", line.name,
                                   line.bonds, line.stiffness, line.parts[0], line.parts[1], length_text(line.shortest),
                                   length_text(line.longest));
    if (line.across_gaps > 0) text += fmt::format("; {} left out, across a gap", line.across_gaps);
    return text + "\n";
}

std::string valence_text(const MeshReport::SpringLine& line) {
    std::string text;
    for (std::size_t bonds = 0; bonds < line.valence.size(); ++bonds)
        if (line.valence[bonds] > 0)
            text += fmt::format("{}{} nodes with {}", text.empty() ? "" : ", ", line.valence[bonds], bonds);
    return text;
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
    for (const PartLine& part : parts) {
        if (part.kernel_sum_mean <= 0) continue;
        text += fmt::format("{}: volume error {:+.3f} %\n", part.name, 100 * part.volume_error());
        if (part.inside.particles > 0) text += fmt::format("  kernel sum inside:     {}\n", sums_text(part.inside));
        if (part.near_walls.particles > 0)
            text += fmt::format("  kernel sum near walls: {}\n", sums_text(part.near_walls));
        text += fmt::format("  nearest neighbours [spacings]: {}\n", nearest_text(part));
    }
    text += inspection_text(*this);
    if (at_rest)
        text += at_rest->holds()
                    ? fmt::format("at rest: no particle left in {} steps; fluid moved by {:.3f} spacings at most\n",
                                  at_rest->steps, at_rest->largest_move)
                    : fmt::format("at rest: PARTICLES LEAVE: {} lost in {} steps. {}\n", at_rest->lost, at_rest->steps,
                                  at_rest->fault);
    for (const SpringLine& line : springs) {
        text += springs_text(line);
        if (!line.valence.empty())
            text += fmt::format("  {} {}; bonds: {}\n", line.pieces, line.pieces == 1 ? "piece" : "pieces",
                                valence_text(line));
    }
    for (const JoinLine& line : joins) text += join_text(line);
    text += cost_text(*this);
    for (const std::string& note : notes) text += "note: " + note + "\n";
    for (const std::string& warning : warnings) text += "warning: " + warning + "\n";
    return text;
}

}  // namespace dmp::mesher
