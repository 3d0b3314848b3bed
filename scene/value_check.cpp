// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/value_check.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "base/nearest_name.hpp"
#include "scene/overrides.hpp"
#include "scene/schema.hpp"

namespace dmp::scene {

namespace {

using Read = std::function<void(const TomlNode&)>;

/// Reads values into a copy of `owner` that nobody looks at.
template <class Owner>
Read read_into_copy(const Owner& owner, const Key<Owner>& key, const std::string& path) {
    return [copy = std::make_shared<Owner>(owner), read = key.read, path](const TomlNode& value) {
        read(*copy, value, path);
    };
}

/// Of an entry of a list: `words` are the list, the entry's name and its key.
template <class Item>
Read read_of_item(const std::vector<Item>& items, const std::vector<Key<Item>>& keys,
                  const std::vector<std::string>& words, const SourceLocation& location) {
    const auto item = std::ranges::find_if(items, [&](const Item& each) { return *each.name == words[1]; });
    if (item == items.end()) {
        std::vector<std::string> names;
        for (const Item& each : items) names.push_back(*each.name);
        if (adds_entry(words[0], words[1], words[2], names))
            for (const auto& key : keys)
                if (key.facts.name() == words[2])
                    return read_into_copy(Item{}, key, words[0] + "." + words[1] + "." + words[2]);
        throw no_such_entry(words[0], words[1], names, location);
    }
    for (const auto& key : keys)
        if (key.facts.name() == words[2] && key.facts.is_for(kind_of(*item)))
            return read_into_copy(*item, key, words[0] + "." + words[1] + "." + words[2]);
    std::vector<std::string> names;
    for (const auto& key : keys)
        if (key.facts.is_for(kind_of(*item))) names.push_back(key.facts.name());
    throw InputError(
        location,
        "'" + words[2] + "' does not apply to the " + words[0] + " '" + words[1] + "' of kind '" + kind_of(*item) + "'",
        "it has " + quoted_list(names));
}

/// One of geometry.parameters: its type reads all of them as a table.
Read read_of_parameter(const Scene& scene, const Key<Scene>& parameters, const std::string& name) {
    return [read = read_into_copy(scene, parameters, parameters.facts.path), name](const TomlNode& value) {
        TomlNode table;
        table.location = value.location;
        table.children.push_back(value);
        table.children.front().key = name;
        table.children.front().key_location = value.location;
        read(table);
    };
}

Read read_of_scene_key(const Scene& scene, const std::vector<std::string>& words, const std::string& path) {
    const std::string pattern = key_pattern(path);
    const auto key = std::ranges::find(schema().scene, pattern, [](const auto& each) { return each.facts.path; });
    if (pattern != path) return read_of_parameter(scene, *key, words.back());
    return read_into_copy(scene, *key, path);
}

Read read_of(const Scene& scene, const std::string& path, const SourceLocation& location) {
    const std::vector<std::string> words = words_of_key(path, location);
    const auto of = [&](const auto& items, const auto& keys) { return read_of_item(items, keys, words, location); };
    const std::string& list = words[0];
    if (list == "select") return of(scene.selections, schema().select);
    if (list == "part") return of(scene.parts, schema().part);
    if (list == "join") return of(scene.joins, schema().join);
    if (list == "species") return of(scene.species, schema().species);
    if (list == "contact_pair") return of(scene.contact_pairs, schema().contact_pair);
    if (list == "force") return of(scene.forces, schema().force);
    if (list == "moving_shape") return of(scene.moving_shapes, schema().moving_shape);
    if (list == "region") return of(scene.regions, schema().region);
    if (list == "measure") return of(scene.measures, schema().measure);
    if (list == "reference") return of(scene.references, schema().reference);
    if (list == "solidify") return of(scene.solidify, schema().solidify);
    if (list == "break") return of(scene.breaking, schema().breaking);
    return read_of_scene_key(scene, words, path);
}

}  // namespace

ValueCheck::ValueCheck(const Scene& scene, const std::string& key, const SourceLocation& location)
    : read_(read_of(scene, key, location)) {}

}  // namespace dmp::scene
