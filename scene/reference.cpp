// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "base/nearest_name.hpp"
#include "scene/read_scene.hpp"
#include "scene/schema.hpp"

namespace dmp::scene {

namespace {

std::string shown_value(const std::string& text) {
    const TomlNode value = parse_toml_value(text, {});
    if (!value.is_array()) return value.is_table() ? text : value.shown();
    std::string list = text;
    std::replace(list.begin(), list.end(), '\'', '"');
    return list;
}

std::string shown_levels(const ByQuality& levels) {
    if (!levels.differ()) return shown_value(levels.standard);
    return shown_value(levels.standard) + " (draft: " + shown_value(levels.draft) +
           ", fine: " + shown_value(levels.fine) + ")";
}

std::string shown_default(const KeyFacts& key) {
    switch (key.fallback.presence) {
        case Default::Presence::required:
            return "required";
        case Default::Presence::not_given:
            return "none";
        case Default::Presence::value:
        case Default::Presence::unwritten:
            break;
    }
    const auto& [corrected, plain] = key.fallback.values;
    if (!key.fallback.depends_on_scheme()) return shown_levels(corrected);
    return shown_levels(corrected) + "; scheme = \"plain\": " + shown_levels(plain);
}

/// "for fluid parts", "for flux measures"; empty for a key of every kind.
std::string shown_kinds(const KeyFacts& key) {
    if (key.kinds.empty()) return "";
    std::string text = "for ";
    for (std::size_t k = 0; k < key.kinds.size(); ++k)
        text += key.kinds[k] + (k + 2 < key.kinds.size() ? ", " : k + 2 == key.kinds.size() ? " and " : " ");
    return text + key.path.substr(0, key.path.find('.')) + "s";
}

std::string explained(const KeyFacts& key) {
    std::string text = key.path + "\n    " + key.meaning + "\n    type:    " + key.type + "\n    default: ";
    text += key.fallback.presence == required ? "none, it must be given" : shown_default(key);
    if (!key.kinds.empty()) text += "\n    only " + shown_kinds(key);
    return text + "\n";
}

/// Escapes '|', which would end the cell of a Markdown table.
std::string cell(std::string text) {
    for (std::size_t bar = text.find('|'); bar != std::string::npos; bar = text.find('|', bar + 2)) {
        text.insert(bar, "\\");
    }
    return text;
}

}  // namespace

std::string explain_key(const std::string& key) {
    const std::string pattern = key_pattern(key);
    std::string text;
    for (const auto& facts : schema().facts()) {
        const std::string section = facts.section();
        const bool whole_section = !section.empty() && (section == key || section == key + ".*");
        if (facts.path == pattern || whole_section) text += (text.empty() ? "" : "\n") + explained(facts);
    }
    if (text.empty()) {
        const auto nearest = nearest_key(pattern);
        throw InputError("unknown key '" + key + "'",
                         nearest.empty() ? advice_for_unknown_key(pattern) : "did you mean '" + nearest + "'?");
    }
    return text;
}

std::string scene_reference() {
    return scene_reference([](const KeyFacts& /*key*/) { return true; });
}

std::string scene_reference(const std::function<bool(const KeyFacts&)>& wanted) {
    std::string text = "| key | type | default | meaning |\n|---|---|---|---|\n";
    for (const auto& key : schema().facts()) {
        if (!wanted(key)) continue;
        const std::string kinds = shown_kinds(key);
        text += "| `" + key.path + "` | " + cell(key.type) + " | " + cell(shown_default(key)) + " | " +
                cell(key.meaning) + (kinds.empty() ? "" : " Only " + kinds + ".") + " |\n";
    }
    return text;
}

}  // namespace dmp::scene
