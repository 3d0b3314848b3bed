// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Elastic bodies of cells in 2-D at rest under loads, against closed forms and finer grids.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/cell_bodies.hpp"
#include "tests/unit/solver/lattice_solids.hpp"

namespace dmp::tests::solver_cell_bodies_tests {
namespace {

using namespace cell_bodies;

constexpr double pi = std::numbers::pi;

enum class Load { at_end, weight };

double deflection(int across, double nu, Load load) {
    const Material material{1, nu};
    CellBody<2> body = cantilever(across, 10, material);
    const auto forces = load == Load::at_end
                            ? on_end<2>(body, 10, 1, 1.0 / across, [](const Vec&) { return Vec(0, 1e-5, 0); })
                            : on_nodes<2>(body, [](const Vec&, double mass) { return Vec(0, 1e-6 * mass, 0); });
    respond(body, forces);
    return tip(body, 10)[1];
}

/// A Poisson ratio, and by how much a clamp shortens a beam [spacings]: stress is singular at its corners, where it
/// keeps the solid from contracting sideways, the more so the larger the ratio.
struct Clamped {
    double nu, shortens;
};
void PrintTo(const Clamped& clamped, std::ostream* out) { *out << "nu " << clamped.nu; }

class Cantilever : public ::testing::TestWithParam<Clamped> {};

TEST_P(Cantilever, bends_as_on_a_fine_grid_with_any_number_across) {
    const auto [nu, shortens] = GetParam();
    for (const Load load : {Load::at_end, Load::weight}) {
        const double fine = deflection(32, nu, load);
        for (const int across : {2, 4, 8}) {
            const double power = load == Load::at_end ? 3 : 4, by_clamp = power * shortens / (10 * across);
            EXPECT_NEAR(deflection(across, nu, load) / fine, 1, std::max(0.01, by_clamp)) << across << " across";
        }
    }
}

/// How far the ends of a free beam of length 20 move from its middle, from which they are pulled away by 1e-5 N each.
double rise_of_ends(int across, double nu) {
    const double a = 1.0 / across;
    CellBody<2> body = body_of<2>(block(lattice(2, a), {20 * across, across, 1}), {1, nu});
    auto forces = on_end<2>(body, 10, 1, a, [](const Vec&) { return Vec(0, -2e-5, 0); });
    for (const double end : {0, 20}) {
        const auto there = on_end<2>(body, end, 1, a, [](const Vec&) { return Vec(0, 1e-5, 0); });
        for (std::size_t n = 0; n < forces.size(); ++n) forces[n] += there[n];
    }
    respond(body, forces);
    return tip(body, 20)[1] - tip(body, 10)[1];
}

TEST_P(Cantilever, is_exact_where_symmetry_holds_it) {
    const double nu = GetParam().nu;
    const Material material{1, nu};
    const double exact = 1e-5 * (1000 / (3 * material.held_modulus() / 12) + 10 / (5.0 / 6 * material.constants().mu));
    for (const int across : {2, 4, 8}) {
        EXPECT_NEAR(rise_of_ends(across, nu) / exact, 1, 0.01) << across << " across";
    }
}
INSTANTIATE_TEST_SUITE_P(PoissonRatios, Cantilever,
                         ::testing::Values(Clamped{0.25, 0.02}, Clamped{0.4, 0.065}, Clamped{0.49, 0.15}));

/// A rectangle from (0, -thickness/2) to (length, thickness/2) in its own axes, which are turned by this angle.
Region turned_bar(double length, double thickness, double angle) {
    const Vec along(std::cos(angle), std::sin(angle), 0), up(-along[1], along[0], 0);
    const double half = thickness / 2;
    return {"beam", {{{-half * up, length * along - half * up, length * along + half * up, half * up}, true}}};
}

/// EI over exact of a beam 1 m thick, 10 m long, turned by this angle against a lattice shifted by this part of its
/// spacing: from the curvature of its middle half under couples that act in the last 1.5 m of both ends.
double bending_of_turned_beam(int across, double angle, const Vec& shift) {
    const double a = 1.0 / across, length = 10;
    const Region region = turned_bar(length, 1, angle);
    const BoxLattice boxes = lattice(2, a, -a * shift);
    const Material material;
    CellBody<2> body = body_of<2>(RegionOnBoxes(region, boxes).cells(), material);
    const Vec along(std::cos(angle), std::sin(angle), 0), up(-along[1], along[0], 0);

    // Forces along the beam, linear across it; what a cut end has of a resultant is taken out.
    std::array<double, 2> volume{}, mean{}, moment{};
    const auto end_of = [&](const Vec& at) {
        const double s = at.dot(along);
        return s < 1.5 ? 0 : s > length - 1.5 ? 1 : -1;
    };
    for (std::size_t p = 0; p < body.nodes(); ++p)
        if (const int end = end_of(body.rest_position(p)); end >= 0) {
            const double v = body.network().cells()[p].element.volume;
            volume[end] += v;
            mean[end] += v * up.dot(body.rest_position(p));
        }
    for (int end = 0; end < 2; ++end) mean[end] /= volume[end];
    for (std::size_t p = 0; p < body.nodes(); ++p)
        if (const int end = end_of(body.rest_position(p)); end >= 0) {
            const double y = up.dot(body.rest_position(p));
            moment[end] += body.network().cells()[p].element.volume * (y - mean[end]) * y;
        }
    const double couple = 1e-5;
    respond(body, on_particles<2>(body, [&](const Vec& at, double v) -> Vec {
                const int end = end_of(at);
                if (end < 0) return Vec::Zero();
                return (end == 0 ? couple : -couple) / moment[end] * v * (up.dot(at) - mean[end]) * along;
            }));

    std::vector<Vec> places, moved;
    for (std::size_t p = 0; p < body.nodes(); ++p) {
        const Vec at = body.rest_position(p), by = body.displacement(p);
        if (std::abs(at.dot(along) - length / 2) > length / 4) continue;
        places.emplace_back(at.dot(along) - length / 2, at.dot(up), 0);
        moved.emplace_back(by.dot(along), by.dot(up), 0);
    }
    const double curvature = lattice_solids::fit(places, moved, 1, lattice_solids::quadratic)[3];
    return couple / curvature / (material.held_modulus() / 12);
}

TEST(BeamAcrossItsLattice, bends_as_a_beam_along_it) {
    std::mt19937_64 generator{3};
    std::uniform_real_distribution<double> part(0, 1);
    for (const auto& [across, bound] : {std::pair{4, 0.015}, std::pair{8, 0.01}}) {
        for (int n = 0; n < 6; ++n) {
            const Vec shift(part(generator), part(generator), 0);
            const double ei = bending_of_turned_beam(across, pi / 9, shift);
            EXPECT_NEAR(ei, 1, bound) << across << " across, shift " << shift.transpose();
        }
    }
    EXPECT_NEAR(bending_of_turned_beam(4, 0, Vec(0.5, 0.5, 0)), 1, 1e-3);
}

/// Changes of the diameters of a ring along and across a pull of 1 N on it at two ends of a diameter, which is spread
/// over the section there. Curved bar of Winkler and Bach with shear (Timoshenko 1955, chapter 12), by Castigliano, on
/// a quarter: theta from the diameter across the pull, N = cos/2, V = sin/2, M = M_0 - R (1 - cos) / 2.
std::array<double, 2> pulled_ring(double radius, double thickness, const Material& material) {
    const double e = material.held_modulus(), g = 5.0 / 6 * material.constants().mu;
    const double eccentricity =
        radius - thickness / std::log((radius + thickness / 2) / (radius - thickness / 2));  // of the neutral line
    const double at_side = radius / 2 * (1 - 2 / pi) + eccentricity / pi;  // M_0, from no rotation there
    const int steps = 2000;
    std::array<double, 2> change{};
    for (int n = 0; n < steps; ++n) {
        const double theta = (n + 0.5) * pi / 2 / steps, c = std::cos(theta), s = std::sin(theta);
        const double tension = c / 2, shear = s / 2, moment = at_side - radius * (1 - c) / 2;
        // Of unit forces on the ends of the diameter along the pull and of that across it.
        for (const auto& [which, t, v, m] :
             {std::tuple{0, c / 2, s / 2, -radius * (1 - c) / 2}, std::tuple{1, s / 2, -c / 2, radius * s / 2}})
            change[which] += 4 * (pi / 2 / steps) / thickness *
                             (moment * m / (e * eccentricity) + radius * tension * t / e -
                              (moment * t + m * tension) / e + radius * shear * v / g);
    }
    return change;
}

Polyline circle(double radius, int points) {
    Polyline line;
    line.closed = true;
    for (int n = 0; n < points; ++n)
        line.points.emplace_back(radius * std::cos(2 * pi * n / points), radius * std::sin(2 * pi * n / points), 0);
    return line;
}

std::array<double, 2> ring_over_exact(int across, const Vec& shift) {
    const double a = 1.0 / across, radius = 5, pull = 1e-5;
    Region ring{"beam", {circle(radius + 0.5, 2000), circle(radius - 0.5, 2000)}};
    std::ranges::reverse(ring.loops[1].points);
    const BoxLattice boxes = lattice(2, a, a * shift);
    const Material material;
    CellBody<2> body = body_of<2>(RegionOnBoxes(ring, boxes).cells(), material);
    /// Number of the place: where the ring is pulled at 0 and 1, where it is held apart at 2 and 3.
    const auto place_of = [&](const Vec& at) {
        const int axis = std::abs(at[0]) < 0.25 ? 1 : std::abs(at[1]) < 0.25 ? 0 : -1;
        return axis < 0 ? -1 : 2 * (1 - axis) + (at[axis] > 0 ? 1 : 0);
    };
    std::array<double, 4> volume{}, first{}, second{};  // moments about the line of the pull
    for (std::size_t p = 0; p < body.nodes(); ++p)
        if (const int place = place_of(body.rest_position(p)); place >= 0) {
            const double v = body.network().cells()[p].element.volume, x = body.rest_position(p)[0];
            volume[place] += v;
            first[place] += v * x;
            second[place] += v * x * x;
        }
    respond(body, on_particles<2>(body, [&](const Vec& at, double v) -> Vec {
                const int place = place_of(at);
                if (place != 0 && place != 1) return Vec::Zero();
                const double whole = volume[place] * second[place] - first[place] * first[place];
                return (place == 1 ? pull : -pull) * v * (second[place] - first[place] * at[0]) / whole * Vec::UnitY();
            }));
    std::array<Vec, 4> moved{Vec::Zero(), Vec::Zero(), Vec::Zero(), Vec::Zero()};
    for (std::size_t p = 0; p < body.nodes(); ++p)
        if (const int place = place_of(body.rest_position(p)); place >= 0)
            moved[place] += body.network().cells()[p].element.volume / volume[place] * body.displacement(p);
    const auto exact = pulled_ring(radius, 1, material);
    return {(moved[1] - moved[0])[1] / (pull * exact[0]), (moved[3] - moved[2])[0] / (pull * exact[1])};
}

TEST(Ring, changes_its_diameter_as_a_thick_ring_does) {
    std::mt19937_64 generator{5};
    std::uniform_real_distribution<double> part(0, 1);
    for (const auto& [across, bound] : {std::pair{4, 0.02}, std::pair{8, 0.01}}) {
        for (int n = 0; n < 4; ++n) {
            const Vec shift(part(generator), part(generator), 0);
            const auto [along, side] = ring_over_exact(across, shift);
            EXPECT_NEAR(along, 1, bound) << across << " across, shift " << shift.transpose();
            EXPECT_NEAR(side, 1, bound) << across << " across, shift " << shift.transpose();
        }
    }
}

/// A shape without symmetries and with a hole.
Region some_shape() {
    Polyline outline{{{0, 0, 0}, {3.1, 0.4, 0}, {3.7, 2.2, 0}, {1.6, 3.3, 0}, {-0.4, 1.9, 0}}, true};
    Polyline hole = circle(0.6, 40);
    for (Vec& point : hole.points) point += Vec(1.8, 1.5, 0);
    std::ranges::reverse(hole.points);
    return {"beam", {outline, hole}};
}

TEST(CutBody, has_the_energy_of_an_affine_motion_and_forces_on_its_surface_alone) {
    std::mt19937_64 generator{7};
    std::uniform_real_distribution<double> part(0, 1);
    for (std::size_t law = 0; law < ElasticLaws::size; ++law)
        for (int n = 0; n < 5; ++n) {
            const double a = 0.25;
            const BoxLattice boxes = lattice(2, a, a * Vec(part(generator), part(generator), 0));
            const Region region = some_shape();
            const SolidCells solid = RegionOnBoxes(region, boxes).cells();
            const Material material{10, 0.3, 1, ElasticLaw(law)};
            CellBody<2> body = body_of<2>(solid, material);
            EXPECT_NEAR(solid.volume(), region.area(), 1e-12);
            EXPECT_GT(solid.merged, 0U);

            Eigen::Matrix2d f;
            f << 1.1, 0.25, -0.3, 0.85;
            auto& network = body.network();
            for (auto& at : network.positions()) {
                const Eigen::Vector2d moved = f * Eigen::Vector2d(at[0], at[1]);
                at = {moved[0], moved[1]};
            }
            const Eigen::Matrix2d c = f.transpose() * f;
            const auto of_law = [&](const auto& use) {
                return material.law.visit([&]<class Law>() { return use(Law{material.constants()}); });
            };
            const double density = of_law([&](const auto& each) { return each.template energy<2>(c); });
            const Eigen::Matrix2d stress = of_law([&](const auto& each) { return each.template stress<2>(c); });
            EXPECT_NEAR(body.energy() / (region.area() * density), 1, 1e-12);

            std::vector<int> full(network.nodes(), 0);  // cells around a node
            for (const auto& cell : network.cells())
                if (cell.element.volume > (1 - 1e-9) * a * a && cell.element.volume < (1 + 1e-9) * a * a)
                    for (const int node : cell.node) ++full[node];
            const auto forces = network.forces(network.positions(), Vectors<2>(network.nodes()));
            std::size_t inner = 0;
            Eigen::Matrix2d virial = Eigen::Matrix2d::Zero();
            for (std::size_t k = 0; k < network.nodes(); ++k) {
                const Eigen::Vector2d force(forces[k][0], forces[k][1]);
                virial += force * network.rest_position(k).head<2>().transpose();
                if (full[k] < 4) continue;
                ++inner;
                EXPECT_LT(force.norm(), 1e-13 * material.youngs_modulus * a);
            }
            EXPECT_GT(inner, 30U);
            // SUM f (x) X = -V P: the forces on the surface are those of the stress.
            EXPECT_LT((virial + region.area() * f * stress).norm(), 1e-12 * stress.norm() * region.area());
        }
}

}  // namespace
}  // namespace dmp::tests::solver_cell_bodies_tests
