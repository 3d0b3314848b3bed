// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/written_text.hpp"

namespace dmp::scene {

/// One value of a TOML document with its places: what the rest of the room sees of TOML.
struct TomlNode {
    enum class Kind { table, array, text, integer, number, boolean, date };

    Kind kind = Kind::table;
    std::string key;              ///< its name in the table that holds it; empty in an array
    SourceLocation key_location;  ///< where that name stands
    SourceLocation location;      ///< where the value starts
    std::string written;          ///< numbers, booleans and dates: as the user wrote them
    WrittenText text;             ///< texts
    std::int64_t integer = 0;
    double number = 0;  ///< integers too
    bool boolean = false;
    std::vector<TomlNode> children;  ///< of a table or array, in the order written

    /// The child of this table called `name`; null where there is none.
    [[nodiscard]] const TomlNode* child(std::string_view name) const;
    [[nodiscard]] TomlNode* child(std::string_view name);
    /// Follows "particles.spacing" from here; null where there is no such value.
    [[nodiscard]] const TomlNode* find(std::string_view path) const;

    [[nodiscard]] bool is_table() const { return kind == Kind::table; }
    [[nodiscard]] bool is_array() const { return kind == Kind::array; }
    [[nodiscard]] bool is_text() const { return kind == Kind::text; }
    [[nodiscard]] bool is_number() const { return kind == Kind::integer || kind == Kind::number; }

    /// For messages: `"3 s"`, `3`, `true`, `a list`, `a table`.
    [[nodiscard]] std::string shown() const;
};

/// The root table of a TOML text. Throws InputError with the place of the first fault.
TomlNode parse_toml(std::string_view text, const std::string& file);

/// One value, as it would stand after "key = "; what is no TOML value is taken as text. Every place in it is `place`.
TomlNode parse_toml_value(std::string_view text, const SourceLocation& location);

/// `text` as a TOML string, quotes and escapes included.
std::string toml_quoted(std::string_view text);

}  // namespace dmp::scene
