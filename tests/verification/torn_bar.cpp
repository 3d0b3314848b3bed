// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// cases/verification/torn_bar: a bar of cells pulled until it tears.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::torn_bar_tests {
namespace {

constexpr double width = 4e-3, youngs_modulus = 1e6, poisson_ratio = 0.3, strength = 40e3, rate = 600;

/// The force at which Cauchy's stress is the strength [N], of a bar 1 m deep of Saint Venant and Kirchhoff's solid in
/// plane strain: with the stretch l along it and m across it,
///   S = E' (l^2 - 1) / 2,   m^2 = 1 - nu / (1 - nu) (l^2 - 1),   sigma = l S / m,   F = width l S
double load_at_tearing() {
    const double modulus = youngs_modulus / (1 - poisson_ratio * poisson_ratio);
    double low = 1, high = 1.2;
    const auto along = [&](double l) { return l * modulus * (l * l - 1) / 2; };
    while (high - low > 1e-12) {
        const double l = (low + high) / 2;
        const double m = std::sqrt(1 - poisson_ratio / (1 - poisson_ratio) * (l * l - 1));
        (along(l) / m < strength ? low : high) = l;
    }
    return width * along(low);
}

class TornBar : public testing::TestWithParam<int> {};

TEST_P(TornBar, BearsItsStrengthTimesItsSectionAndIsTwoPieces) {
    const int across = GetParam();
    const RunSummary run = run_case("verification/torn_bar/scene.toml",
                                    {set_to("particles.spacing", width / across, "m")}, 0.265, nullptr, 1);
    const auto broken = column(run.measures, "bar_bonds_broken"), pieces = column(run.measures, "bar_pieces");
    const auto first = std::ranges::find_if(broken, [](double count) { return count > 0; });
    ASSERT_NE(first, broken.end()) << "it never tears";
    const double load = rate * run.measures.time[static_cast<std::size_t>(first - broken.begin())];
    Record record("torn_bar", std::to_string(across) + " across", run);
    record.percent("load at which it tears", load / load_at_tearing() - 1, 0.01);
    EXPECT_EQ(pieces.back(), 2);
    EXPECT_EQ(column(run.measures, "bar_particles").back(), column(run.measures, "bar_particles").front());
}

INSTANTIATE_TEST_SUITE_P(Cells, TornBar, testing::Values(4, 8));

}  // namespace
}  // namespace dmp::tests::torn_bar_tests
