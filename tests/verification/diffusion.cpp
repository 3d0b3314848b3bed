// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Diffusion of species against closed forms (Crank 1975), and what is left of them after many steps.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::diffusion_tests {
namespace {

constexpr double pi = std::numbers::pi, face = 0.12, air = 20e-6;

/// Root mean square difference of a frame's concentrations from c(y), and the largest.
template <class Exact>
std::pair<double, double> errors(const Frame& frame, const Exact& exact) {
    const FrameGroup& fluid = required_group(frame, "fluid");
    const std::vector<float>& found = required_field(fluid, "concentration").values;
    double square = 0, worst = 0;
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double error = std::abs(found[k] - exact(fluid.position[3 * k + 1]));
        square += error * error / static_cast<double>(fluid.size());
        worst = std::max(worst, error);
    }
    return {std::sqrt(square), worst};
}

/// At the face: the flux D dc/dy is one on both sides, so that the values of the rows nearest to it count with their
/// diffusivities.
double at_face(const Frame& frame, double felt) {
    const FrameGroup& fluid = required_group(frame, "fluid");
    const std::vector<float>& found = required_field(fluid, "concentration").values;
    std::array<double, 2> sum{}, count{};
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double y = fluid.position[3 * k + 1] - face;
        if (std::abs(y) > 0.9e-3) continue;
        sum[y > 0 ? 1 : 0] += found[k];
        count[y > 0 ? 1 : 0] += 1;
    }
    return (felt * sum[0] / count[0] + air * sum[1] / count[1]) / (felt + air);
}

struct Jump {
    double ratio, t, rms, worst;  ///< time [s], bounds of the errors
};

class Diffusion : public testing::TestWithParam<Jump> {};

TEST_P(Diffusion, AcrossAJump) {
    const auto [ratio, t, rms_bound, worst_bound] = GetParam();
    const double felt = air / ratio;
    LastFrame last;
    const RunSummary run = run_case(
        "verification/diffusion",
        {"numerics.scheme=plain", "numerics.kernel=lucy",
         "geometry.parameters={ lower = \"120 mm\", upper = \"120 mm\", length = \"8 mm\" }",
         "species.vapour.diffusivity={ air = \"20 mm^2/s\", felt = \"" + std::to_string(20 / ratio) + " mm^2/s\" }"},
        t, &last);
    const double exact_face = std::sqrt(air) / (std::sqrt(air) + std::sqrt(felt));
    const auto [rms, worst] = errors(last.frame, [&](double height) {
        const double y = height - face;
        return y > 0 ? 1 - (1 - exact_face) * std::erfc(y / (2 * std::sqrt(air * t)))
                     : exact_face * std::erfc(-y / (2 * std::sqrt(felt * t)));
    });
    Record record("diffusion", "jump of " + std::to_string(std::lround(ratio)), run);
    const std::string when = "concentration after " + std::to_string(std::lround(t)) + " s, ";
    record.at_most(when + "root mean square error", rms, rms_bound);
    record.at_most(when + "largest error", worst, worst_bound);
    record.percent("concentration at the face", at_face(last.frame, felt) / exact_face - 1, 0.01);
    record.at_most("change of the amount, over the amount", run.species.at(0).residual(), 0);
}

INSTANTIATE_TEST_SUITE_P(Species, Diffusion,
                         testing::Values(Jump{1, 3, 6.2e-5, 2e-4}, Jump{10, 30, 6.2e-4, 3.8e-3},
                                         Jump{100, 3, 0.02, 0.15}));

/// Held at 1 below and 0 above, from 0; both layers alike, D t over the height squared.
double slab(double y, double t) {
    double c = 1 - y;
    for (int n = 1; n < 100; ++n) c -= 2 / (n * pi) * std::sin(n * pi * y) * std::exp(-n * n * pi * pi * t);
    return c;
}

const std::vector<std::string> plates{
    "geometry.parameters={ lower = \"10 mm\", upper = \"10 mm\", length = \"8 mm\" }",
    "species.vapour.diffusivity=20 mm^2/s", "species.vapour.concentration=0",
    "species.vapour.wall_concentration={ floor = \"1 mol/m^3\", lid = \"0 mol/m^3\" }"};

void expect_slab(const std::string& setting, const std::vector<std::string>& more, double bound) {
    const double height = 0.02;
    std::vector<std::string> overrides = plates;
    overrides.insert(overrides.end(), more.begin(), more.end());
    LastFrame early, late;
    (void)run_case("verification/diffusion", overrides, 1, &early);
    const RunSummary run = run_case("verification/diffusion", overrides, 20, &late);
    Record record("diffusion", setting, run);
    record.at_most("concentration at D t / h^2 = 0.05, largest error",
                   errors(early.frame, [=](double y) { return slab(y / height, air / (height * height)); }).second,
                   bound);
    record.at_most("concentration at D t / h^2 = 1, largest error",
                   errors(late.frame, [=](double y) { return slab(y / height, 20 * air / (height * height)); }).second,
                   bound);
    record.at_most("amount that came from nowhere, over the amount", run.species.at(0).residual(), 1e-14);
}

TEST(DiffusionBetweenPlates, FollowsTheSeries) { expect_slab("plates held at 1 and 0, 20 across", {}, 0.005); }

TEST(DiffusionBetweenPlates, SteppedImplicitly) {
    expect_slab(
        "plates held at 1 and 0, 20 across, implicit",
        {"numerics.species_stepping=implicit", "numerics.viscosity_stepping=implicit", "numerics.step_factor=0.3"},
        0.02);
}

TEST(Conservation, OfASpeciesStirredForManySteps) {
    const RunSummary run = run_case("verification/diffusion",
                                    {"geometry.parameters={ lower = \"5 mm\", upper = \"5 mm\", length = \"8 mm\" }",
                                     "flow.initial_velocity=[\"1 mm/s * sin(2*pi*y / 5 mm)\", "
                                     "\"1 mm/s * sin(2*pi*x / 8 mm)\"]",
                                     "flow.acceleration=[\"0.01 m/s^2 * sin(2*pi*y / 5 mm)\", 0]",
                                     "flow.largest_speed=5 mm/s", "species.vapour.diffusivity=1 mm^2/s"},
                                    2100);
    Record record("diffusion", "stirred", run);
    record.at_least("steps", static_cast<double>(run.steps), 1e5);
    record.at_most("change of the amount, over the amount", run.species.at(0).residual(), 1e-12);
}

}  // namespace
}  // namespace dmp::tests::diffusion_tests
