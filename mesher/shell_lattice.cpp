// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/shell_lattice.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <utility>

#include "base/errors.hpp"
#include "base/length_text.hpp"
#include "mesher/uses.hpp"
#include "particles/dihedral_angle.hpp"

namespace dmp::mesher {

namespace {

constexpr double root3 = std::numbers::sqrt3;

/// Lame's constants of the membrane [N/m].
struct Membrane {
    double lambda, mu;
};

Membrane membrane_of(const ShellConstants& shell) {
    const double a2 = shell.edge * shell.edge, t2 = shell.distance * shell.distance, l2 = a2 + t2;
    const double area = root3 / 2 * a2;
    const double p = 2 * shell.bond_stiffness * a2 + 2 * shell.cross_stiffness * a2 * a2 / l2;
    const double q = 4 * shell.cross_stiffness * a2 * t2 / l2;
    const double r = 6 * shell.cross_stiffness * t2 * t2 / l2 + shell.rung_stiffness * t2;
    const double mu = 3 * p / (4 * area);
    return {q > 0 ? mu - 9 * q * q / (8 * r * area) : mu, mu};
}

/// An edge of the surface, from the smaller point number to the larger.
struct Edge {
    std::array<int, 2> opposite{-1, -1};  ///< points of the triangles that have it forwards and backwards
    double area = 0;                      ///< of those triangles [m^2]
};
using Edges = std::map<std::pair<int, int>, Edge>;

void add_triangle(Edges& edges, const std::array<int, 3>& corners, double area) {
    for (int k = 0; k < 3; ++k) {
        const int from = corners[k], to = corners[(k + 1) % 3];
        Edge& edge = edges[std::minmax(from, to)];
        int& opposite = edge.opposite[from < to ? 0 : 1];
        if (opposite >= 0) {
            std::ostringstream problem;
            problem << "the edge from point " << from << " to point " << to
                    << " belongs to more than two triangles, or to two that are not oriented alike";
            throw InputError(problem.str(), "give a surface that does not branch, all triangles seen from one side");
        }
        opposite = corners[(k + 2) % 3];
        edge.area += area;
    }
}

}  // namespace

double ShellConstants::membrane_stiffness() const {
    const auto [lambda, mu] = membrane_of(*this);
    return 4 * mu * (lambda + mu) / (lambda + 2 * mu);
}

double ShellConstants::membrane_poisson_ratio() const {
    const auto [lambda, mu] = membrane_of(*this);
    return lambda / (lambda + 2 * mu);
}

double ShellConstants::bending_stiffness() const {
    return 3 * root3 / 4 * bond_stiffness * distance * distance + 2 * root3 * dihedral_stiffness;
}

double ShellConstants::bending_poisson_ratio() const {
    return (root3 / 4 * bond_stiffness * distance * distance - 2 / root3 * dihedral_stiffness) / bending_stiffness();
}

double ShellConstants::shear_stiffness() const {
    const double t2 = distance * distance;
    return 4 * root3 * cross_stiffness * t2 / (edge * edge + t2);
}

ShellConstants shell_constants(double membrane_stiffness, double bending_stiffness, double edge, double distance) {
    ShellConstants unit{edge, distance, 1, 1, 1, 0};
    const double bond = membrane_stiffness / unit.membrane_stiffness();
    const double by_layers = bond * unit.bending_stiffness();
    if (by_layers > bending_stiffness * (1 + 1e-12)) {
        std::ostringstream problem, what_to_do;
        problem << "two layers " << length_text(distance) << " apart of a membrane stiffness of " << membrane_stiffness
                << " N/m bend with " << by_layers << " N*m, more than the " << bending_stiffness << " N*m asked for";
        what_to_do << "bring the layers together to about "
                   << length_text(distance * std::sqrt(bending_stiffness / by_layers));
        throw InputError(problem.str(), what_to_do.str());
    }
    return {edge, distance, bond, bond, bond, std::max(0.0, (bending_stiffness - by_layers) / (2 * root3))};
}

SpringLattice shell_lattice(const std::vector<Vec>& points, const std::vector<std::array<int, 3>>& triangles,
                            const ShellConstants& constants, const ParticleSpace& space,
                            const std::vector<bool>& clamped) {
    const auto between = [&](const Vec& from, const Vec& to) { return nearest_image(to - from, space); };
    Edges edges;
    std::vector<Vec> normal(points.size(), Vec::Zero());
    std::vector<double> share(points.size(), 0);
    double whole = 0;
    for (std::size_t n = 0; n < triangles.size(); ++n) {
        const auto& corners = triangles[n];
        const Vec& first = points[corners[0]];
        const Vec across = between(first, points[corners[1]]).cross(between(first, points[corners[2]]));
        const double area = across.norm() / 2;
        if (!(area > 0))
            throw InputError("triangle " + std::to_string(n) + " has no area", "give it three corners off one line");
        add_triangle(edges, corners, area);
        whole += area;
        for (const int corner : corners) {
            share[corner] += area / 3;
            normal[corner] += across;
        }
    }
    const double node_area = 2 * whole / static_cast<double>(triangles.size());  // of a point inside

    SpringLattice lattice;
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (share[n] == 0) throw InputError("point " + std::to_string(n) + " belongs to no triangle", "leave it out");
        for (const double side : {0.5, -0.5}) {
            lattice.nodes.emplace_back(points[n] + side * constants.distance * normal[n].normalized());
            lattice.share.push_back(share[n] / 2);
        }
    }
    const auto bond = [&](int a, int b, double stiffness) {
        if (stiffness > 0)
            lattice.bonds.push_back({a, b, between(lattice.nodes[b], lattice.nodes[a]).norm(), stiffness});
    };
    for (std::size_t n = 0; n < points.size(); ++n)
        bond(static_cast<int>(2 * n), static_cast<int>(2 * n + 1), constants.rung_stiffness * share[n] / node_area);
    const auto hinge = [&](int a, int centre, int b, double stiffness) {
        const Vec to_a = between(lattice.nodes[centre], lattice.nodes[a]),
                  to_b = between(lattice.nodes[centre], lattice.nodes[b]);
        lattice.hinges.push_back({a, centre, b, std::atan2(to_a.cross(to_b).norm(), to_a.dot(to_b)), stiffness});
    };
    /// Of a clamped edge on the border, from a to b; c is the point opposite to it.
    const auto hold = [&](int a, int b, int c, double area) {
        const double length = between(points[b], points[a]).norm(), height = 2 * area / length;
        double squares = 0;
        for (const int end : {a, b}) squares += square(height) / between(points[end], points[c]).squaredNorm();
        const double stiffness = root3 * constants.dihedral_stiffness * length / (height * squares);
        for (const int end : {a, b})
            for (const int layer : {0, 1}) hinge(2 * end + 1 - layer, 2 * end + layer, 2 * c + layer, stiffness);
    };
    for (const auto& [ends, edge] : edges) {
        const auto [a, b] = ends;
        const int beside = std::max(edge.opposite[0], edge.opposite[1]);
        const bool is_on_border = std::min(edge.opposite[0], edge.opposite[1]) < 0;
        if (!clamped.empty() && is_on_border && clamped[a] && clamped[b] && !clamped[beside] &&
            constants.dihedral_stiffness > 0)
            hold(a, b, beside, edge.area);
        const double length_square = between(points[b], points[a]).squaredNorm();
        const double weight = edge.area / length_square * 2 / root3;  // 1 inside equilateral triangles
        for (const int layer : {0, 1}) {
            bond(2 * a + layer, 2 * b + layer, constants.bond_stiffness * weight);
            bond(2 * a + layer, 2 * b + 1 - layer, constants.cross_stiffness * weight);
            if (edge.opposite[0] < 0 || edge.opposite[1] < 0 || constants.dihedral_stiffness == 0) continue;
            const std::array<int, 4> four{2 * edge.opposite[0] + layer, 2 * a + layer, 2 * b + layer,
                                          2 * edge.opposite[1] + layer};
            const auto& x = lattice.nodes;
            lattice.dihedrals.push_back(
                {four[0], four[1], four[2], four[3],
                 dihedral_angle(between(x[four[1]], x[four[0]]), between(x[four[2]], x[four[1]]),
                                between(x[four[2]], x[four[3]])),
                 constants.dihedral_stiffness / weight});
        }
    }
    return lattice;
}

}  // namespace dmp::mesher
