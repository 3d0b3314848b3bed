// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/written_text.hpp"

namespace dmp::scene {

/// A value of a TOML document with its locations; the rest of the module does not use the TOML library.
struct TomlNode {
    enum class Kind { table, array, text, integer, number, boolean, date };

    Kind kind = Kind::table;
    std::string key;              ///< its name in its table; empty in an array
    SourceLocation key_location;  ///< of that name
    SourceLocation location;      ///< of the start of the value
    std::string written;          ///< numbers, booleans and dates: as written by the user
    WrittenText text;             ///< of a text
    std::int64_t integer = 0;
    double number = 0;  ///< also for integers
    bool boolean = false;
    std::vector<TomlNode> children;  ///< of a table or array, in the order of the file

    /// The child of this table called `name`; null if there is none.
    [[nodiscard]] const TomlNode* child(std::string_view name) const;
    [[nodiscard]] TomlNode* child(std::string_view name);
    /// The value at a path such as "particles.spacing" below this node; null if there is none.
    [[nodiscard]] const TomlNode* find(std::string_view path) const;
    /// Where the value that find(path) returns stands in the file; null where there is none.
    [[nodiscard]] const SourceLocation* location_of(std::string_view path) const;

    [[nodiscard]] bool is_table() const { return kind == Kind::table; }
    [[nodiscard]] bool is_array() const { return kind == Kind::array; }
    [[nodiscard]] bool is_text() const { return kind == Kind::text; }
    [[nodiscard]] bool is_number() const { return kind == Kind::integer || kind == Kind::number; }

    /// For messages: `"3 s"`, `3`, `true`, `a list`, `a table`.
    [[nodiscard]] std::string shown() const;
};

/// The root table of a TOML text. Throws InputError with the location of the first error.
TomlNode parse_toml(std::string_view text, const std::string& file);

/// A single value, as after "key = "; anything that is not a TOML value is read as text. All its locations are
/// `location`.
TomlNode parse_toml_value(std::string_view text, const SourceLocation& location);

/// A value as TOML, on one line.
std::string toml_text(const TomlNode& node);

/// `text` as a TOML string with quotes and escapes.
std::string toml_quoted(std::string_view text);

}  // namespace dmp::scene
