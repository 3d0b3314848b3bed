// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Shells and solids in 3-D: the stress of their nodes, and contact of a body with itself.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/bodies_in_space.hpp"

namespace dmp::tests::solver_springs_in_space_tests {
namespace {

using namespace lattice_solids;

using Tensor = std::array<double, 6>;  // xx, yy, zz, xy, yz, xz

Tensor sum_of(const std::vector<Tensor>& values) {
    Tensor sum{};
    for (const Tensor& each : values)
        for (std::size_t c = 0; c < 6; ++c) sum[c] += each[c];
    return sum;
}

/// A body whose nodes are moved by u(x).
template <class Displacement>
Body moved(const ParticleSet& set, const Displacement& displacement) {
    Body body(set, part_with(0), 0);
    for (std::size_t n = 0; n < set.size(); ++n) {
        const Vec at = set.position[n] + displacement(set.position[n]);
        body.positions()[n] = {{at[0], at[1], at[2]}};
    }
    return body;
}

TEST(VirialStressInSpace, of_a_solid_in_uniform_strain_is_that_of_its_material) {
    constexpr double spacing = 0.1, modulus = 1e6, strain = 1e-6;
    for (const double nu : {0.1, 0.25}) {
        const ParticleSet set = set_of(cell_lattice(block(4, 4, 4, spacing), cell_constants(modulus, nu, spacing)));
        const std::size_t middle = set.size() / 2;
        const double mu = modulus / (2 * (1 + nu)), lambda = 2 * mu * nu / (1 - 2 * nu);
        const auto stress = [&](const Body& body) {
            Tensor of_middle = body.virial()[middle];
            for (double& each : of_middle) each /= -std::pow(spacing, 3) * strain;
            return of_middle;
        };
        const Tensor stretched = stress(moved(set, [](const Vec& x) { return Vec(strain * x[0], 0, 0); }));
        const Tensor of_stretch{lambda + 2 * mu, lambda, lambda, 0, 0, 0};
        const Tensor sheared = stress(moved(set, [](const Vec& x) { return Vec(0, strain * x[2], 0); }));
        const Tensor of_shear{0, 0, 0, 0, mu, 0};
        for (std::size_t c = 0; c < 6; ++c) {
            EXPECT_NEAR(stretched[c], of_stretch[c], 1e-4 * modulus) << c << ", nu = " << nu;
            EXPECT_NEAR(sheared[c], of_shear[c], 1e-4 * modulus) << c << ", nu = " << nu;
        }
    }
}

/// SUM F (x) x of the springs' forces on the nodes, symmetric part: what the virials of all nodes must add up to.
Tensor first_moment_of_forces(const Body& body) {
    const auto force = body.forces(body.positions(), Loads(body.positions().size(), V3{}));
    Tensor sum{};
    for (std::size_t n = 0; n < force.size(); ++n) {
        const V3 &f = force[n], &x = body.positions()[n];
        constexpr std::array<std::array<int, 2>, 6> axes{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};
        for (std::size_t c = 0; c < 6; ++c) {
            const auto [i, j] = axes[c];
            sum[c] += 0.5 * (f[i] * x[j] + f[j] * x[i]);
        }
    }
    return sum;
}

TEST(VirialStressInSpace, adds_up_to_the_moment_of_the_forces_with_hinges_and_with_dihedrals) {
    constexpr double edge = 0.1;
    const ShellConstants soft{edge, 0.06, 3, 1.5, 2, 0}, folding{edge, 0.06, 3e-6, 1.5e-6, 2e-6, 1};
    const ParticleSet solid = set_of(cell_lattice(block(3, 3, 3, edge), cell_constants(1e6, 0, edge)));
    ASSERT_GT(solid.hinges.size(), 0U);
    for (const ParticleSet& set : {solid, hexagonal_shell(3, soft), hexagonal_shell(3, folding)}) {
        const Body body = moved(set, [&](const Vec& x) {
            return Vec(0.1 * edge * Vec(std::sin(37 * x[1]), std::cos(53 * x[0]), std::sin(41 * x[0] + 29 * x[1])));
        });
        const Tensor found = sum_of(body.virial()), expected = first_moment_of_forces(body);
        double scale = 0;
        for (const double each : expected) scale = std::max(scale, std::abs(each));
        EXPECT_GT(scale, 0);
        for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(found[c], expected[c], 1e-10 * scale) << c;
    }
}

TEST(VirialStressInSpace, of_a_stretched_shell_is_its_membrane_force) {
    constexpr double edge = 0.1, strain = 1e-6;
    const ShellConstants shell{edge, 0.06, 3, 1.5, 2, 0.01};
    const Surface surface = hexagon(4, edge);
    const SpringLattice lattice = shell_lattice(surface.points, surface.triangles, shell);
    const Body body = moved(set_of(lattice), [](const Vec& x) { return Vec(strain * x[0], strain * x[1], 0); });
    double area = 0;
    for (const double share : lattice.share) area += share;
    const Tensor force = sum_of(body.virial());
    const double length2 = edge * edge + 0.06 * 0.06, node = std::sqrt(0.75) * edge * edge;
    // With the thickness held: energy of a node's column is p e^2 for each of the three directions, N = dU/de / (2 A).
    const double p = 2 * 3 * edge * edge + 2 * 2 * std::pow(edge, 4) / length2;
    EXPECT_NEAR(-force[0] / area / (3 * p / node * strain), 1, 1e-3);
    EXPECT_NEAR(-force[1] / area / (3 * p / node * strain), 1, 1e-3);
    EXPECT_NEAR(force[3] / force[0], 0, 1e-6);
}

SpringContact contact_within(double range) { return {{1e-2}, range}; }

TEST(SelfContactInSpace, repels_as_the_law_says_off_any_plane) {
    using Vectors = Body::Vectors;
    const std::vector<Vec> drawn{Vec(0, 0, 0), Vec(0, 0, 1), Vec(0, 3, 0), Vec(4, 0, 0)};
    const auto held_apart = pairs_within(drawn, 3, neighbourhood_of_contact(1, 1));
    ASSERT_EQ(held_apart.size(), 1U);
    SelfContact<3> contact(contact_within(1), held_apart);
    const Vectors now{{{0, 0, 0}}, {{0, 0, 0.4}}, {{0.3, 0.5, 0.2}}, {{4, 0, 0}}};
    Vectors force(4, V3{});
    contact.add_forces(now, force);
    const V3 by_first = Repulsion{1e-2}.law(now[2] - now[0], 1.0),
             by_second = Repulsion{1e-2}.law(now[2] - now[1], 1.0);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GT(by_first[axis], 0);
        EXPECT_DOUBLE_EQ(force[2][axis], by_first[axis] + by_second[axis]);
        EXPECT_DOUBLE_EQ(force[0][axis], -by_first[axis]) << "drawn near the second node";
        EXPECT_DOUBLE_EQ(force[1][axis], -by_second[axis]);
        EXPECT_EQ(force[3][axis], 0);
    }
}

/// Two sheets of one body, drawn six edges apart and pressed together: the upper one's smallest height over the lower.
double gap_of_pressed_sheets(const SpringContact& contact) {
    constexpr double edge = 1;
    const ShellConstants shell{edge, 0.6, 1, 1, 1, 0.1};
    ParticleSet set = hexagonal_shell(2, shell);
    const std::size_t half = set.size();
    append(set, hexagonal_shell(2, shell), Vec(0, 0, 6 * edge), 0, 0);
    Body body(set, part_with(0.2, 0.05), 0, contact);
    std::vector<Vec> load(set.size());
    for (std::size_t n = 0; n < set.size(); ++n) load[n] = Vec(0, 0, n < half ? 1e-3 : -1e-3);
    for (int step = 0; step < 3000; ++step) body.advance(load, 0.2, 0);
    double gap = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < half; ++n) gap = std::min(gap, body.positions()[half + n][2] - body.positions()[n][2]);
    return gap;
}

TEST(SelfContactInSpace, keeps_two_sheets_of_a_body_apart) {
    EXPECT_LT(gap_of_pressed_sheets({}), -2);  // they pass through each other without
    const double gap = gap_of_pressed_sheets(contact_within(1));
    EXPECT_GT(gap, 0.3);
    EXPECT_LT(gap, 2.5);  // and they do meet
}

}  // namespace
}  // namespace dmp::tests::solver_springs_in_space_tests
