// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Names of keys: patterns, their form in messages, and suggestions for unknown ones.
#include <algorithm>
#include <utility>

#include "base/nearest_name.hpp"
#include "scene/renamed.hpp"
#include "scene/schema.hpp"

namespace dmp::scene {

namespace {

std::pair<std::string, std::string> split_at_last_dot(const std::string& path) {
    const auto dot = path.rfind('.');
    if (dot == std::string::npos) return {"", path};
    return {path.substr(0, dot), path.substr(dot + 1)};
}

std::string joined(const std::string& section, const std::string& name) {
    return section.empty() ? name : section + "." + name;
}

std::string header_of(const std::string& section) {
    if (section.empty()) return "the top of the file";
    if (section.ends_with(".*")) return "[[" + section.substr(0, section.size() - 2) + "]]";
    return "[" + section + "]";
}

std::vector<std::string> sections() {
    std::vector<std::string> names;
    for (const auto& key : schema().facts()) {
        if (std::find(names.begin(), names.end(), key.section()) == names.end()) names.push_back(key.section());
    }
    return names;
}

std::vector<std::string> names_in(const std::string& section) {
    std::vector<std::string> names;
    for (const auto& key : schema().facts()) {
        const bool known = std::find(names.begin(), names.end(), key.name()) != names.end();
        if (key.section() == section && !known) names.push_back(key.name());
    }
    return names;
}

}  // namespace

std::string KeyFacts::section() const { return split_at_last_dot(path).first; }
std::string KeyFacts::name() const { return split_at_last_dot(path).second; }
bool KeyFacts::is_for(const std::string& kind) const {
    return kinds.empty() || std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

std::string key_pattern(const std::string& path) {
    if (path.starts_with("geometry.parameters.")) return "geometry.parameters";
    for (const std::string& item : item_lists()) {
        if (path.starts_with(item + ".")) return item + ".*." + split_at_last_dot(path).second;
    }
    return path;
}

std::string nearest_key(const std::string& pattern) {
    auto [section, name] = split_at_last_dot(pattern);
    const auto known_sections = sections();
    if (std::find(known_sections.begin(), known_sections.end(), section) == known_sections.end()) {
        const auto nearest = nearest_name(section, known_sections);
        if (!nearest.empty()) section = nearest;
    }
    if (const auto nearest = nearest_name(name, names_in(section)); !nearest.empty()) return joined(section, nearest);

    // the right name in the wrong table, then a similar name in any table
    std::vector<std::string> names;
    for (const auto& other : known_sections) {
        for (const auto& candidate : names_in(other)) {
            if (candidate == name) return joined(other, candidate);
            names.push_back(candidate);
        }
    }
    const auto nearest = nearest_name(name, names);
    for (const auto& other : known_sections) {
        const auto candidates = names_in(other);
        if (!nearest.empty() && std::find(candidates.begin(), candidates.end(), nearest) != candidates.end()) {
            return joined(other, nearest);
        }
    }
    return {};
}

std::string shown_key(const std::string& pattern) {
    const auto [section, name] = split_at_last_dot(pattern);
    return "'" + name + "' " + (section.empty() ? "at " : "in ") + header_of(section);
}

std::string advice_for_unknown_key(const std::string& pattern) {
    if (std::string advice = advice_for_renamed_key(pattern); !advice.empty()) return advice;
    const auto [section, name] = split_at_last_dot(pattern);
    if (section.empty()) {  // the name of a table may be misspelt
        std::vector<std::string> tables;
        for (const auto& known : sections()) {
            if (!known.empty()) tables.push_back(known.substr(0, known.find('.')));
        }
        const auto nearest = nearest_name(name, tables);
        const bool list = std::ranges::find(item_lists(), nearest) != item_lists().end();
        if (!nearest.empty()) return "did you mean " + header_of(nearest + (list ? ".*" : "")) + "?";
    }
    if (const auto nearest = nearest_key(pattern); !nearest.empty()) return "did you mean " + shown_key(nearest) + "?";
    const auto names = names_in(section);
    if (!section.empty() && !names.empty()) return header_of(section) + " takes " + quoted_list(names);
    std::string tables;
    for (const auto& known : sections()) {
        if (!known.empty()) tables += (tables.empty() ? "" : ", ") + header_of(known);
    }
    return "a scene has " + quoted_list(names_in("")) + " and the tables " + tables;
}

}  // namespace dmp::scene
