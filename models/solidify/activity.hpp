// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "base/enum_names.hpp"

namespace dmp::models {

enum class SeedActivity { always, once, one_in };

/// When a seed searches for fluid to solidify: in every event, in its first event only, or in its first and every
/// N-th event after it. Seeds that are always active form round aggregates, those active once form threads.
struct Activity {
    SeedActivity kind = SeedActivity::always;
    std::int64_t one_in = 1;  ///< N

    /// `age`: events since the one in which the seed could first act; negative: not yet a seed.
    [[nodiscard]] bool acts_at(std::int64_t age) const {
        if (age < 0) return false;
        switch (kind) {
            case SeedActivity::once:
                return age == 0;
            case SeedActivity::one_in:
                return age % one_in == 0;
            case SeedActivity::always:
                break;
        }
        return true;
    }
};

}  // namespace dmp::models

namespace dmp {

template <>
inline constexpr auto enum_names<models::SeedActivity> = std::to_array<std::string_view>({"always", "once", "one_in"});

}  // namespace dmp
