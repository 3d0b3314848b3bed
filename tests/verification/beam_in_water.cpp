// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// cases/verification/beam_in_water: a clamped beam of cells under its weight, in air and in a liquid half as dense.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::beam_in_water_tests {
namespace {

constexpr double length = 10e-3, thickness = 1e-3, youngs_modulus = 1e6, poisson_ratio = 0.3, density = 2000, g = 9.81;

/// Of a clamped beam in plane strain that shears (Timoshenko 1921), under its weight in air.
double deflection(double x) {
    const double modulus = youngs_modulus / (1 - poisson_ratio * poisson_ratio);
    const double bending = modulus * std::pow(thickness, 3) / 12;
    const double shear = 5.0 / 6 * youngs_modulus / (2 * (1 + poisson_ratio)) * thickness;
    const double load = density * g * thickness;
    return load * x * x * (6 * length * length - 4 * length * x + x * x) / (24 * bending) +
           load * (length * x - x * x / 2) / shear;
}

RunSummary hang(const std::string& scene, int across, double* tip) {
    const double spacing = thickness / across;
    const RunSummary run = run_case("verification/beam_in_water/" + scene,
                                    {set_to("particles.spacing", spacing, "m"),
                                     set_to("measure.tip.point", {length - spacing / 2, spacing / 2, 0}, "m")},
                                    0.4, nullptr, 1);
    *tip = -column(run.measures, "tip_y").back();
    return run;
}

class BeamInWater : public testing::TestWithParam<int> {};

TEST_P(BeamInWater, WeighsAsMuchLessAsTheLiquidThatItDisplaces) {
    const int across = GetParam();
    double in_air = 0, in_liquid = 0;
    (void)hang("alone.toml", across, &in_air);
    const RunSummary run = hang("scene.toml", across, &in_liquid);
    Record record("beam_in_water", std::to_string(across) + " across", run);
    record.percent("deflection in the liquid over that in air, from 1/2", in_liquid / in_air / 0.5 - 1, 0.002);
    record.percent("deflection in air", in_air / deflection(length - thickness / across / 2) - 1, 0.012);
}

INSTANTIATE_TEST_SUITE_P(Cells, BeamInWater, testing::Values(2, 4));

}  // namespace
}  // namespace dmp::tests::beam_in_water_tests
