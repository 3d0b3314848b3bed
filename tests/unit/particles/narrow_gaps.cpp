// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/narrow_gaps.hpp"

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::narrow_gaps_tests {
namespace {

/// A channel along x, 10 spacings long and periodic, of `across` rows of water between three rows of wall each.
ParticleSet channel(int across, double spacing = 0.1) {
    ParticleSet set;
    set.spacing = spacing;
    set.box = {Vec(0, -3 * spacing, 0), Vec(10 * spacing, (across + 3) * spacing, 0)};
    set.periodic = {true, false, false};
    set.parts = {{"water", PartKind::fluid}, {"wall", PartKind::rigid}};
    for (int row = -3; row < across + 3; ++row)
        for (int column = 0; column < 10; ++column) {
            set.position.emplace_back(spacing * (column + 0.5), spacing * (row + 0.5), 0);
            set.part.push_back(row >= 0 && row < across ? 0 : 1);
        }
    return set;
}

TEST(NarrowGaps, HoldAsManyParticlesAcrossAsAreCounted) {
    for (const double spacing : {1e-9, 0.1, 1e3})
        for (const int across : {1, 2, 3}) {
            const NarrowGaps found = find_narrow_gaps(channel(across, spacing), 4);
            EXPECT_EQ(found.fluid, 10U * across);
            EXPECT_EQ(found.inside, found.fluid);
            EXPECT_EQ(found.fewest, across);
        }
}

TEST(NarrowGaps, AreNotSeenInWideOnes) {
    const NarrowGaps found = find_narrow_gaps(channel(4), 4);
    EXPECT_EQ(found.fluid, 40U);
    EXPECT_EQ(found.inside, 0U);
    EXPECT_EQ(find_narrow_gaps(channel(4), 5).inside, 40U);
}

TEST(NarrowGaps, OfOneThirdOfAChannelCountForAThird) {
    ParticleSet set = channel(9);
    for (std::size_t i = 0; i < set.size(); ++i)  // a plate in it, below which two rows are left
        if (set.position[i][1] > 0.2 && set.position[i][1] < 0.4) set.part[i] = 1;
    const NarrowGaps found = find_narrow_gaps(set, 4);
    EXPECT_EQ(found.fluid, 70U);
    EXPECT_EQ(found.inside, 20U);
    EXPECT_EQ(found.fewest, 2);
    EXPECT_LT(found.place[1], 0.2);
}

TEST(NarrowGaps, AreNoCorners) {
    ParticleSet set = channel(8);
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.position[i][0] < 0.2 || set.position[i][1] < 0.2) set.part[i] = 1;  // walls on two sides of a corner
    EXPECT_EQ(find_narrow_gaps(set, 4).inside, 0U);
}

TEST(NarrowGaps, NeedSolids) {
    ParticleSet set = channel(3);
    for (int& part : set.part) part = 0;
    EXPECT_EQ(find_narrow_gaps(set, 4).inside, 0U);
    EXPECT_EQ(find_narrow_gaps(ParticleSet(), 4).fluid, 0U);
}

}  // namespace
}  // namespace dmp::tests::narrow_gaps_tests
