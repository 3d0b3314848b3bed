// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/modules.hpp"
#include "tests/verification/cavity.hpp"

namespace dmp::tests::cavity_long_tests {
namespace {

TEST(Cavity, AtReynolds1000) {
    compare_cavity(1000, "Re 1000, 200 x 200",
                   {"particles.spacing=5 mm", "part.liquid.viscosity=1 mPa*s", "output.every=0.5 s",
                    "output.fields=[\"velocity\"]"},
                   80, 0.03);
}

}  // namespace
}  // namespace dmp::tests::cavity_long_tests
