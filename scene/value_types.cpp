// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/value_types.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "base/unlisted_value.hpp"
#include "scene/formula.hpp"
#include "scene/renamed.hpp"

namespace dmp::scene {

namespace {

std::string with_range(std::string description, const Range& range) {
    if (range.text().empty()) return description;
    return description + (range.low == range.high ? ", only " : ", ") + range.text();
}

std::string in_words(TomlNode::Kind kind) {
    switch (kind) {
        case TomlNode::Kind::text:
            return " (text)";
        case TomlNode::Kind::integer:
            return " (a whole number)";
        case TomlNode::Kind::number:
            return " (a number)";
        case TomlNode::Kind::boolean:
            return " (true or false)";
        case TomlNode::Kind::date:
            return " (a date)";
        case TomlNode::Kind::table:
        case TomlNode::Kind::array:
            return "";
    }
    unlisted_value(kind);
}

void need_in_range(double value, const TomlNode& node, const std::string& path, const Range& range) {
    if (range.contains(value)) return;
    throw InputError(node.location, path + ": found " + node.shown() + ", expected " + range.text(),
                     range.advice.empty() ? "give a value that is " + range.text() : std::string(range.advice));
}

/// A quantity in quotes or a bare 0.
double read_quantity_node(const TomlNode& node, const std::string& path, const Expected& expected) {
    if (node.is_text()) return expected.read(node.text, path);
    if (!node.is_number()) throw wrong_kind(node, path, expected.phrase());
    if (node.number == 0) return 0;
    throw expected.missing_unit(node.location, node.shown(), path);
}

std::string write_quantity(double si, const Expected& expected) {
    if (expected.dimension().none()) return exact_text(si);
    return "\"" + exact_text(si) + " " + expected.dimension().si_unit() + "\"";
}

double read_number(const TomlNode& node, const std::string& path, const Range& range, const std::string& description) {
    if (!node.is_number()) {
        throw wrong_kind(node, path, description, node.is_text() ? "write the number without quotes and unit" : "");
    }
    if (!std::isfinite(node.number)) throw wrong_kind(node, path, "a finite number");
    need_in_range(node.number, node, path, range);
    return node.number;
}

/// A formula; if its dimension is a number, a bare number too.
ValueType<Expression> formula_or_number(const std::string& example) {
    const ValueType<Expression> formulas_only = formula(example);
    if (!Expected(example).dimension().none()) return formulas_only;
    return {"a number or a formula for one",
            [formulas_only](const TomlNode& node, const std::string& path) {
                if (!node.is_number()) return formulas_only.read(node, path);
                const std::string number = exact_text(node.number);
                return Expression(number, number);
            },
            formulas_only.write};
}

ValueType<std::string> checked_text(const std::string& description,
                                    std::function<void(const TomlNode&, const std::string&)> check) {
    return {description,
            [description, check = std::move(check)](const TomlNode& node, const std::string& path) {
                if (!node.is_text()) {
                    const bool writable = !node.is_array() && !node.is_table();
                    throw wrong_kind(
                        node, path, description,
                        writable ? "write it in quotes: " + last_word(path) + " = \"" + node.shown() + "\"" : "");
                }
                check(node, path);
                return node.text.text;
            },
            [](const std::string& value) { return toml_quoted(value); }};
}

}  // namespace

std::string Range::text() const {
    const bool bounded_below = std::isfinite(low);
    const bool bounded_above = std::isfinite(high);
    if (bounded_below && low == high) return exact_text(low);
    if (bounded_above && above_low) return "more than " + exact_text(low) + " and at most " + exact_text(high);
    if (bounded_below && bounded_above) return "between " + exact_text(low) + " and " + exact_text(high);
    if (bounded_below) return (above_low ? "more than " : "at least ") + exact_text(low);
    return bounded_above ? "at most " + exact_text(high) : "";
}

InputError wrong_kind(const TomlNode& node, const std::string& path, const std::string& expected,
                      const std::string& advice) {
    return {node.location, path + ": found " + node.shown() + in_words(node.kind) + ", expected " + expected,
            advice.empty() ? "give " + last_word(path) + " " + expected : advice};
}

ValueType<double> quantity(const std::string& example, const Range& range) {
    const Expected expected(example);
    return {with_range(expected.phrase(), range),
            [=](const TomlNode& node, const std::string& path) {
                const double value = read_quantity_node(node, path, expected);
                need_in_range(value, node, path, range);
                return value;
            },
            [=](const double& si) { return write_quantity(si, expected); }};
}

ValueType<double> quantity_or_auto(const std::string& example) {
    const Expected expected(example);
    const std::string description = "\"auto\" or " + with_range(expected.phrase(), positive);
    return {description,
            [=](const TomlNode& node, const std::string& path) {
                if (node.is_text() && node.text.text == "auto") return 0.0;
                if (!node.is_text() && !node.is_number()) throw wrong_kind(node, path, description);
                if (node.is_text() && end_of_name(node.text.text, 0) == node.text.text.size()) {
                    throw wrong_kind(node, path, description);
                }
                const double value = read_quantity_node(node, path, expected);
                Range range = positive;
                range.advice = "write \"auto\" or a value that is more than 0";
                need_in_range(value, node, path, range);
                return value;
            },
            [=](const double& si) { return si == 0 ? std::string("\"auto\"") : write_quantity(si, expected); }};
}

ValueType<double> number(const Range& range) {
    const std::string description = with_range("a number", range);
    return {description,
            [=](const TomlNode& node, const std::string& path) { return read_number(node, path, range, description); },
            [](const double& value) { return exact_text(value); }};
}

ValueType<int> integer(const Range& range) {
    const std::string description = with_range("a whole number", range);
    return {description,
            [=](const TomlNode& node, const std::string& path) {
                if (node.kind != TomlNode::Kind::integer) throw wrong_kind(node, path, description);
                need_in_range(node.number, node, path, range);
                if (node.integer > std::numeric_limits<int>::max() || node.integer < std::numeric_limits<int>::min()) {
                    throw wrong_kind(node, path, "a whole number of at most nine digits");
                }
                return static_cast<int>(node.integer);
            },
            [](const int& value) { return std::to_string(value); }};
}

ValueType<bool> boolean() {
    return {"true or false",
            [](const TomlNode& node, const std::string& path) {
                if (node.kind != TomlNode::Kind::boolean) {
                    throw wrong_kind(node, path, "true or false", "write true or false, without quotes");
                }
                return node.boolean;
            },
            [](const bool& value) { return std::string(value ? "true" : "false"); }};
}

ValueType<std::string> text() {
    return checked_text("text", [](const TomlNode&, const std::string&) {});
}

ValueType<std::string> text_not_empty() {
    return checked_text("text", [](const TomlNode& node, const std::string& path) {
        if (node.text.text.find_first_not_of(" \t\r\n") == std::string::npos) {
            throw InputError(node.location, path + ": found \"\", expected text", "write some text, or remove the key");
        }
    });
}

ValueType<std::string> name() {
    return checked_text("a name of letters, digits and '_'", [](const TomlNode& node, const std::string& path) {
        const auto& name = node.text.text;
        const bool good = !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
                          std::all_of(name.begin(), name.end(),
                                      [](unsigned char c) { return c < 0x80 && (std::isalnum(c) != 0 || c == '_'); });
        if (!good) {
            throw InputError(node.location,
                             path + ": found " + node.shown() +
                                 ", expected a name of letters, digits and '_' that starts with a letter",
                             "write a name such as \"inner_wall\"");
        }
    });
}

ValueType<Vec> point() {
    const Expected expected("1 mm");
    const std::string description = "a point such as [\"1 mm\", 0]";
    return {description,
            [=](const TomlNode& node, const std::string& path) {
                const auto& items = detail::list_items(node, path, description);
                if (items.size() < 2 || items.size() > 3) {
                    throw InputError(
                        node.location,
                        path + ": found a list of " + std::to_string(items.size()) + ", expected two or three lengths",
                        "write " + last_word(path) + " = [x, y], such as [\"1 mm\", 0]");
                }
                Vec value = Vec::Zero();
                for (std::size_t i = 0; i < items.size(); ++i) {
                    value[static_cast<Eigen::Index>(i)] = read_quantity_node(items[i], path, expected);
                }
                return value;
            },
            [=](const Vec& value) {
                std::vector<std::string> items;
                for (const double component : value) items.push_back(write_quantity(component, expected));
                return detail::toml_list(items);
            }};
}

ValueType<std::array<Expression, 3>> formulas(const std::string& example, PlacesKnown places) {
    const Expected expected(example);
    const std::string description = "a list of one to three formulas, each " + expected.phrase() + " or 0";
    return {description,
            [=](const TomlNode& node, const std::string& path) {
                std::array<Expression, 3> value;
                const auto& items = detail::list_items(node, path, description);
                if (items.empty() || items.size() > 3) {
                    throw InputError(
                        node.location,
                        path + ": found a list of " + std::to_string(items.size()) + ", expected one to three formulas",
                        "write " + last_word(path) + " = [x, y], such as [\"" + example + "\", 0]");
                }
                for (std::size_t i = 0; i < items.size(); ++i) {
                    if (items[i].is_text()) {
                        value.at(i) = read_formula(items[i].text, expected, path, places);
                    } else {
                        read_quantity_node(items[i], path, expected);  // only 0 passes
                    }
                }
                return value;
            },
            [](const std::array<Expression, 3>& value) {
                std::vector<std::string> items;
                items.reserve(value.size());
                for (const auto& formula : value) items.push_back(toml_quoted(formula.si_text()));
                return detail::toml_list(items);
            }};
}

ValueType<Expression> formula(const std::string& example) {
    const Expected expected(example);
    return {"a formula for " + expected.phrase() + ", or 0",
            [=](const TomlNode& node, const std::string& path) {
                if (node.is_text()) return read_formula(node.text, expected, path);
                read_quantity_node(node, path, expected);  // only 0 passes
                return Expression();
            },
            [](const Expression& value) { return toml_quoted(value.si_text()); }};
}

ValueType<std::array<Value<bool>, 3>> axes() {
    const std::string description = "a list of any of 'x', 'y' and, in 3-D, 'z'";
    return {description,
            [=](const TomlNode& node, const std::string& path) {
                std::array<Value<bool>, 3> value;
                for (const auto& item : detail::list_items(node, path, description)) {
                    value.at(detail::index_of_name(item, path, {"x", "y", "z"})) = {true, item.location};
                }
                detail::refuse_repeated_names(node, path);
                return value;
            },
            [](const std::array<Value<bool>, 3>& value) {
                std::vector<std::string> items;
                if (value[0]) items.emplace_back("\"x\"");
                if (value[1]) items.emplace_back("\"y\"");
                if (value[2]) items.emplace_back("\"z\"");
                return detail::toml_list(items);
            }};
}

ValueType<std::map<std::string, Value<double>>> parameters(double unit) {
    const std::string description = "a table such as { width = \"2 mm\", angle = \"30 deg\", count = 3 }";
    return {description,
            [=](const TomlNode& node, const std::string& path) {
                if (!node.is_table()) throw wrong_kind(node, path, description);
                const Dimension length = Expected("1 m").dimension();
                std::map<std::string, Value<double>> values;
                for (const auto& entry : node.children) {
                    const std::string entry_path = path + "." + entry.key;
                    double value = 0;
                    if (entry.is_text()) {
                        const Quantity found = parse_quantity(entry.text);
                        if (!found.dimension.none() && found.dimension != length) {
                            throw InputError(entry.location,
                                             entry_path + ": found " + entry.shown() + " (" + found.dimension.name() +
                                                 "), expected a length, an angle or a plain number",
                                             "other units are not possible: give a length such as \"2 mm\"");
                        }
                        value = found.dimension.none() ? found.si : found.si / unit;
                    } else {
                        value = read_number(entry, entry_path, any_number, "a length, an angle or a plain number");
                    }
                    values[entry.key] = {value, entry.location};
                }
                return values;
            },
            [](const std::map<std::string, Value<double>>& values) {
                std::string table;
                for (const auto& [key, value] : values) {
                    table += (table.empty() ? " " : ", ") + detail::bare_key_or_quoted(key) + " = " + exact_text(value);
                }
                return "{" + table + (table.empty() ? "}" : " }");
            }};
}

ValueType<Expression> concentration_formula(SpeciesUnit unit) {
    return formula_or_number(unit == SpeciesUnit::none ? "1" : "1 " + to_string(unit));
}

ValueType<Expression> flux_formula(SpeciesUnit unit) {
    switch (unit) {
        case SpeciesUnit::mass:
            return formula("1e-6 kg/m^2/s");
        case SpeciesUnit::moles:
            return formula("1e-6 mol/m^2/s");
        case SpeciesUnit::none:
            break;
    }
    return formula("1e-6 m/s");
}

ValueType<Expression> any_formula(const std::string& example) {
    const std::string description = "a formula such as \"" + example + "\"";
    return {description,
            [description](const TomlNode& node, const std::string& path) {
                if (node.is_text()) return read_formula(node.text, path);
                const std::string number = exact_text(read_number(node, path, any_number, description));
                return Expression(number, number);
            },
            [](const Expression& value) { return toml_quoted(value.si_text()); }};
}

namespace detail {

std::string bare_key_or_quoted(const std::string& key) {
    const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_' || c == '-';
    });
    return bare ? key : toml_quoted(key);
}

std::size_t index_of_name(const TomlNode& node, const std::string& path, const std::vector<std::string>& words) {
    const std::string expected = "one of " + quoted_list(words);
    if (!node.is_text()) throw wrong_kind(node, path, expected);
    const auto found = std::find(words.begin(), words.end(), node.text.text);
    if (found == words.end()) {
        const std::string nearest = nearest_name(node.text.text, words);
        const std::string renamed = advice_for_renamed_value(path, node.text.text);
        throw InputError(node.location, path + ": found " + node.shown() + ", expected " + expected,
                         !renamed.empty()  ? renamed
                         : nearest.empty() ? "write one of these names"
                                           : "did you mean \"" + nearest + "\"?");
    }
    return static_cast<std::size_t>(found - words.begin());
}

const std::vector<TomlNode>& list_items(const TomlNode& node, const std::string& path, const std::string& expected) {
    if (!node.is_array())
        throw wrong_kind(node, path, expected, "put it in brackets: " + last_word(path) + " = [ ... ]");
    return node.children;
}

void refuse_repeated_names(const TomlNode& list, const std::string& path) {
    const auto& items = list.children;
    for (std::size_t i = 1; i < items.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (items[i].text.text == items[j].text.text) {
                throw InputError(items[i].location, path + ": " + items[i].shown() + " occurs twice",
                                 "remove one of them");
            }
        }
    }
}

std::string toml_list(const std::vector<std::string>& items) {
    std::string list;
    for (const auto& item : items) list += (list.empty() ? "" : ", ") + item;
    return "[" + list + "]";
}

}  // namespace detail

}  // namespace dmp::scene
