// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/particle_set.hpp"

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests {
namespace {

TEST(ParticleSet, CountsByKindOverAllPartsOfIt) {
    ParticleSet set;
    EXPECT_EQ(set.size(), 0U);
    EXPECT_EQ(set.count(ParticleKind::fluid), 0U);
    set.parts = {{"blood", ParticleKind::fluid}, {"wall", ParticleKind::rigid}, {"water", ParticleKind::fluid}};
    set.part = {0, 2, 1, 2, 0, 0};
    set.position.resize(6, Vec::Zero());
    EXPECT_EQ(set.size(), 6U);
    EXPECT_EQ(set.count(ParticleKind::fluid), 5U);
    EXPECT_EQ(set.count(ParticleKind::rigid), 1U);
    EXPECT_EQ(set.count(ParticleKind::springs), 0U);
    EXPECT_EQ(set.kind(2), ParticleKind::rigid);
    EXPECT_EQ(set.kind(3), ParticleKind::fluid);
}

}  // namespace
}  // namespace dmp::tests
