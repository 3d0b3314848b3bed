// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// cases/verification/plate_in_water: a periodic plate of cells swings with the liquid on both of its sides.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::plate_in_water_tests {
namespace {

constexpr double length = 20e-3, thickness = 1e-3, height = 10e-3, youngs_modulus = 1e6, poisson_ratio = 0.3;
constexpr double wave = 2 * std::numbers::pi / length;  // k [1/m]

/// Of the wave, from the plate's bending and shear, its mass and rotary inertia, and the liquid's added mass on both
/// sides, rho / (k tanh(k H)) each [Hz].
double frequency(double density_of_plate, double density_of_liquid) {
    const double bending = youngs_modulus / (1 - poisson_ratio * poisson_ratio) * std::pow(thickness, 3) / 12;
    const double shear = 5.0 / 6 * youngs_modulus / (2 * (1 + poisson_ratio)) * thickness;
    const double stiffness = bending / (1 + wave * wave * bending / shear) * std::pow(wave, 4);
    const double mass = density_of_plate * (thickness + std::pow(thickness, 3) / 12 * wave * wave);
    const double added = 2 * density_of_liquid / (wave * std::tanh(wave * height));
    return std::sqrt(stiffness / (mass + added)) / (2 * std::numbers::pi);
}

/// From where the crest crosses its rest upwards, after the push.
double measured_frequency(const MeasureSeries& series) {
    const std::vector<double> crest = column(series, "crest_y");
    std::vector<double> crossings;
    for (std::size_t k = 1; k < crest.size(); ++k)
        if (series.time[k - 1] > 0.02 && crest[k - 1] < 0 && crest[k] >= 0)
            crossings.push_back(series.time[k] -
                                crest[k] * (series.time[k] - series.time[k - 1]) / (crest[k] - crest[k - 1]));
    EXPECT_GE(crossings.size(), 4U);
    return static_cast<double>(crossings.size() - 1) / (crossings.back() - crossings.front());
}

void expect_frequency(const std::string& setting, double density, int across, double bound) {
    const double spacing = thickness / across;
    const RunSummary run =
        run_case("verification/plate_in_water",
                 {set_to("particles.spacing", spacing, "m"), set_to("part.plate.density", density, "kg/m^3"),
                  set_to("measure.crest.point", {spacing / 2, spacing / 2, 0}, "m")},
                 0.12);
    Record(std::string("plate_in_water"), setting, run)
        .percent("frequency", measured_frequency(run.measures) / frequency(density, 1000) - 1, bound);
}

TEST(PlateInWater, SwingsWithTheLiquidsAddedMass) {
    expect_frequency("2 across", 2000, 2, 0.02);
    expect_frequency("4 across", 2000, 4, 0.01);
    expect_frequency("4 across, as dense as the liquid", 1000, 4, 0.01);
    expect_frequency("4 across, 8 times as dense", 8000, 4, 0.01);
}

}  // namespace
}  // namespace dmp::tests::plate_in_water_tests
