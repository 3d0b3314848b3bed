// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "scene/toml_node.hpp"
#include "scene/value.hpp"
#include "scene/value_types.hpp"
#include "study/uses.hpp"

namespace dmp::study {

/// A table of a study file, and how its keys are read.
class TomlTable {
  public:
    /// `path`: its name in messages, "result" or "vary.range"; `keys`: all that it may have. Throws InputError where
    /// `node` is no table, or has another key.
    TomlTable(const TomlNode& node, std::string path, const std::vector<std::string>& keys);

    [[nodiscard]] const TomlNode& node() const { return node_; }
    [[nodiscard]] const SourceLocation& location() const { return node_.location; }
    /// Null where the key is not given.
    [[nodiscard]] const TomlNode* find(const std::string& key) const { return node_.child(key); }
    /// Throws InputError where the key is not given; `expected` says what to add.
    [[nodiscard]] const TomlNode& need(const std::string& key, const std::string& expected) const;

    template <class T>
    [[nodiscard]] Value<T> need(const std::string& key, const ValueType<T>& type) const {
        const TomlNode& value = need(key, type.description);
        return {type.read(value, path_of(key)), value.location};
    }
    /// `otherwise` where the key is not given.
    template <class T>
    [[nodiscard]] Value<T> read(const std::string& key, const ValueType<T>& type, Value<T> otherwise) const {
        const TomlNode* value = find(key);
        return value == nullptr ? otherwise : Value<T>(type.read(*value, path_of(key)), value->location);
    }
    [[nodiscard]] std::string path_of(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }

  private:
    const TomlNode& node_;
    std::string path_;
};

/// The tables of a list such as [[vary]]; none where the document has no such list. Throws InputError for another
/// value.
std::vector<const TomlNode*> tables_of(const TomlNode& document, const std::string& list);

}  // namespace dmp::study
