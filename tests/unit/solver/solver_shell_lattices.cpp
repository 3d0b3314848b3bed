// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Shells of springs: what their spring constants are said to give, against static solves.
#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "mesher/spring_lattice.hpp"
#include "solver/simulation.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/bodies_in_space.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_shell_lattices_tests {
namespace {

using namespace lattice_solids;

/// Nodal forces of a uniform membrane stress [N/m] in the upper and in the lower layer.
Loads layer_stress(const Surface& surface, const Eigen::Matrix2d& upper, const Eigen::Matrix2d& lower) {
    std::map<std::pair<int, int>, int> uses;
    for (const auto& t : surface.triangles)
        for (int k = 0; k < 3; ++k) ++uses[std::minmax(t[k], t[(k + 1) % 3])];
    Loads load(2 * surface.points.size(), V3{});
    for (const auto& t : surface.triangles)
        for (int k = 0; k < 3; ++k) {
            const int a = t[k], b = t[(k + 1) % 3];
            if (uses[std::minmax(a, b)] != 1) continue;
            const Vec along = surface.points[b] - surface.points[a];
            const Eigen::Vector2d outward(along[1], -along[0]);  // times the edge's length
            for (const int layer : {0, 1}) {
                const Eigen::Vector2d force = (layer == 0 ? upper : lower) * outward / 2;
                for (const int end : {a, b})
                    for (int axis = 0; axis < 2; ++axis) load[2 * end + layer][axis] += force[axis];
            }
        }
    return load;
}

/// Those of nodes, or of their displacements, well inside the hexagon and in the upper layer.
std::vector<Vec> inner(const Surface& surface, const std::vector<Vec>& values, double radius) {
    std::vector<Vec> some;
    for (std::size_t n = 0; n < surface.points.size(); ++n)
        if (surface.points[n].norm() < radius)
            some.push_back(values.size() == surface.points.size() ? values[n] : values[2 * n]);
    return some;
}

constexpr double edge = 0.1;
const ShellConstants some_shell{edge, 0.06, 3, 1.5, 2, 0};

TEST(ShellLattice, has_the_membrane_stiffness_said_in_any_direction) {
    const Surface surface = hexagon(8, edge);
    const ParticleSet set = set_of(shell_lattice(surface.points, surface.triangles, some_shell));
    const double strain = 1e-6, stiffness = some_shell.membrane_stiffness(), nu = some_shell.membrane_poisson_ratio();
    for (const double turn : {0.0, 0.3, pi / 2}) {
        const Eigen::Vector2d along(std::cos(turn), std::sin(turn)), across(-along[1], along[0]);
        const Eigen::Matrix2d stress = stiffness * strain / 2 * along * along.transpose();
        const auto moved = displacements(set, layer_stress(surface, stress, stress));
        const auto at = inner(surface, surface.points, 5 * edge), by = inner(surface, moved, 5 * edge);
        const auto flat = [](const Vec& x) { return Eigen::VectorXd(Eigen::Vector3d(1, x[0], x[1])); };
        const auto u = fit(at, by, 0, flat), v = fit(at, by, 1, flat);
        Eigen::Matrix2d gradient;
        gradient << u[1], u[2], v[1], v[2];
        EXPECT_NEAR(along.dot(gradient * along) / strain, 1, 2e-3);
        EXPECT_NEAR(across.dot(gradient * across) / strain, -nu, 2e-3);
    }
}

/// Curvatures along x and y of a patch under a moment Mx = 1e-6 D on a unit width, over those of theory.
std::pair<double, double> curvature_over_theory(const Surface& surface, const ShellConstants& shell, double radius) {
    const ParticleSet set = set_of(shell_lattice(surface.points, surface.triangles, shell));
    const double nu = shell.bending_poisson_ratio(), moment = 1e-6 * shell.bending_stiffness();
    Eigen::Matrix2d stress = Eigen::Matrix2d::Zero();
    stress(0, 0) = moment / shell.distance;
    const auto moved = displacements(set, layer_stress(surface, -stress, stress));
    const auto w = fit(inner(surface, surface.points, radius), inner(surface, moved, radius), 2, quadratic);
    // M = D (kappa_x + nu kappa_y), 0 = kappa_y + nu kappa_x
    const double expected = 1e-6 / (1 - nu * nu);
    return {w[3] / expected, w[4] / expected};
}

TEST(ShellLattice, layers_bend_as_a_plate) {
    const auto [along, across] = curvature_over_theory(hexagon(8, edge), some_shell, 5 * edge);
    EXPECT_NEAR(along, 1, 2e-3);
    EXPECT_NEAR(across, -some_shell.bending_poisson_ratio(), 2e-3);
}

TEST(ShellLattice, dihedrals_bend_as_said_inside_a_patch) {
    // Energy of a uniform curvature in the dihedrals of both layers, an equal number in all three directions: each
    // stands for a third of a node's area.
    const Surface surface = hexagon(6, edge);
    ShellConstants shell = some_shell;
    shell.dihedral_stiffness = 0.01;
    ParticleSet set = set_of(shell_lattice(surface.points, surface.triangles, shell));
    set.bonds.clear();
    shell.bond_stiffness = 0;
    const double area = static_cast<double>(set.dihedrals.size()) / 2 / 3 * std::sqrt(0.75) * edge * edge;
    Body body(set, part_with(0), 0);
    for (const auto& [x, y] : {std::pair{1.0, 0.0}, std::pair{0.0, 1.0}, std::pair{1.0, 1.0}, std::pair{1.0, -1.0}}) {
        const double kx = 1e-3 * x, ky = 1e-3 * y;
        for (std::size_t n = 0; n < set.size(); ++n) {
            const Vec& at = set.position[n];
            body.positions()[n] = {{at[0], at[1], at[2] + (kx * at[0] * at[0] + ky * at[1] * at[1]) / 2}};
        }
        const double d = shell.bending_stiffness(), nu = shell.bending_poisson_ratio();
        EXPECT_NEAR(body.energy() / (area * d * (kx * kx + ky * ky + 2 * nu * kx * ky) / 2), 1, 2e-3);
    }
}

TEST(ShellLattice, a_plate_with_dihedrals_bends_as_said_but_for_its_border) {
    ShellConstants shell =
        shell_constants(some_shell.membrane_stiffness(), 2 * some_shell.bending_stiffness(), edge, 0.06);
    EXPECT_NEAR(shell.membrane_stiffness() / some_shell.membrane_stiffness(), 1, 1e-12);
    EXPECT_NEAR(shell.bending_stiffness() / some_shell.bending_stiffness(), 2, 1e-12);
    const auto [along, across] = curvature_over_theory(hexagon(10, edge), shell, 5 * edge);
    EXPECT_NEAR(along, 1, 2e-3);
    EXPECT_NEAR(across, -shell.bending_poisson_ratio(), 0.05);
}

/// A strip along x of rows of equilateral triangles whose edges on the border are along y.
Surface rows_of_triangles(int rows, int across) {
    Surface surface;
    const double height = std::sqrt(0.75) * edge;
    for (int row = 0; row <= rows; ++row)
        for (int n = 0; n <= across; ++n) surface.points.emplace_back(row * height, (n + 0.5 * (row % 2)) * edge, 0);
    const auto number = [&](int row, int n) { return row * (across + 1) + n; };
    for (int row = 0; row < rows; ++row)
        for (int n = 0; n < across; ++n) {
            const int a = number(row, n), b = number(row, n + 1), c = number(row + 1, n), d = number(row + 1, n + 1);
            if (row % 2 == 0) {
                surface.triangles.push_back({a, c, b});
                surface.triangles.push_back({b, c, d});
            } else {
                surface.triangles.push_back({a, c, d});
                surface.triangles.push_back({a, d, b});
            }
        }
    return surface;
}

/// Deflection of the free side of a clamped strip under even forces on its nodes, over that of a beam.
double sag_over_beam(int rows, bool with_hinges) {
    const int across = 16;
    const Surface surface = rows_of_triangles(rows, across);
    const ShellConstants shell =
        shell_constants(some_shell.membrane_stiffness(), 2 * some_shell.bending_stiffness(), edge, 0.06);
    std::vector<bool> clamped;
    for (const Vec& point : surface.points) clamped.push_back(point[0] < 1e-9);
    const auto none = std::vector<bool>{};
    ParticleSet set = set_of(shell_lattice(surface.points, surface.triangles, shell, {}, with_hinges ? clamped : none));
    for (std::size_t n = 0; n < set.size(); ++n) set.fixed[n] = clamped[n / 2] ? 1 : 0;
    Loads load(set.size(), V3{});
    double moments = 0;
    const double length = rows * std::sqrt(0.75) * edge, force = 1e-9;
    for (std::size_t n = 0; n < set.size(); ++n) {
        const double x = set.position[n][0];
        load[n][2] = force;
        moments += force * x * x * (3 * length - x) / 6;
    }
    const auto moved = displacements(set, load);
    double tip = 0;
    for (std::size_t n = set.size() - 2 * (across + 1); n < set.size(); ++n) tip += moved[n][2] / (2 * (across + 1));
    // The Poisson ratio of bending is 0 with half of D by the layers; nodes across are half an edge apart from row to
    // row.
    return tip / (moments / (shell.bending_stiffness() * across * edge));
}

TEST(ShellLattice, clamped_bends_as_a_beam_from_its_clamp_on) {
    for (const int rows : {12, 24}) {
        EXPECT_GT(sag_over_beam(rows, false), 1 + 2.0 / rows) << rows;
        EXPECT_NEAR(sag_over_beam(rows, true), 1, 0.02) << rows;
    }
}

TEST(ShellLattice, of_uneven_triangles_is_near_what_is_said) {
    const auto [along, across] = curvature_over_theory(hexagon(8, edge, 0.15), some_shell, 5 * edge);
    EXPECT_NEAR(along, 1, 0.02);  // measured: 0.8 % off
    EXPECT_NEAR(across, -some_shell.bending_poisson_ratio(), 0.05);
}

TEST(ShellLattice, resists_transverse_shear_as_said) {
    // Energy of u = gamma z: only the diagonals between layers are strained.
    const Surface surface = hexagon(6, edge);
    const ParticleSet set = set_of(shell_lattice(surface.points, surface.triangles, some_shell));
    Body body(set, part_with(0), 0);
    double area = 0;
    for (const double share : shell_lattice(surface.points, surface.triangles, some_shell).share) area += share;
    for (const double turn : {0.0, 0.4}) {
        for (std::size_t n = 0; n < set.size(); ++n) {
            const Vec& at = set.position[n];
            const double slide = 1e-5 * at[2];
            body.positions()[n] = {{at[0] + slide * std::cos(turn), at[1] + slide * std::sin(turn), at[2]}};
        }
        EXPECT_NEAR(body.energy() / (area * some_shell.shear_stiffness() * 1e-10 / 2), 1, 2e-3);
    }
}

TEST(ShellLattice, refuses_surfaces_that_are_none) {
    const std::vector<Vec> points{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0), Vec(1, 1, 0), Vec(2, 0, 0)};
    const auto refused = [&](const std::vector<std::array<int, 3>>& triangles) {
        return text_thrown<InputError>([&] { (void)shell_lattice(points, triangles, some_shell); });
    };
    EXPECT_EQ(refused({{0, 1, 2}, {1, 2, 3}}),
              "the edge from point 1 to point 2 belongs to more than two triangles, or to two that are not oriented "
              "alike\n  give a surface that does not branch, all triangles seen from one side");
    EXPECT_EQ(refused({{0, 1, 4}}), "triangle 0 has no area\n  give it three corners off one line");
    EXPECT_EQ(refused({{0, 1, 2}, {2, 1, 3}}), "point 4 belongs to no triangle\n  leave it out");
    EXPECT_EQ(text_thrown<InputError>([] { (void)shell_constants(10, 1e-3, 0.1, 0.06); }).substr(0, 70),
              "two layers 60 mm apart of a membrane stiffness of 10 N/m bend with 0.0");
}

TEST(SpringBodiesInSpace, run_as_a_scene_with_the_same_bits_on_any_number_of_threads) {
    // A cube and a shell above it, both bulged and free.
    ParticleSet set = set_of(cell_lattice(block(3, 2, 2, 0.1), cell_constants(1e6, 0.1, 0.1)));
    append(set, hexagonal_shell(2, shell_constants(1e4, 50, edge, 0.06)), Vec(0.1, 0.1, 0.6), 0, 1);
    for (Bond& bond : set.bonds) bond.rest_length *= 1 + 0.02 * std::sin(bond.a);
    set.volume.assign(set.size(), 1e-3);
    set.mass.assign(set.size(), 1);
    set.spacing = 0.1;
    set.box = {Vec::Constant(-2), Vec::Constant(2)};
    Scene scene;
    scene.dimension = 3;
    scene.particles.spacing = 0.1;
    scene.parts = {part_with(0.01)};
    scene.flow.largest_speed = 1.0;
    scene.run.duration = 0.1;
    scene.output.every = 0.1;
    scene.contact.strength = 1e-2;
    for (const SpringStepping stepping : {SpringStepping::implicit, SpringStepping::subcycled}) {
        scene.numerics.spring_stepping = stepping;
        std::string hash;
        for (const int threads : {1, 2}) {
            Simulation simulation(scene, set, threads);
            const RunSummary summary = simulation.run({});
            EXPECT_GT(summary.steps, 5);
            for (const double momentum : summary.end.momentum) EXPECT_NEAR(momentum, 0, 1e-10);
            if (hash.empty()) hash = summary.state_hash;
            EXPECT_EQ(summary.state_hash, hash);
        }
    }
}

}  // namespace
}  // namespace dmp::tests::solver_shell_lattices_tests
