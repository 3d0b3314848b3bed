// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Keys and values of version 0.1 that have new names. Until version 0.3 the error message gives the new name.
#include "scene/renamed.hpp"

#include <array>
#include <string_view>

namespace dmp::scene {

namespace {

struct Renamed {
    std::string_view before, now;
};

constexpr std::array keys{
    Renamed{"accuracy", "this table is now called [numerics]"},
    Renamed{"run.until_still", "this key is now called until_steady"},
    Renamed{"moving_shape.*.place", "this key is now called position"},
    Renamed{"contact_pair.*.rolling_law", "this key is now called rolling"},
    Renamed{"contact_pair.*.law",
            "write normal and tangential instead: \"hertz_mindlin\" is the default of both, \"hertz_history\" is "
            "tangential = \"mindlin_unscaled\", \"thesis_eq_7_5\" is normal_stiffness_factor = 3 and "
            "tangential_stiffness_factor = 2, \"none\" is enabled = false"},
};

/// `key` is the last part of the key's path.
struct RenamedValue {
    std::string_view key, before, now;
};

constexpr std::array values{
    RenamedValue{"kind", "springs", "this kind is now called \"elastic\""},
    RenamedValue{"adhesion", "jkr", "JKR's law is now a normal law: write normal = \"jkr\" and leave adhesion out"},
};

}  // namespace

std::string advice_for_renamed_key(const std::string& pattern) {
    constexpr std::string_view old_table = "accuracy.";
    if (pattern.starts_with(old_table)) return "write numerics." + pattern.substr(old_table.size());
    for (const Renamed& key : keys)
        if (key.before == pattern) return std::string(key.now);
    return {};
}

std::string advice_for_renamed_value(const std::string& path, const std::string& value) {
    const std::string name = path.substr(path.rfind('.') + 1);
    for (const RenamedValue& renamed : values)
        if (renamed.key == name && renamed.before == value) return std::string(renamed.now);
    return {};
}

}  // namespace dmp::scene
