// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/particle_set.hpp"

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::particle_set_tests {
namespace {

TEST(ParticleSet, CountsByKindOverAllPartsOfIt) {
    ParticleSet set;
    EXPECT_EQ(set.size(), 0U);
    EXPECT_EQ(set.count(PartKind::fluid), 0U);
    set.parts = {{"blood", PartKind::fluid}, {"wall", PartKind::rigid}, {"water", PartKind::fluid}};
    set.part = {0, 2, 1, 2, 0, 0};
    set.position.resize(6, Vec::Zero());
    EXPECT_EQ(set.size(), 6U);
    EXPECT_EQ(set.count(PartKind::fluid), 5U);
    EXPECT_EQ(set.count(PartKind::rigid), 1U);
    EXPECT_EQ(set.count(PartKind::elastic), 0U);
    EXPECT_EQ(set.kind(2), PartKind::rigid);
    EXPECT_EQ(set.kind(3), PartKind::fluid);
}

}  // namespace
}  // namespace dmp::tests::particle_set_tests
