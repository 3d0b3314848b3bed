// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/varied_value.hpp"

#include <charconv>
#include <cmath>

#include "base/csv.hpp"
#include "base/number_text.hpp"

namespace dmp::study {

namespace {

double number_from(const std::string& text) {
    double number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

double rounded(double value, int digits) { return number_from(number_text(value, digits)); }

/// None where the text is no number with or without a unit.
std::optional<Quantity> quantity_in(const std::string& text) {
    try {
        return parse_quantity({text, {}, {}});
    } catch (const InputError&) {
        return {};
    }
}

/// The number of a text that is a quantity, in its own unit.
double number_in(const std::string& text) {
    std::size_t at = skip_spaces(text, 0);
    const bool negative = at < text.size() && text[at] == '-';
    if (negative || text[at] == '+') at = skip_spaces(text, at + 1);
    const double number = number_from(text.substr(at, end_of_number(text, at) - at));
    return negative ? -number : number;
}

}  // namespace

std::string unit_in(const std::string& text) {
    std::size_t at = skip_spaces(text, 0);
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) at = skip_spaces(text, at + 1);
    const std::string unit = text.substr(skip_spaces(text, end_of_number(text, at)));
    return unit.substr(0, unit.find_last_not_of(" \t") + 1);
}

double number_in_unit(double si, const std::string& unit) {
    return unit.empty() ? si : rounded(si / parse_quantity({"1 " + unit, {}, {}}).si, 15);
}

VariedValue varied_value(const TomlNode& node, std::string& unit) {
    VariedValue value{toml_text(node), "", {}};
    if (node.is_number()) {
        value.quantity = Quantity{node.number, {}};
        value.cell = csv_number(node.number);
        return value;
    }
    if (node.is_text()) value.quantity = quantity_in(node.text.text);
    if (!value.quantity) {
        value.cell = node.is_text() ? node.text.text : value.toml;
        return value;
    }
    const std::string own = unit_in(node.text.text);
    if (unit.empty()) unit = own;
    value.cell = csv_number(own == unit ? number_in(node.text.text) : number_in_unit(value.quantity->si, unit));
    return value;
}

VariedValue varied_number(double number, const std::string& unit, bool quoted) {
    const std::string text = csv_number(number);
    const std::string with_unit = unit.empty() ? text : text + " " + unit;
    return {quoted ? toml_quoted(with_unit) : text, text, parse_quantity({with_unit, {}, {}})};
}

VariedValue varied_quantity(const Quantity& quantity) {
    const std::string text = csv_number(quantity.si), unit = quantity.dimension.si_unit();
    return {unit.empty() ? text : toml_quoted(text + " " + unit), text, quantity};
}

double number_of(const NumberRange& range, double k, double count) {
    const double last = count - 1;
    if (k <= 0) return range.from;
    if (k >= last) return range.to;
    const double between = range.scale == Scale::log ? range.from * std::pow(range.to / range.from, k / last)
                                                     : (range.from * (last - k) + range.to * k) / last;
    return rounded(between, 12);
}

}  // namespace dmp::study
