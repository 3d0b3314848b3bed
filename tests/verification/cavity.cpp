// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/cavity.hpp"

#include "tests/modules.hpp"

namespace dmp::tests::cavity_tests {
namespace {

TEST(Cavity, StationsAreThoseOfTheTable) {
    const auto stations = stations_at(1000);
    ASSERT_EQ(stations.size(), 30U);
    EXPECT_EQ(stations.front().axis, 0);
    EXPECT_EQ(stations.front().point[1], 0.9766);
}

TEST(Cavity, AtReynolds100) {
    compare_cavity(100, "Re 100, 100 x 100",
                   {"particles.spacing=10 mm", "output.every=0.25 s", "output.fields=[\"velocity\"]"}, 25, 0.007);
}

TEST(Cavity, AtReynolds400) {
    compare_cavity(400, "Re 400, 100 x 100",
                   {"particles.spacing=10 mm", "part.liquid.viscosity=2.5 mPa*s", "output.every=0.5 s",
                    "output.fields=[\"velocity\"]"},
                   40, 0.02);
}

}  // namespace
}  // namespace dmp::tests::cavity_tests
