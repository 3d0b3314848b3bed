// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/read_scene.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/hex_text.hpp"
#include "base/nearest_name.hpp"
#include "scene/checks.hpp"
#include "scene/numerics_checks.hpp"
#include "scene/overrides.hpp"
#include "scene/schema.hpp"
#include "scene/step_margins.hpp"

namespace dmp::scene {

namespace {

std::string scene_file(const std::string& path) {
    std::error_code none;
    if (!std::filesystem::exists(path, none)) {
        throw InputError({path, 0, 0}, "there is no such file or folder",
                         "give a scene file or a folder with a scene.toml");
    }
    if (!std::filesystem::is_directory(path, none)) return path;
    const auto file = std::filesystem::path(path) / "scene.toml";
    if (!std::filesystem::exists(file, none)) {
        throw InputError({path, 0, 0}, "this folder has no scene.toml", "give the folder of a case, or a scene file");
    }
    return file.string();
}

std::string contents_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream contents;
    const bool empty = stream.peek() == std::ifstream::traits_type::eof();  // a folder can be opened, but fails here
    if (!stream.is_open() || stream.bad()) {
        throw InputError({file, 0, 0}, "the file cannot be read", "check that it is a file and its permissions");
    }
    if (!empty) contents << stream.rdbuf();
    return contents.str();
}

// ---- unknown keys and misplaced tables; checked first, because a misspelt key explains a missing one

[[noreturn]] void refuse_unknown(const TomlNode& node, const std::string& pattern, const std::string& where) {
    throw InputError(node.key_location, "unknown key '" + node.key + "'" + where, advice_for_unknown_key(pattern));
}

void refuse_unknown_in(const TomlNode& table, const std::string& section, const std::string& where,
                       const std::vector<KeyFacts>& facts) {
    for (const auto& node : table.children) {
        const std::string pattern = section + "." + node.key;
        if (std::none_of(facts.begin(), facts.end(), [&](const auto& f) { return f.path == pattern; })) {
            refuse_unknown(node, pattern, where);
        }
    }
}

void check_items(const TomlNode& list, const std::vector<KeyFacts>& facts) {
    const std::string header = "[[" + list.key + "]]";
    if (!list.is_array()) {
        throw InputError(list.location, "'" + list.key + "' is " + list.shown() + ", expected a list of tables",
                         "write " + header + " with double brackets, once for each " + list.key);
    }
    for (const auto& item : list.children) {
        if (!item.is_table()) {
            throw InputError(item.location, "'" + list.key + "' holds " + item.shown() + ", expected tables",
                             "write " + header + ", once for each " + list.key);
        }
        refuse_unknown_in(item, list.key + ".*", " in " + header, facts);
    }
}

void check_keys(const TomlNode& document) {
    const auto facts = schema().facts();
    for (const auto& node : document.children) {
        if (std::ranges::find(item_lists(), node.key) != item_lists().end()) {
            check_items(node, facts);
            continue;
        }
        if (std::any_of(facts.begin(), facts.end(), [&](const auto& f) { return f.path == node.key; })) continue;
        if (std::none_of(facts.begin(), facts.end(), [&](const auto& f) { return f.section() == node.key; })) {
            refuse_unknown(node, node.key, "");
        }
        if (!node.is_table()) {
            throw InputError(node.location, "'" + node.key + "' is " + node.shown() + ", expected a table",
                             "write [" + node.key + "] and its keys below");
        }
        refuse_unknown_in(node, node.key, " in [" + node.key + "]", facts);
    }
}

// ---- values

/// Reads one key, or its default if `node` is null. `path` is its name in messages.
template <class Owner>
void read_key(Owner& owner, const Key<Owner>& key, const TomlNode* node, const std::string& path,
              const SourceLocation& table, const Scene& scene) {
    if (node != nullptr) {
        key.read(owner, *node, path);
    } else if (key.facts.fallback.presence == required) {
        throw InputError(table, "missing key: " + path, "add " + shown_key(key.facts.path) + ": " + key.facts.type);
    } else if (key.facts.fallback.presence != not_given) {
        key.read(owner, parse_toml_value(key.facts.fallback.at(*scene.quality, *scene.numerics.scheme), {}), path);
    }
}

/// Throws if the key of `node` does not apply to the item's kind.
template <class Item>
void need_fitting_key(const Item& item, const TomlNode& node, const std::string& what,
                      const std::vector<Key<Item>>& keys) {
    const std::string kind = to_string(*item.kind);
    Kinds right_kinds;
    for (const auto& key : keys) {
        if (key.facts.name() != node.key) continue;
        if (key.facts.is_for(kind)) return;
        right_kinds.insert(right_kinds.end(), key.facts.kinds.begin(), key.facts.kinds.end());
    }
    throw InputError(node.key_location,
                     "'" + node.key + "' does not apply to the " + what + " '" + *item.name + "' of kind '" + kind +
                         "', only to kind " + quoted_list(right_kinds),
                     "remove it, or correct the " + what + "'s kind");
}

template <class Item>
Item read_item(const TomlNode& table, const std::string& what, const std::vector<Key<Item>>& keys, const Scene& scene) {
    Item item;
    std::string prefix = what;  // "part", then "part.blood" once the name is known
    for (const auto& key : keys) {
        const bool first_two = key.facts.name() == "name" || key.facts.name() == "kind";
        if (!first_two && !key.facts.is_for(kind_of(item))) continue;
        read_key(item, key, table.child(key.facts.name()), prefix + "." + key.facts.name(), table.location, scene);
        if (key.facts.name() == "name" && !item.name->empty()) prefix = what + "." + *item.name;
        if constexpr (requires { item.kind; }) {
            if (key.facts.name() != "kind") continue;
            for (const auto& node : table.children) need_fitting_key(item, node, what, keys);
        }
    }
    return item;
}

template <class Item>
std::vector<Item> read_items(const TomlNode& document, const std::string& what, const std::vector<Key<Item>>& keys,
                             const Scene& scene) {
    std::vector<Item> items;
    if (const TomlNode* list = document.child(what)) {
        for (const auto& table : list->children) items.push_back(read_item(table, what, keys, scene));
    }
    return items;
}

/// FNV-1a, 64 bit (Fowler, Noll, Vo), in hexadecimal.
std::string fnv1a(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : text) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3U;
    }
    return hex_text(hash);
}

}  // namespace

Scene read_scene(const std::string& path, std::span<const std::string> overrides) {
    Scene scene;
    scene.file = scene_file(path);
    const auto folder = std::filesystem::path(scene.file).parent_path().string();
    scene.directory = folder.empty() ? "." : folder;

    TomlNode document = parse_toml(contents_of(scene.file), scene.file);
    apply_overrides(document, overrides);
    check_keys(document);

    const auto read = [&](const Key<Scene>& key) {
        const TomlNode* section = document.find(key.facts.section());
        const bool in_table = section != nullptr && !key.facts.section().empty();
        const SourceLocation table = in_table ? section->location : SourceLocation{scene.file, 0, 0};
        read_key(scene, key, document.find(key.facts.path), key.facts.path, table, scene);
    };
    for (const auto& key : schema().scene)  // first what defaults of other keys depend on
        if (key.facts.path == "quality" || key.facts.path == "numerics.scheme") read(key);
    for (const auto& key : schema().scene) read(key);
    scene.selections = read_items(document, "select", schema().select, scene);
    scene.parts = read_items(document, "part", schema().part, scene);
    scene.joins = read_items(document, "join", schema().join, scene);
    scene.species = read_items(document, "species", schema().species, scene);
    scene.contact_pairs = read_items(document, "contact_pair", schema().contact_pair, scene);
    scene.forces = read_items(document, "force", schema().force, scene);
    scene.moving_shapes = read_items(document, "moving_shape", schema().moving_shape, scene);
    scene.regions = read_items(document, "region", schema().region, scene);
    scene.measures = read_items(document, "measure", schema().measure, scene);
    scene.references = read_items(document, "reference", schema().reference, scene);
    scene.solidify = read_items(document, "solidify", schema().solidify, scene);
    scene.breaking = read_items(document, "break", schema().breaking, scene);
    check_scene(scene, document);
    set_dependent_defaults(scene);
    lower_defaults(scene);
    scene.hash = fnv1a(resolved_scene(scene));
    return scene;
}

}  // namespace dmp::scene
