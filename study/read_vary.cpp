// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/read_vary.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include "base/csv.hpp"
#include "base/nearest_name.hpp"
#include "base/safe_file.hpp"
#include "base/text_lines.hpp"
#include "scene/formula.hpp"
#include "scene/value_check.hpp"
#include "study/formula_value.hpp"
#include "study/points.hpp"
#include "study/toml_table.hpp"
#include "study/varied_value.hpp"

namespace dmp::study {

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> sources{"values", "range", "formula", "table"};

InputError mixed_dimensions(const SourceLocation& location, const std::string& key, const Quantity& first,
                            const Quantity& other) {
    return {location,
            key + ": found " + other.dimension.name_with_article() + " after " + first.dimension.name_with_article(),
            "give all its values in units of the same quantity"};
}

/// Whether both are numbers of one dimension; a bare 0 has any.
bool go_together(const Quantity& a, const Quantity& b) {
    const auto bare_zero = [](const Quantity& q) { return q.si == 0 && q.dimension.none(); };
    return a.dimension == b.dimension || bare_zero(a) || bare_zero(b);
}

/// Checks the values of one key as they come.
class KeyValues {
  public:
    KeyValues(const Study& study, VariedKey& key) : key_(key), unique_(*study.combine == Combine::grid) {
        if (key.is_of_scene) check_.emplace(study.scene, key.key, key.key.location);
    }

    VariedValue add(const TomlNode& node) {
        check(node);
        VariedValue value = varied_value(node, key_.unit);
        if (value.quantity) {
            if (first_ && !go_together(*first_, *value.quantity))
                throw mixed_dimensions(node.location, *key_.key, *first_, *value.quantity);
            if (!first_ || first_->dimension.none()) first_ = value.quantity;
        }
        return value;
    }
    /// Of a list for a grid, where the same value twice would make the same runs twice.
    VariedValue add_once(const TomlNode& node) {
        VariedValue value = add(node);
        if (unique_ && !seen_.insert(value.cell).second)
            throw InputError(node.location, *key_.key + ": the value " + node.shown() + " is given twice",
                             "remove one of them: a grid would hold the same runs twice");
        return value;
    }
    void check(const TomlNode& node) const {
        if (check_) (*check_)(node);
    }

  private:
    std::optional<ValueCheck> check_;  ///< none of a name of the study's own, which may be anything
    VariedKey& key_;
    bool unique_;
    std::optional<Quantity> first_;
    std::set<std::string> seen_;
};

/// A bare 0 is of the quantity that the key's unit is of: what is worked out from it has a unit, too.
void give_zeros_a_dimension(Vary& vary) {
    for (std::size_t column = 0; column < vary.keys.size(); ++column) {
        const std::string& unit = vary.keys[column].unit;
        if (unit.empty()) continue;
        const Dimension dimension = parse_quantity({"1 " + unit, {}, {}}).dimension;
        for (auto& row : vary.rows)
            if (auto& quantity = row[column].quantity; quantity && quantity->si == 0) quantity->dimension = dimension;
    }
}

void check_keys(const Vary& vary, const Study& study) {
    for (const VariedKey& key : vary.keys)
        if (*key.key == "run.threads")
            throw InputError(key.key.location, "'run.threads' cannot vary: no result depends on it",
                             "set run.threads in the scene: it is taken for all runs of the study");
    std::set<std::string> names;
    for (const VariedKey& key : study.keys()) names.insert(*key.key);
    for (const VariedKey& key : vary.keys)
        if (!names.insert(*key.key).second)
            throw InputError(key.key.location, "the key '" + *key.key + "' is varied twice",
                             "give each key one [[vary]], or one column of a table");
}

void read_values(const TomlNode& list, const Study& study, Vary& vary) {
    const std::string advice = "write a list such as values = [\"0.1 mm\", \"0.2 mm\"]";
    if (!list.is_array()) throw wrong_kind(list, "vary.values", "a list of values", advice);
    if (list.children.empty()) throw InputError(list.location, "vary.values: the list is empty", advice);
    KeyValues values(study, vary.keys.front());
    for (const TomlNode& item : list.children) vary.rows.push_back({values.add_once(item)});
}

/// An end of a range, which must be a number.
VariedValue read_end(const TomlTable& table, const std::string& which, KeyValues& values) {
    const TomlNode& node = table.need(which, "where the range " + std::string(which == "from" ? "begins" : "ends"));
    VariedValue end = values.add(node);
    if (!end.quantity) throw wrong_kind(node, table.path_of(which), "a number, with its unit if it has one");
    return end;
}

void read_range(const TomlNode& node, const Study& study, Vary& vary) {
    const TomlTable table(node, "vary.range", {"from", "to", "steps", "scale"});
    VariedKey& key = vary.keys.front();
    KeyValues values(study, key);
    const VariedValue from = read_end(table, "from", values), to = read_end(table, "to", values);
    const bool quoted = table.find("from")->is_text() || table.find("to")->is_text();
    const NumberRange range{number_in_unit(from.quantity->si, key.unit), number_in_unit(to.quantity->si, key.unit),
                            *table.read("scale", one_of<Scale>(), Value<Scale>(Scale::linear)), quoted};
    if (range.from == range.to)
        throw InputError(node.location, *key.key + ": the range is empty, it begins and ends at " + from.cell,
                         "give two different ends, or write values = [...] for a single one");
    if (range.scale == Scale::log && !(range.from * range.to > 0))
        throw InputError(node.location, *key.key + ": a logarithmic range from " + from.cell + " to " + to.cell,
                         "give two ends above 0, or write scale = \"linear\"");
    const auto checked = [&](double k, double count) {
        VariedValue value = varied_number(number_of(range, k, count), key.unit, quoted);
        values.check(parse_toml_value(value.toml, node.location));
        return value;
    };
    if (*study.combine == Combine::latin_hypercube) {
        if (const TomlNode* steps = table.find("steps"))
            throw InputError(steps->key_location, "steps have no meaning in a Latin hypercube",
                             "remove them: 'samples' at the top says how many values there are");
        static_cast<void>(checked(0.37, 2));  // a key of whole numbers refuses it here, not in the runs
        vary.range = range;
        return;
    }
    const int steps = *table.need("steps", integer(between(2, most_runs)));
    for (int k = 0; k < steps; ++k) vary.rows.push_back({checked(k, steps)});
    vary.log_range = range.scale == Scale::log && range.from > 0;
}

void read_csv_table(const TomlNode& node, const Study& study, Vary& vary) {
    const std::string name = text_not_empty().read(node, "vary.table");
    const std::string file = (fs::path(study.file).parent_path() / name).string();
    if (!fs::is_regular_file(file))
        throw InputError(node.location, "vary.table: there is no file '" + file + "'",
                         "give a CSV file relative to the folder of the study");
    const std::vector<std::string> lines = text_lines(read_file(file));
    SourceLocation location{file, 1, 1};
    if (lines.empty())
        throw InputError(location, "the table is empty", "write a heading 'KEY [UNIT],...' and a line for each run");
    for (const std::string& heading : csv_cells(lines.front())) {
        const auto [key, unit] = name_and_unit(heading);
        vary.keys.push_back({Value<std::string>(key, location), unit});
    }
    check_keys(vary, study);
    std::vector<KeyValues> columns;
    for (VariedKey& key : vary.keys) columns.emplace_back(study, key);
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        location.line = static_cast<int>(i) + 1;
        const std::vector<std::string> cells = csv_cells(lines[i]);
        if (cells.size() != vary.keys.size())
            throw InputError(
                location,
                "found " + std::to_string(cells.size()) + " values, expected " + std::to_string(vary.keys.size()),
                "give each line a value for each key of the heading");
        std::vector<VariedValue>& row = vary.rows.emplace_back();
        for (std::size_t column = 0; column < cells.size(); ++column) {
            const std::string& unit = vary.keys[column].unit;
            const std::string text = unit.empty() ? cells[column] : toml_quoted(cells[column] + " " + unit);
            row.push_back(columns[column].add(parse_toml_value(text, location)));
        }
    }
    if (vary.rows.empty())
        throw InputError(location, "the table has a heading only", "write a line for each run below it");
}

void read_formula_of(const TomlNode& node, const Study& study, Vary& vary) {
    read_formulas(node, vary);
    // For the first run; its unit is that of all.
    const std::vector<VariedKey> above = study.keys();
    std::vector<VariedValue> values;
    FormulaValues known;
    for (const Vary& each : study.vary) {
        if (!each.is_axis())
            values.push_back(value_of(each, above, values, known));
        else if (each.range)
            values.push_back(varied_number(each.range->from, each.keys[0].unit, each.range->quoted));
        else
            values.insert(values.end(), each.rows.front().begin(), each.rows.front().end());
    }
    VariedKey& key = vary.keys.front();
    const VariedValue value = value_of(vary, above, values, known);
    if (value.quantity) key.unit = value.quantity->dimension.si_unit();
    if (key.is_of_scene)
        ValueCheck(study.scene, *key.key, key.key.location)(parse_toml_value(value.toml, node.location));
}

/// A key of the scene, or a name of the study's own.
VariedKey read_key(const TomlTable& table) {
    const TomlNode* own = table.find("name");
    if (own == nullptr) return {table.need("key", text_not_empty()), ""};
    if (table.find("key") != nullptr)
        throw InputError(own->key_location, "[[vary]] has a 'key' and a 'name', expected one of them",
                         "give 'key' for a key of the scene, 'name' for a value that formulas below it take");
    VariedKey key{table.need("name", name()), "", false};
    if (is_formula_word(*key.key))
        throw InputError(key.key.location, "'" + *key.key + "' has a meaning in formulas already",
                         "choose another name: none of a unit, a function, t, x, y, z or pi");
    return key;
}

}  // namespace

Vary read_vary(const TomlNode& node, const Study& study) {
    const TomlTable table(node, "vary", {"key", "name", "values", "range", "formula", "table"});
    std::vector<std::string> given;
    for (const std::string& source : sources)
        if (table.find(source) != nullptr) given.push_back(source);
    if (given.size() != 1)
        throw InputError(table.location(),
                         given.empty() ? "[[vary]] does not say which values its key takes"
                                       : "[[vary]] has " + quoted_list(given) + ", expected one of them",
                         "give exactly one of " + quoted_list(sources));
    const std::string& source = given.front();
    Vary vary;
    vary.location = table.location();
    if (source == "table") {
        for (const char* heading : {"key", "name"})
            if (const TomlNode* key = table.find(heading))
                throw InputError(key->key_location, "[[vary]] has a '" + std::string(heading) + "' besides its table",
                                 "remove it: the heading of the table names the keys");
    } else {
        vary.keys.push_back(read_key(table));
        check_keys(vary, study);
    }
    const TomlNode& values = *table.find(source);
    if (source == "values") read_values(values, study, vary);
    if (source == "range") read_range(values, study, vary);
    if (source == "formula") read_formula_of(values, study, vary);
    if (source == "table") read_csv_table(values, study, vary);
    give_zeros_a_dimension(vary);
    return vary;
}

}  // namespace dmp::study
