// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The damping ratio of a solid of cells: how a cantilever's swing dies away.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "solver/elastic/cell_body.hpp"
#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"

namespace dmp::tests::solver_cell_damping_tests {
namespace {

constexpr double length = 4, height = 0.25, density = 1000, modulus = 1e6, nu = 0.25;

/// The lowest frequency of the beam [Hz].
double lowest_frequency() {
    const double held = modulus / (1 - nu * nu), root = 1.8751040687119611 / length;
    return root * root * std::sqrt(held * height * height / (12 * density)) / (2 * std::numbers::pi);
}

/// A cantilever that starts nearly in its lowest mode.
Texts swinging(const std::string& damping) {
    return {R"(schema = 1
[geometry]
file = "channel.geo"
[particles]
spacing = "0.125 m"
[[part]]
name = "beam"
kind = "elastic"
model = "cells"
density = "1000 kg/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.25
anchor = "clamp"
initial_velocity = [0, "1e-3 m/s * (x / (4 m))^2"]
)" + damping + R"([flow]
largest_speed = "1 m/s"
[run]
duration = "1 s"
[output]
every = "1 s"
)",
            polygon({{0, 0}, {4, 0}, {4, 0.25}, {0, 0.25}}, "beam") + R"(Physical Curve("clamp") = {4};
)"};
}

struct Swing {
    double frequency = 0;  ///< [Hz]
    double ratio = 0;      ///< fraction of critical damping [-]
};

/// From the first and the last of the largest positions of the tip within eight periods.
Swing swing_of(const Texts& texts, int substeps) {
    const Meshed meshed = mesh_texts(texts);
    CellBody<2> body(initial_cells(meshed.particles, InitialSprings(meshed.particles, meshed.scene), 0, 0), "beam",
                     meshed.particles.spacing, {});
    std::size_t tip = 0;
    for (std::size_t p = 0; p < body.nodes(); ++p)
        if (body.rest_position(p)[0] > body.rest_position(tip)[0]) tip = p;
    const double period = 1 / lowest_frequency(), dt = period / 400;
    const std::vector<Vec> nothing(body.nodes(), Vec::Zero());
    std::vector<double> height_at{0, 0};
    std::vector<std::pair<double, double>> peaks;  // time, height
    for (int step = 1; step <= 3400; ++step) {
        (void)body.advance(nothing, dt, substeps);
        height_at.push_back(body.displacement(tip)[1]);
        const double before = height_at[height_at.size() - 3], at = height_at[height_at.size() - 2],
                     after = height_at.back();
        if (at <= before || at <= after) continue;
        const double off = 0.5 * (before - after) / (before - 2 * at + after);  // of the parabola through them
        peaks.emplace_back((step - 1 + off) * dt, at - 0.25 * (before - after) * off);
    }
    // The second mode has died away by the third peak.
    const double cycles = static_cast<double>(peaks.size() - 3);
    const double time = peaks.back().first - peaks[2].first;
    const double decrement = std::log(peaks[2].second / peaks.back().second) / cycles;
    return {cycles / time, decrement / std::hypot(2 * std::numbers::pi, decrement)};
}

TEST(CellDamping, of_a_ratio_is_the_logarithmic_decrement_of_a_cantilever) {
    const double frequency = lowest_frequency();
    for (const double ratio : {0.02, 0.05}) {
        const std::string damping = "damping_ratio = " + std::to_string(ratio) + "\ndamping_frequency = \"" +
                                    std::to_string(frequency) + " Hz\"\n";
        const Swing swing = swing_of(swinging(damping), 0);
        EXPECT_NEAR(swing.frequency / frequency, 1, 0.02);
        // The ratio grows with the frequency.
        const double expected = ratio * swing.frequency / frequency;
        EXPECT_NEAR(swing.ratio / expected, 1, 0.03) << ratio;
    }
}

TEST(CellDamping, limits_the_explicit_step) {
    const auto limit = [](const std::string& damping) {
        const Meshed meshed = mesh_texts(swinging(damping));
        const auto parts = initial_cells(meshed.particles, InitialSprings(meshed.particles, meshed.scene), 0, 0);
        return std::pair(CellBody<2>(parts, "beam", meshed.particles.spacing, {}).step_limit(),
                         parts.cells.front().relaxation);
    };
    const auto [free, none] = limit("bond_damping = 0\n");
    const auto [damped, relaxation] = limit("damping_ratio = 0.2\ndamping_frequency = \"0.2 Hz\"\n");
    EXPECT_EQ(none, 0);
    EXPECT_NEAR(relaxation, 1 / std::numbers::pi, 1e-12);
    const double zeta = relaxation / free;
    EXPECT_NEAR(damped, free * (std::sqrt(1 + zeta * zeta) - zeta), 1e-9 * damped);
    EXPECT_LT(damped, 0.1 * free);
}

}  // namespace
}  // namespace dmp::tests::solver_cell_damping_tests
