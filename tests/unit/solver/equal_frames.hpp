// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "solver/results/frame.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

inline void expect_same_bits(const std::vector<float>& read, const std::vector<float>& written) {
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t n = 0; n < read.size(); ++n)
        ASSERT_EQ(std::bit_cast<std::uint32_t>(read[n]), std::bit_cast<std::uint32_t>(written[n])) << n;
}

inline void expect_equal(const std::vector<FrameField>& read, const std::vector<FrameField>& written) {
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t n = 0; n < read.size(); ++n) {
        EXPECT_EQ(read[n].name, written[n].name);
        EXPECT_EQ(read[n].unit, written[n].unit);
        EXPECT_EQ(read[n].components, written[n].components);
        expect_same_bits(read[n].values, written[n].values);
    }
}

inline void expect_equal(const Frame& read, const Frame& written) {
    EXPECT_EQ(read.time, written.time);
    EXPECT_EQ(read.step, written.step);
    EXPECT_EQ(read.spacing, written.spacing);
    EXPECT_EQ(read.parts, written.parts);
    ASSERT_EQ(read.groups.size(), written.groups.size());
    for (std::size_t n = 0; n < read.groups.size(); ++n) {
        const FrameGroup& one = read.groups[n];
        const FrameGroup& other = written.groups[n];
        EXPECT_EQ(one.name, other.name);
        EXPECT_EQ(one.id, other.id);
        EXPECT_EQ(one.part, other.part);
        EXPECT_EQ(one.bond_ends, other.bond_ends);
        expect_same_bits(one.position, other.position);
        expect_equal(one.fields, other.fields);
        expect_equal(one.bond_fields, other.bond_fields);
    }
}

}  // namespace dmp::tests
