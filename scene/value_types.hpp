// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/nearest_name.hpp"
#include "base/vec.hpp"
#include "scene/choices.hpp"
#include "scene/expression.hpp"
#include "scene/items.hpp"
#include "scene/quantity.hpp"
#include "scene/toml_node.hpp"
#include "scene/value.hpp"

namespace dmp::scene {

/// Type of a key's value: its description for the user, and how to read it from TOML and write it as TOML in SI units.
template <class T>
struct ValueType {
    std::string description;  ///< `a length such as "0.1 mm", more than 0`
    /// Reads a value; the string is the key's full path, for messages. Throws InputError with the value's location.
    std::function<T(const TomlNode&, const std::string&)> read;
    std::function<std::string(const T&)> write;
};

/// The range of numbers that a key accepts, in SI units.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool above_low = false;   ///< `low` itself is excluded
    std::string_view advice;  ///< advice for a number outside the range, if any

    [[nodiscard]] bool contains(double value) const {
        return value <= high && (above_low ? value > low : value >= low);
    }
    /// "more than 0", "between 2 and 6"; empty for an unlimited range.
    [[nodiscard]] std::string text() const;
};

inline constexpr Range any_number{};
inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true, {}};
inline constexpr Range not_negative{0, std::numeric_limits<double>::infinity(), false, {}};
constexpr Range at_least(double low) { return {low, std::numeric_limits<double>::infinity(), false, {}}; }
inline constexpr Range fraction{0, 1, true, {}};
constexpr Range between(double low, double high) { return {low, high, false, {}}; }
constexpr Range exactly(double value, std::string_view advice) { return {value, value, false, advice}; }

/// A number with a unit in quotes. The example defines the dimension.
ValueType<double> quantity(const std::string& example, const Range& range = any_number);
/// A quantity above 0, or "auto", which is stored as 0.
ValueType<double> quantity_or_auto(const std::string& example);
ValueType<double> number(const Range& range = any_number);
ValueType<int> integer(const Range& range = any_number);
ValueType<bool> boolean();
/// Any text, including "".
ValueType<std::string> text();
/// Text with at least one visible character.
ValueType<std::string> text_not_empty();
/// Letters, digits and '_', starting with a letter.
ValueType<std::string> name();
/// A point of two or three lengths; a bare 0 needs no unit.
ValueType<Vec> point();
/// A quantity, or a list of them.
ValueType<std::vector<double>> quantity_or_list(const std::string& example, const Range& range = any_number);
/// A list of points.
ValueType<std::vector<Vec>> points();
/// Three plain numbers, not all 0.
ValueType<Vec> direction();
/// Two or three whole numbers, not all 0: waves in a period along x, y and z.
ValueType<std::array<int, 3>> wave_numbers();
/// A list of at least one name, all different.
ValueType<std::vector<std::string>> names();
/// A list of two names.
ValueType<std::array<std::string, 2>> two_names();
/// One to three formulas of t, x, y, z; a bare 0 needs no unit.
ValueType<std::array<Expression, 3>> formulas(const std::string& example, PlacesKnown places = PlacesKnown::now);
/// One formula of t, x, y, z; a bare 0 needs no unit.
ValueType<Expression> formula(const std::string& example);
/// A list of "x", "y", "z".
ValueType<std::array<Value<bool>, 3>> axes();
/// A table of numbers by name: bare numbers, angles (in radians) and lengths (divided by `unit` [m]).
ValueType<std::map<std::string, Value<double>>> parameters(double unit);

/// The error for a value of the wrong type.
InputError wrong_kind(const TomlNode& node, const std::string& path, const std::string& expected,
                      const std::string& advice = {});

/// A value of type `one` for all parts, or a table of such values by part.
template <class T>
ValueType<ByPart<T>> by_part(const ValueType<T>& one);
/// A formula for the concentration of a species with this unit, or for its amount per area and time. With the unit "1",
/// concentrations may be bare numbers.
ValueType<Expression> concentration_formula(SpeciesUnit unit);
ValueType<Expression> flux_formula(SpeciesUnit unit);
/// A formula or a number of any dimension: what it must be is known when all of the scene is read.
ValueType<Expression> any_formula(const std::string& example);

namespace detail {

/// A key in TOML, in quotes if necessary.
std::string bare_key_or_quoted(const std::string& key);
/// Index in `names` of the name in `node`.
std::size_t index_of_name(const TomlNode& node, const std::string& path, const std::vector<std::string>& names);
const std::vector<TomlNode>& list_items(const TomlNode& node, const std::string& path, const std::string& expected);
void refuse_repeated_names(const TomlNode& list, const std::string& path);
std::string toml_list(const std::vector<std::string>& items);

/// The names of an enumeration or of a registry's laws, in their order.
template <class Enumeration>
std::vector<std::string> name_list() {
    if constexpr (requires { typename Enumeration::Registry; }) {
        std::vector<std::string> names;
        for (const LawFacts& facts : Enumeration::Registry::facts()) names.emplace_back(facts.key);
        return names;
    } else {
        return {enum_names<Enumeration>.begin(), enum_names<Enumeration>.end()};
    }
}

}  // namespace detail

template <class T>
ValueType<ByPart<T>> by_part(const ValueType<T>& one) {
    const std::string description = one.description + ", or a table of them by part";
    return {description,
            [one](const TomlNode& node, const std::string& path) {
                ByPart<T> value;
                if (!node.is_table()) {
                    value.all = Value<T>(one.read(node, path), node.location);
                    return value;
                }
                for (const auto& entry : node.children)
                    value.parts[entry.key] = Value<T>(one.read(entry, path + "." + entry.key), entry.key_location);
                return value;
            },
            [one](const ByPart<T>& value) {
                if (value.all) return one.write(**value.all);
                std::string table;
                for (const auto& [part, of_part] : value.parts)
                    table +=
                        (table.empty() ? " " : ", ") + detail::bare_key_or_quoted(part) + " = " + one.write(*of_part);
                return "{" + table + (table.empty() ? "}" : " }");
            }};
}

/// One name of an enumeration.
template <class Enumeration>
ValueType<Enumeration> one_of() {
    return {"one of " + quoted_list(detail::name_list<Enumeration>()),
            [](const TomlNode& node, const std::string& path) {
                const auto index = detail::index_of_name(node, path, detail::name_list<Enumeration>());
                return static_cast<Enumeration>(index);
            },
            [](const Enumeration& value) { return toml_quoted(to_string(value)); }};
}

/// Description of the laws of a registry, for the reference: "'hertz': Hertz' elastic contact; 'jkr': ...".
template <class Law>
std::string meanings() {
    std::string text;
    for (const LawFacts& facts : Law::Registry::facts())
        text += (text.empty() ? "'" : "; '") + std::string(facts.key) + "': " + std::string(facts.meaning);
    return text;
}

/// A list of different names of an enumeration.
template <class Enumeration>
ValueType<std::vector<Enumeration>> list_of() {
    const std::string description = "a list of any of " + quoted_list(detail::name_list<Enumeration>());
    return {description,
            [description](const TomlNode& node, const std::string& path) {
                std::vector<Enumeration> values;
                for (const auto& item : detail::list_items(node, path, description)) {
                    values.push_back(one_of<Enumeration>().read(item, path));
                }
                detail::refuse_repeated_names(node, path);
                return values;
            },
            [](const std::vector<Enumeration>& values) {
                std::vector<std::string> words;
                words.reserve(values.size());
                for (const auto value : values) words.push_back(toml_quoted(to_string(value)));
                return detail::toml_list(words);
            }};
}

}  // namespace dmp::scene
