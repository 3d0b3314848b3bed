// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/apart.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::apart_tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A periodic strip of 6 x 4 particles a tenth apart, the upper rows a wall.
ParticleSet strip() {
    ParticleSet set;
    set.spacing = 0.1;
    set.box = {Vec(0, 0, 0), Vec(0.6, 0.4, 0)};
    set.periodic = {true, false, false};
    set.parts = {{"water", PartKind::fluid}, {"wall", PartKind::rigid}};
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 6; ++column) {
            set.position.emplace_back(0.1 * column, 0.1 * (row + 0.5), 0);
            set.part.push_back(row < 2 ? 0 : 1);
        }
    return set;
}

std::string refusal(const ParticleSet& set) {
    try {
        check_apart(set);
    } catch (const InputError& error) {
        return error.problem();
    }
    return "";
}

TEST(Apart, ALatticeIsTakenInEveryCorner) { EXPECT_EQ(refusal(strip()), ""); }

TEST(Apart, TwoAtOnePlaceAreNamedWithTheirPartsAndPlace) {
    ParticleSet set = strip();
    set.position[14] = set.position[8] + Vec(0, 0.00009, 0);
    EXPECT_THAT(refusal(set), AllOf(HasSubstr("8 of 'water'"), HasSubstr("14 of 'wall'"),
                                    HasSubstr("lie on each other at (200, 15")));
    set.position[14] = set.position[8] + Vec(0, 0.00011, 0);
    EXPECT_EQ(refusal(set), "");
}

TEST(Apart, APeriodApartIsOnePlace) {
    ParticleSet set = strip();
    set.position[5] = set.position[0] + Vec(0.6 - 0.00005, 0, 0);
    EXPECT_THAT(refusal(set), AllOf(HasSubstr("0 of 'water'"), HasSubstr("5 of 'water'")));
    set.position[5] = set.position[0] + Vec(0.6, 0, 0);
    EXPECT_THAT(refusal(set), HasSubstr("lie on each other"));
}

TEST(Apart, WithoutPeriodsTheEndsAreApart) {
    ParticleSet set = strip();
    set.periodic = {};
    set.position[5] = set.position[0] + Vec(0.6, 0, 0);
    EXPECT_EQ(refusal(set), "");
}

TEST(Apart, NoPlaceAtAllIsRefused) {
    ParticleSet set = strip();
    set.position[3][1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(refusal(set), HasSubstr("particle 3 of 'water' is at no place"));
}

}  // namespace
}  // namespace dmp::tests::apart_tests
