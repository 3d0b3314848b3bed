// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/toml_table.hpp"

#include <algorithm>
#include <utility>

#include "base/nearest_name.hpp"

namespace dmp::study {

namespace {

/// "a study", "[[vary]]", "[slurm]", "range".
std::string holder(const std::string& path) {
    if (path.empty()) return "a study";
    if (path == "slurm") return "[slurm]";
    return path.find('.') == std::string::npos ? "[[" + path + "]]" : "'" + last_word(path) + "'";
}

}  // namespace

TomlTable::TomlTable(const TomlNode& node, std::string path, const std::vector<std::string>& keys)
    : node_(node), path_(std::move(path)) {
    if (!node.is_table()) throw wrong_kind(node, path_, "a table with " + quoted_list(keys));
    for (const TomlNode& child : node.children) {
        if (std::ranges::find(keys, child.key) != keys.end()) continue;
        const std::string nearest = nearest_name(child.key, keys);
        throw InputError(
            child.key_location, "unknown key '" + child.key + "'" + (path_.empty() ? "" : " in " + holder(path_)),
            nearest.empty() ? holder(path_) + " has " + quoted_list(keys) : "did you mean '" + nearest + "'?");
    }
}

const TomlNode& TomlTable::need(const std::string& key, const std::string& expected) const {
    const TomlNode* value = find(key);
    if (value == nullptr)
        throw InputError(location(), "missing key: " + path_of(key), "add '" + key + "': " + expected);
    return *value;
}

std::vector<const TomlNode*> tables_of(const TomlNode& document, const std::string& list) {
    std::vector<const TomlNode*> tables;
    const TomlNode* node = document.child(list);
    if (node == nullptr) return tables;
    if (!node->is_array())
        throw InputError(node->location, "'" + list + "' is " + node->shown() + ", expected a list of tables",
                         "write [[" + list + "]] with double brackets, once for each " + list);
    for (const TomlNode& table : node->children) tables.push_back(&table);
    return tables;
}

}  // namespace dmp::study
