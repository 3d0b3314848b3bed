// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/read_result.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/nearest_name.hpp"
#include "scene/measure_columns.hpp"
#include "study/measure_columns.hpp"
#include "study/toml_table.hpp"

namespace dmp::study {

namespace {

ValueType<double> time_from_zero() { return quantity("0.2 s", not_negative); }

void check_column(const Result& result, const Measure& measure, const Study& study) {
    const std::string kind = to_string(*measure.kind);
    const auto count = columns_of(*measure.kind).count;
    if (count == MeasureColumns::Count::one && result.column.given())
        throw InputError(result.column.location,
                         "the measure '" + *result.measure + "' of kind '" + kind + "' has one column",
                         "remove 'column'");
    if (count == MeasureColumns::Count::several && !result.column.given())
        throw InputError(result.measure.location,
                         "the measure '" + *result.measure + "' of kind '" + kind + "' has several columns",
                         "add column = \"...\", the end of its name in measures.csv after '" + *result.measure + "_'");

    // Where measures, fields or the dimension vary, only a run can tell.
    const bool may_vary = std::ranges::any_of(study.keys(), [](const VariedKey& varied) {
        return *varied.key == "dimension" || varied.key->starts_with("measure.") ||
               varied.key->starts_with("species.") || varied.key->starts_with("output.");
    });
    if (may_vary) return;
    std::vector<std::string> endings;
    for (const MeasureColumn& each : measure_columns(study.scene, measure)) {
        if (each.name == result.column_name()) return;
        if (each.name.size() > result.measure->size()) endings.push_back(each.name.substr(result.measure->size() + 1));
    }
    const std::string named = "the measure '" + *result.measure + "'";
    if (endings.empty()) throw InputError(result.column.location, named + " has one column", "remove 'column'");
    const std::string found =
        result.column.given() ? " has no column '" + *result.column + "', only " : " has the columns ";
    throw InputError(result.column.given() ? result.column.location : result.measure.location,
                     named + found + quoted_list(endings),
                     "write column = \"" + endings.front() + "\" or another of them");
}

/// Whether a key is for the reduction; says so where it is missing or not for it.
bool needed(const TomlTable& table, const std::string& key, const std::string& expected, Reduction reduction,
            std::initializer_list<Reduction> with) {
    const bool wanted = std::ranges::find(with, reduction) != with.end();
    if (wanted) static_cast<void>(table.need(key, expected));
    if (const TomlNode* given = table.find(key); given != nullptr && !wanted) {
        std::vector<std::string> names;
        for (const Reduction each : with) names.emplace_back(to_string(each));
        throw InputError(given->key_location,
                         "'" + key + "' does not apply to reduce = \"" + std::string(to_string(reduction)) +
                             "\", only to " + quoted_list(names),
                         "remove it, or correct 'reduce'");
    }
    return wanted;
}

Value<Quantity> read_level(const TomlNode& node) {
    if (node.is_number()) return {Quantity{node.number, {}}, node.location};
    if (node.is_text()) return {parse_quantity(node.text), node.location};
    throw wrong_kind(node, "result.level", "a number, with the unit of the measure if it has one");
}

bool duration_varies(const Study& study) {
    return std::ranges::any_of(study.keys(), [](const VariedKey& key) { return *key.key == "run.duration"; });
}

/// The window against the run, where all runs have the same duration.
void check_window(const Result& result, const Study& study) {
    const bool varies = duration_varies(study);
    if (varies && !result.until.given()) return;
    const double duration = *study.scene.run.duration;
    const double until = result.until.given() ? *result.until : duration;
    const auto seconds = [](double value) { return exact_text(value) + " s"; };
    if (!varies && until > duration * (1 + 1e-9))
        throw InputError(result.until.location,
                         "result.until: the runs end at " + seconds(duration) + ", before " + seconds(until),
                         "give a time until then, or a longer run.duration in the scene");
    if (!(*result.from < until))
        throw InputError(
            result.from.given() ? result.from.location : result.until.location,
            "the result '" + *result.name + "' is taken from " + seconds(*result.from) + " until " + seconds(until),
            "let it begin before its end");
    if (result.period.given() && until - *result.from < *result.period * (1 - 1e-9))
        throw InputError(result.period.location,
                         "result.period: the window of " + seconds(until - *result.from) + " is shorter than the " +
                             "period of " + seconds(*result.period),
                         "give a longer window, or the right period");
}

void check_is_new(const Value<std::string>& name, const Study& study) {
    for (const Result& other : study.results)
        if (*other.name == *name)
            throw InputError(name.location, "there are two results '" + *name + "'",
                             "give each result a name of its own: it is a column of results.csv");
}

/// One result of each time of this length [s], NAME_1, NAME_2 and so on.
std::vector<Result> split(const Result& whole, const Value<double>& every, const Study& study) {
    if (!whole.until.given() && duration_varies(study))
        throw InputError(every.location, "result.every: run.duration varies, and with it how many columns there are",
                         "add 'until' to the result");
    const double until = whole.until.given() ? *whole.until : *study.scene.run.duration, window = until - *whole.from;
    const double count = std::round(window / *every);
    if (count < 1 || std::abs(window - count * *every) > 1e-6 * *every)
        throw InputError(every.location,
                         "result.every: the window of " + exact_text(window) + " s does not divide into parts of " +
                             exact_text(*every) + " s",
                         "change 'from', 'until' or 'every'");
    if (whole.period.given() && *every < *whole.period * (1 - 1e-9))
        throw InputError(every.location,
                         "result.every: parts of " + exact_text(*every) + " s are shorter than the period of " +
                             exact_text(*whole.period) + " s",
                         "give longer parts, or the right period");
    constexpr double most = 1000;
    if (count > most)
        throw InputError(
            every.location,
            "result.every: it makes " + exact_text(count) + " columns of results.csv, more than " + exact_text(most),
            "give longer parts, or a shorter window");
    const auto end_of = [&](int k) { return k == count ? until : *whole.from + window * k / count; };
    std::vector<Result> parts;
    for (int k = 1; k <= static_cast<int>(count); ++k) {
        Result part = whole;
        part.name.value = *whole.name + "_" + std::to_string(k);
        check_is_new(part.name, study);
        part.from = {end_of(k - 1), every.location};
        part.until = {end_of(k), every.location};
        parts.push_back(std::move(part));
    }
    return parts;
}

}  // namespace

std::vector<Result> read_results(const TomlNode& node, const Study& study) {
    const TomlTable table(node, "result",
                          {"name", "measure", "column", "reduce", "from", "until", "every", "level", "period"});
    Result result;
    result.name = table.need("name", name());
    for (const std::string reserved : {"run", "exit_code", "error"})
        if (*result.name == reserved)
            throw InputError(result.name.location, "a result may not have the name '" + reserved + "'",
                             "give another name: results.csv has a column of this one");
    result.measure = table.need("measure", name());
    const Measure& measure = measure_called(study.scene, result.measure);
    result.column = table.read("column", text_not_empty(), result.column);
    check_column(result, measure, study);
    result.reduce = table.need("reduce", one_of<Reduction>());
    result.from = table.read("from", time_from_zero(), result.from);
    result.until = table.read("until", time_from_zero(), result.until);
    if (needed(table, "level", "the value to reach, in the unit of the measure", *result.reduce,
               {Reduction::first_crossing})) {
        result.level = read_level(*table.find("level"));
        if (const std::string unit = columns_of(*measure.kind).unit; !unit.empty())
            static_cast<void>(level_in(result, unit));
    }
    if (needed(table, "period", "a time such as \"1 s\"", *result.reduce, {Reduction::amplitude, Reduction::phase}))
        result.period = table.need("period", quantity("1 s", positive));
    check_window(result, study);
    if (table.find("every") != nullptr) return split(result, table.need("every", quantity("1 s", positive)), study);
    check_is_new(result.name, study);
    return {result};
}

double level_in(const Result& result, const std::string& unit) {
    const Quantity& level = *result.level;
    const Dimension wanted = parse_quantity({"1 " + unit, {}, {}}).dimension;
    if (level.dimension != wanted && !(level.si == 0 && level.dimension.none()))
        throw InputError(result.level.location,
                         "result.level: found " + level.dimension.name_with_article() + ", but '" +
                             result.column_name() + "' is " + wanted.name_with_article(),
                         "give it in " + unit + ", or another unit of the same quantity");
    return level.si;
}

}  // namespace dmp::study
