// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/spring_bodies.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>

#include "base/disjoint_sets.hpp"
#include "base/length_text.hpp"
#include "geometry/remesh_surface.hpp"
#include "mesher/uses.hpp"
#include "particles/cell_grid.hpp"

namespace dmp::mesher {

namespace {

/// A sheet of less area has nothing to bend [spacings squared].
constexpr double least_area = 16;

/// The constants of a shell of this E h and D.
ShellConstants shell_constants_of(const Part& part, double membrane, double bending, double edge, double distance) {
    const ShellConstants unit{edge, distance, 1, 1, 1, 0};
    const double by_layers = membrane * unit.bending_stiffness() / unit.membrane_stiffness();
    if (by_layers <= 0.5 * bending) return shell_constants(membrane, bending, edge, distance);
    if (part.lower_axial_stiffness)
        return shell_constants(membrane * 0.5 * bending / by_layers, bending, edge, distance);
    if (by_layers <= bending) return shell_constants(membrane, bending, edge, distance);
    std::ostringstream problem;
    problem << "two layers " << distance << " m apart that stretch as '" << part.name.value
            << "' does, with E h = " << membrane << " N/m, bend with D = " << by_layers << " N*m alone, more than its "
            << bending << " N*m";
    throw InputError(part.thickness.location, problem.str(),
                     "refine particles.spacing to about the thickness, or set lower_axial_stiffness = true");
}

/// Makes the corners of a sheet on the high side of the box those on the low side, where there is one for each.
TriangleSurface with_rims_joined(TriangleSurface sheet, const ParticleSpace& space) {
    constexpr double on_side = 1e-3, alike = 0.05;  // [spacings]
    for (int axis = 0; axis < space.dimension; ++axis) {
        if (!space.periodic[axis]) continue;
        std::array<std::vector<std::size_t>, 2> rim;  // the low one and the high one
        for (std::size_t n = 0; n < sheet.corners.size(); ++n)
            for (const std::size_t side : {0U, 1U}) {
                const double at = (side == 0 ? space.box.low : space.box.high)[axis];
                if (std::abs(sheet.corners[n][axis] - at) < on_side * space.spacing) rim.at(side).push_back(n);
            }
        std::map<std::size_t, std::size_t> low_of;  // by corner of the high rim
        for (const std::size_t high : rim[1]) {
            const auto distance = [&](std::size_t low) {
                Vec apart = sheet.corners[high] - sheet.corners[low];
                apart[axis] -= space.box.extent()[axis];  // along this axis alone: a corner is on two sides
                return apart.norm();
            };
            const auto low = std::ranges::min_element(rim[0], {}, distance);
            if (low != rim[0].end() && distance(*low) < alike * space.spacing) low_of[high] = *low;
        }
        std::set<std::size_t> taken;
        for (const auto& [high, low] : low_of) taken.insert(low);
        if (taken.empty() || taken.size() != rim[0].size() || low_of.size() != rim[1].size()) continue;
        std::vector<int> number(sheet.corners.size());
        std::vector<Vec> kept;
        for (std::size_t n = 0; n < sheet.corners.size(); ++n) {
            if (low_of.contains(n)) continue;
            number[n] = static_cast<int>(kept.size());
            kept.push_back(sheet.corners[n]);
        }
        for (const auto& [high, low] : low_of) number[high] = number[low];
        for (auto& triangle : sheet.triangles)
            for (int& corner : triangle) corner = number[static_cast<std::size_t>(corner)];
        sheet.corners = std::move(kept);
    }
    return sheet;
}

/// By corner: a full turn over the angle that its triangles take up: 1 inside a flat sheet, 2 at its border, 4 at a
/// corner.
std::vector<double> turns_over_angles(const TriangleSurface& sheet, const ParticleSpace& space) {
    std::vector<double> angle(sheet.corners.size(), 0);
    for (const auto& triangle : sheet.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto corner = [&](std::size_t n) -> const Vec& {
                return sheet.corners[static_cast<std::size_t>(triangle.at(n % 3))];
            };
            const Vec a = nearest_image(corner(k + 1) - corner(k), space);
            const Vec b = nearest_image(corner(k + 2) - corner(k), space);
            angle[static_cast<std::size_t>(triangle.at(k))] += std::atan2(a.cross(b).norm(), a.dot(b));
        }
    for (double& each : angle) each = 2 * std::numbers::pi / each;
    return angle;
}

/// By particle: whether it has a bond, to one from `first` on, through the periodic side across an axis.
std::vector<bool> with_bonds_across(const ParticleSet& set, int axis, std::size_t first) {
    std::vector<bool> across(set.size(), false);
    if (!set.periodic.at(static_cast<std::size_t>(axis))) return across;
    for (const Bond& bond : set.bonds) {
        const auto a = static_cast<std::size_t>(bond.a), b = static_cast<std::size_t>(bond.b);
        if (std::min(a, b) >= first &&
            std::abs(set.position[a][axis] - set.position[b][axis]) > 0.5 * set.box.extent()[axis])
            across[a] = across[b] = true;
    }
    return across;
}

/// A node near the low side of the box across an axis that one near the high side would be bonded to, if the part went
/// on there.
std::optional<std::size_t> bonded_across(const ParticleSet& set, int axis, const std::vector<std::size_t>& low,
                                         const std::vector<std::size_t>& high) {
    const double reach = 1.25 * set.spacing;
    Coordinates points;
    for (int k = 0; k < 3; ++k)
        for (const std::size_t i : high)
            points[k].push_back(set.position[i][k] - (k == axis ? set.box.extent()[axis] : 0));
    const CellGrid grid(points, high.size(), set.dimension, reach);
    for (const std::size_t i : low) {
        const Vec& here = set.position[i];
        bool any = false;
        grid.for_each_near({here.x(), here.y(), here.z()}, reach, [&](int k) {
            const auto at = static_cast<std::size_t>(k);
            any = any || (Vec(points[0][at], points[1][at], points[2][at]) - here).norm() < reach;
        });
        if (any) return i;
    }
    return std::nullopt;
}

}  // namespace

SolidBody solid_body(const Part& part, const std::vector<Vec>& points, const Vec& step, const ParticleSpace& space) {
    const int dimension = space.dimension;
    if (part.poisson_ratio > 0.25)
        throw InputError(part.poisson_ratio.location,
                         "a solid of springs cannot have a Poisson ratio of more than 0.25: bonds alone give that, and "
                         "hinges lower it",
                         "write poisson_ratio = 0.25, which needs no hinges and is the fastest");
    const double cell = step.head(dimension).prod();
    SolidBody body;
    body.constants = cell_constants(part.youngs_modulus, part.poisson_ratio,
                                    dimension == 3 ? std::cbrt(cell) : std::sqrt(cell), dimension);
    body.lattice = cell_lattice(points, body.constants, step, points_in_period(space, step));
    const double filled = std::accumulate(body.lattice.share.begin(), body.lattice.share.end(), 0.0);
    body.stiffened = static_cast<double>(points.size()) * cell / filled;
    for (Bond& bond : body.lattice.bonds) bond.stiffness *= body.stiffened;
    for (Hinge& hinge : body.lattice.hinges) hinge.stiffness *= body.stiffened;
    body.volume.assign(points.size(), cell);
    body.mass.assign(points.size(), cell * part.density);
    return body;
}

ShellBody shell_body(const Part& part, const TriangleSurface& sheet, const ParticleSpace& space,
                     const std::function<bool(const Vec&)>& is_clamped) {
    const double spacing = space.spacing;
    // Of equilateral triangles with a node for each spacing^2: sqrt(3)/2 edge^2.
    const double edge = spacing * std::sqrt(2 / std::numbers::sqrt3);
    if (sheet.area() < least_area * spacing * spacing) {
        std::ostringstream problem;
        problem << "a sheet of '" << part.name.value << "' has an area of " << 1e6 * sheet.area() << " mm^2, less than "
                << least_area << " particles";
        throw InputError(part.name.location, problem.str(), "refine particles.spacing or draw a larger sheet");
    }
    const TriangleSurface fine = with_rims_joined(remesh_surface(sheet, edge), space);
    const double h = part.thickness, nu = part.poisson_ratio;
    ShellBody body;
    body.membrane_stiffness_asked = part.youngs_modulus * h;
    const double bending = part.youngs_modulus * h * h * h / (12 * (1 - nu * nu));
    body.constants = shell_constants_of(part, body.membrane_stiffness_asked, bending, edge, spacing);
    std::vector<bool> clamped;
    for (const Vec& corner : fine.corners) clamped.push_back(is_clamped(corner));
    body.lattice = shell_lattice(fine.corners, fine.triangles, body.constants, space, clamped);
    const std::vector<double> turns = turns_over_angles(fine, space);
    for (std::size_t node = 0; node < body.lattice.nodes.size(); ++node) {
        const double area = body.lattice.share[node];  // two layers of nodes share it, and are each a spacing thick
        body.volume.push_back(2 * area * turns[node / 2] * spacing);
        body.mass.push_back(area * h * part.density);
    }
    return body;
}

std::vector<int> pieces_of(const SpringLattice& lattice, int& pieces) {
    DisjointSets sets(lattice.nodes.size());
    for (const Bond& bond : lattice.bonds)
        sets.join(static_cast<std::size_t>(bond.a), static_cast<std::size_t>(bond.b));
    std::vector<int> piece(lattice.nodes.size());
    for (std::size_t node = 0; node < piece.size(); ++node) {
        const std::size_t first = sets.find(node);
        piece[node] = first == node ? pieces++ : piece[first];
    }
    return piece;
}

void add_elastic_of(const SpringLattice& lattice, std::size_t first, ParticleSet& set, MeshReport::SpringLine& line) {
    const auto shift = static_cast<int>(first);
    const auto& [nodes, share, bonds, hinges, dihedrals] = lattice;  // all: one more does not compile
    for (Bond bond : bonds) {
        bond.a += shift;
        bond.b += shift;
        set.bonds.push_back(bond);
    }
    for (Hinge hinge : hinges) {
        hinge.a += shift;
        hinge.centre += shift;
        hinge.b += shift;
        set.hinges.push_back(hinge);
    }
    for (Dihedral dihedral : dihedrals) {
        dihedral.a += shift;
        dihedral.b += shift;
        dihedral.c += shift;
        dihedral.d += shift;
        set.dihedrals.push_back(dihedral);
    }
    line.bonds += bonds.size();
    line.hinges += hinges.size();
    line.dihedrals += dihedrals.size();
}

void share_drawn_mass(const Part& part, double drawn, const std::vector<Vec>& corners, std::size_t first,
                      ParticleSet& set, MeshReport::SpringLine& line, MeshReport& report) {
    double counted = 0;
    for (std::size_t i = first; i < set.size(); ++i) counted += set.volume[i];
    line.counted = counted / drawn;
    const auto is_beyond = [&](const Vec& corner) {
        const double a_little = 1e-6 * set.spacing;
        for (int axis = 0; axis < set.dimension; ++axis) {
            const auto at = static_cast<std::size_t>(axis);
            if ((set.periodic[at] || set.mirrored[at][0]) && corner[axis] < set.box.low[axis] - a_little) return true;
            if ((set.periodic[at] || set.mirrored[at][1]) && corner[axis] > set.box.high[axis] + a_little) return true;
        }
        return false;
    };
    if (std::ranges::any_of(corners, is_beyond)) return;
    for (std::size_t i = first; i < set.size(); ++i) set.mass[i] = set.volume[i] / line.counted * part.density;
    line.particle_mass = set.mass[first];
    if (std::abs(line.counted - 1) <= 0.1) return;
    std::ostringstream warning;
    warning.precision(3);
    warning << part.name.value << ": its nodes stand for " << line.counted << " of the drawn "
            << (set.dimension == 3 ? "volume" : "area")
            << ", which is what they displace of a liquid; their mass is that of what is drawn; a finer "
               "particles.spacing is nearer";
    report.warnings.push_back(warning.str());
}

void note_open_ends(const ParticleSet& set, std::size_t first, const std::string& part, bool may_be_cells,
                    MeshReport& report) {
    std::vector<std::size_t> free;
    for (std::size_t i = first; i < set.size(); ++i)
        if (set.fixed[i] == 0) free.push_back(i);
    for (int axis = 0; axis < set.dimension; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        const std::vector<bool> goes_on = with_bonds_across(set, axis, first);
        std::array<std::vector<std::size_t>, 2> near;  // the low side and the high one
        for (const std::size_t i : free) {
            if (goes_on[i]) continue;
            if (set.position[i][axis] < set.box.low[axis] + set.spacing) near[0].push_back(i);
            if (set.position[i][axis] > set.box.high[axis] - set.spacing) near[1].push_back(i);
        }
        const std::string across = std::string("the side of the box across ") + "xyz"[axis];
        for (const std::size_t side : {0U, 1U})
            if (set.mirrored.at(at)[side] && !near.at(side).empty())
                report.warnings.push_back(
                    part + ": its springs end at " + across + ", a plane of symmetry, near " +
                    position_text(set.position[near.at(side)[0]], set.dimension) +
                    ", and are free as if they were cut there; " +
                    (may_be_cells
                         ? "leave out model = \"springs\" and bonds_within: the nodes of cells stay on the plane"
                         : "draw it a spacing short of the plane, or both halves"));
        if (!set.periodic.at(at) || (near[0].empty() && near[1].empty())) continue;
        if (const auto cut = bonded_across(set, axis, near[0], near[1])) {
            report.warnings.push_back(
                part + ": its springs end at " + across + ", which is periodic, near " +
                position_text(set.position[*cut], set.dimension) +
                ", and are free as if they were cut there, though it is drawn on both sides; " +
                (may_be_cells
                     ? "leave out model = \"springs\" and bonds_within: cells go on there"
                     : "draw its ends or rims alike on both sides, a period apart, or a spacing short of them"));
        } else if (std::ranges::find(goes_on, true) == goes_on.end()) {
            report.notes.push_back(part + ": its springs end at " + across +
                                   ", where it is free as if it were cut there");
        }
    }
}

}  // namespace dmp::mesher
