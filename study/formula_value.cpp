// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/formula_value.hpp"

#include <algorithm>
#include <cctype>

#include "base/csv.hpp"
#include "base/nearest_name.hpp"
#include "scene/formula.hpp"
#include "scene/value_types.hpp"
#include "study/varied_value.hpp"

namespace dmp::study {

namespace {

constexpr std::size_t most_characters = 10'000;
/// Those of a Latin hypercube hardly ever come again: they need not all be kept.
constexpr std::size_t most_known = 10'000;

/// With the values of keys in place of their names.
Quantity quantity_of(const WrittenText& formula, const std::string& subject, const std::vector<VariedKey>& keys,
                     const std::vector<VariedValue>& values, FormulaValues& known) {
    const std::string& text = formula.text;
    std::string filled;
    const auto part_of_key = [&](std::size_t at) {
        return at < text.size() && (text[at] == '.' || end_of_name(text, at) > at || std::isdigit(text[at]) != 0);
    };
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = end_of_number(text, at);
        if (end > at || end_of_name(text, at) == at) {  // a number, an operator, a space
            filled += text.substr(at, std::max(end, at + 1) - at);
            at = std::max(end, at + 1);
            continue;
        }
        for (end = at; part_of_key(end);) ++end;
        const std::string word = text.substr(at, end - at);
        const auto key = std::ranges::find(keys, word, [](const VariedKey& each) { return *each.key; });
        if (key != keys.end()) {
            const VariedValue& value = values[static_cast<std::size_t>(key - keys.begin())];
            if (!value.quantity)
                throw InputError(formula.at(at), subject + ": '" + word + "' is " + value.toml + ", which is no number",
                                 "a formula takes keys with numbers");
            filled += "(" + csv_number(value.quantity->si) + " " + value.quantity->dimension.si_unit() + ")";
        } else if (word.find('.') != std::string::npos) {
            std::vector<std::string> names;
            for (const VariedKey& each : keys) names.push_back(*each.key);
            const std::string nearest = nearest_name(word, names);
            throw InputError(formula.at(at), subject + ": '" + word + "' is not varied above",
                             nearest.empty() ? "a formula takes keys that vary above it: " + quoted_list(names)
                                             : "did you mean '" + nearest + "'?");
        } else {
            filled += word;
        }
        at = end;
    }
    // Columns are those of the text with the numbers in it.
    return known.of({filled, formula.location, {}}, subject);
}

WrittenText read_formula_text(const TomlNode& node) {
    if (node.is_number()) return {node.written, node.location, {}};
    if (!node.is_text()) throw wrong_kind(node, "vary.formula", "a formula in quotes, or a list of them");
    if (node.text.text.size() > most_characters)
        throw InputError(node.location, "vary.formula: it has more than 10 000 characters", "write a shorter formula");
    return node.text;
}

}  // namespace

Quantity FormulaValues::of(const WrittenText& formula, const std::string& subject) {
    if (const auto found = known_.find(formula.text); found != known_.end()) return found->second;
    const Quantity value = constant_formula(formula, subject);
    ++worked_out_;
    if (known_.size() == most_known) known_.clear();
    known_.emplace(formula.text, value);
    return value;
}

void read_formulas(const TomlNode& node, Vary& vary) {
    vary.is_list = node.is_array();
    if (!vary.is_list) {
        if (!node.is_text()) throw wrong_kind(node, "vary.formula", "a formula in quotes, or a list of them");
        vary.formulas.push_back(read_formula_text(node));
        return;
    }
    if (node.children.empty())
        throw InputError(node.location, "vary.formula: the list is empty",
                         "write a formula for each value, such as formula = [\"speed*cos(angle)\", 0]");
    for (const TomlNode& item : node.children) vary.formulas.push_back(read_formula_text(item));
}

VariedValue value_of(const Vary& vary, const std::vector<VariedKey>& keys, const std::vector<VariedValue>& values,
                     FormulaValues& known) {
    const std::string& subject = *vary.keys[0].key;
    if (!vary.is_list) return varied_quantity(quantity_of(vary.formulas[0], subject, keys, values, known));
    VariedValue list;
    for (const WrittenText& formula : vary.formulas)
        list.toml +=
            (list.toml.empty() ? "[" : ", ") + varied_quantity(quantity_of(formula, subject, keys, values, known)).toml;
    list.toml += "]";
    list.cell = list.toml;
    return list;
}

}  // namespace dmp::study
