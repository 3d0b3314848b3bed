// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/overrides.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/nearest_name.hpp"
#include "scene/schema.hpp"

namespace dmp::scene {

namespace {

std::string trimmed(const std::string& text) {
    const auto begin = text.find_first_not_of(" \t");
    if (begin == std::string::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

std::vector<std::string> split_at_dots(const std::string& path) {
    std::vector<std::string> words;
    std::size_t begin = 0;
    for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', begin)) {
        words.push_back(path.substr(begin, dot - begin));
        begin = dot + 1;
    }
    words.push_back(path.substr(begin));
    return words;
}

bool names_a_list(const std::string& word) { return std::ranges::find(item_lists(), word) != item_lists().end(); }

/// Appends one that has no more than its name.
TomlNode& new_item(TomlNode& document, const std::string& list, const std::string& name,
                   const SourceLocation& location) {
    const auto made = [&](TomlNode::Kind kind, const std::string& key) {
        TomlNode node;
        node.kind = kind;
        node.key = key;
        node.key_location = node.location = location;
        return node;
    };
    TomlNode* items = document.child(list);
    if (items == nullptr) items = &document.children.emplace_back(made(TomlNode::Kind::array, list));
    TomlNode& item = items->children.emplace_back(made(TomlNode::Kind::table, ""));
    TomlNode& its_name = item.children.emplace_back(parse_toml_value(toml_quoted(name), location));
    its_name.key = "name";
    return item;
}

TomlNode& find_item(TomlNode& document, const std::string& list, const std::string& name, const std::string& key,
                    const SourceLocation& location) {
    std::vector<std::string> names;
    if (TomlNode* items = document.child(list); items != nullptr && items->is_array()) {
        for (auto& item : items->children) {
            const TomlNode* its_name = item.child("name");
            if (its_name == nullptr || !its_name->is_text()) continue;
            if (its_name->text.text == name) return item;
            names.push_back(its_name->text.text);
        }
    }
    const TomlNode* items = document.child(list);
    if (adds_entry(list, name, key, names) && (items == nullptr || items->is_array()))
        return new_item(document, list, name, location);
    throw no_such_entry(list, name, names, location);
}

/// The table called `name` in `table`; creates it if necessary.
TomlNode& table_in(TomlNode& table, const std::string& name, const SourceLocation& location) {
    TomlNode* child = table.child(name);
    if (child == nullptr) {
        TomlNode made;
        made.key = name;
        made.key_location = made.location = location;
        child = &table.children.emplace_back(std::move(made));
    }
    if (!child->is_table()) {
        throw InputError(child->location, "'" + name + "' is " + child->shown() + ", expected a table",
                         "write it as a table, [" + name + "]");
    }
    return *child;
}

void put(TomlNode& table, TomlNode value) {
    if (TomlNode* old = table.child(value.key)) {
        *old = std::move(value);
    } else {
        table.children.push_back(std::move(value));
    }
}

}  // namespace

std::vector<std::string> words_of_key(const std::string& key, const SourceLocation& location) {
    const auto words = split_at_dots(key);
    if (names_a_list(words[0]) && words.size() != 3) {
        throw InputError(location, "'" + key + "' does not say which " + words[0] + " and which of its keys",
                         "write " + words[0] + ".NAME.KEY=VALUE");
    }
    const std::string pattern = key_pattern(key);
    const auto facts = schema().facts();
    if (std::none_of(facts.begin(), facts.end(), [&](const KeyFacts& f) { return f.path == pattern; })) {
        throw InputError(location, "unknown key '" + key + "'", advice_for_unknown_key(pattern));
    }
    return words;
}

bool adds_entry(const std::string& list, const std::string& name, const std::string& key,
                const std::vector<std::string>& names) {
    return list == "measure" && key == "kind" && std::ranges::find(names, name) == names.end() &&
           nearest_name(name, names).empty();
}

InputError no_such_entry(const std::string& list, const std::string& name, const std::vector<std::string>& names,
                         const SourceLocation& location) {
    const auto nearest = nearest_name(name, names);
    const std::string plural = list == "species" ? list : list + "s";
    return {location, "the scene has no " + list + " '" + name + "'",
            names.empty()     ? "it has none at all"
            : nearest.empty() ? "its " + plural + " are " + quoted_list(names)
                              : "did you mean '" + nearest + "'?"};
}

std::string key_of_override(const std::string& text) { return trimmed(text.substr(0, text.find('='))); }

void apply_overrides(TomlNode& document, std::span<const std::string> overrides) {
    for (const auto& text : overrides) {
        const SourceLocation location{"--set " + text, 0, 0};
        const auto equals = text.find('=');
        const std::string key = key_of_override(text);
        if (equals == std::string::npos || key.empty()) {
            throw InputError(location, "expected KEY=VALUE", "write for example --set particles.spacing=\"0.1 mm\"");
        }
        const auto words = words_of_key(key, location);

        TomlNode* table = &document;
        if (names_a_list(words[0])) {
            table = &find_item(document, words[0], words[1], words[2], location);
        } else {
            for (std::size_t i = 0; i + 1 < words.size(); ++i) table = &table_in(*table, words[i], location);
        }
        TomlNode value = parse_toml_value(trimmed(text.substr(equals + 1)), location);
        value.key = words.back();
        put(*table, std::move(value));
    }
}

}  // namespace dmp::scene
