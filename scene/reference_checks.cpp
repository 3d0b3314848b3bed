// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/reference_checks.hpp"

#include <algorithm>
#include <cmath>

#include "base/nearest_name.hpp"
#include "base/number_text.hpp"
#include "scene/formula.hpp"
#include "scene/measure_columns.hpp"

namespace dmp::scene {

namespace {

/// Evenly spaced times at which a formula is tried.
constexpr int tries = 1000;
/// A line may have thousands of columns.
constexpr std::size_t most_listed = 12;

std::string shown_path(const Reference& reference) {
    return reference.name->empty() ? "reference" : "reference." + *reference.name;
}

/// What `column` may be for the measure: the ends of its columns' names; none of the one that has the measure's name.
std::vector<std::string> column_choices(const Measure& measure, const std::vector<MeasureColumn>& columns) {
    std::vector<std::string> ends;
    for (const MeasureColumn& each : columns)
        if (each.name != *measure.name) ends.push_back(each.name.substr(measure.name->size() + 1));
    return ends;
}

std::string shown_choices(const std::vector<std::string>& ends) {
    if (ends.size() <= most_listed) return quoted_list(ends);
    return "'" + ends[0] + "', '" + ends[1] + "' and so on to '" + ends.back() + "'";
}

MeasureColumn column_of(const Scene& scene, const Reference& reference) {
    const Measure& measure = measure_called(scene, reference.measure);
    const std::vector<MeasureColumn> columns = measure_columns(scene, measure);
    const auto found = std::ranges::find(columns, reference.column_name(), &MeasureColumn::name);
    if (found != columns.end()) return *found;
    const std::string whose = "the measure '" + *measure.name + "' of kind '" + to_string(*measure.kind) + "'";
    const std::vector<std::string> ends = column_choices(measure, columns);
    if (ends.empty()) throw InputError(reference.column.location, whose + " has one column", "remove 'column'");
    if (!reference.column.given())
        throw InputError(reference.measure.location, whose + " has several columns",
                         "add column = \"...\": " + shown_choices(ends));
    const std::string nearest = nearest_name(*reference.column, ends);
    throw InputError(
        reference.column.location, whose + " has no column '" + *reference.column + "'",
        (nearest.empty() ? "" : "did you mean '" + nearest + "'? ") + "Its columns are " + shown_choices(ends));
}

void refuse_second(const Scene& scene, const Reference& reference) {
    for (const Reference& other : scene.references) {
        if (&other == &reference) return;
        if (other.column_name() == reference.column_name())
            throw InputError(reference.measure.location,
                             "there is already a reference for '" + reference.column_name() + "', at " +
                                 other.measure.location.text(),
                             "keep one of them");
        if (!reference.name->empty() && *other.name == *reference.name)
            throw InputError(
                reference.name.location,
                "there is already a reference called '" + *reference.name + "', at " + other.name.location.text(),
                "give each reference its own name");
    }
}

void need_one_origin(const Reference& reference) {
    if (reference.formula.given() != reference.file.given()) return;
    throw InputError(reference.file.given() ? reference.file.location : reference.measure.location,
                     "the reference for '" + reference.column_name() + "' has " +
                         (reference.file.given() ? "a formula and a file" : "neither a formula nor a file"),
                     "give one of them");
}

void check_times(const Reference& reference) {
    if (!reference.until.given() || *reference.from < *reference.until) return;
    throw InputError(reference.until.location,
                     "the reference for '" + reference.column_name() + "' holds from " + exact_text(reference.from) +
                         " s until " + exact_text(reference.until) + " s",
                     "let it begin before its end");
}

void check_formula(const Scene& scene, const Reference& reference, const MeasureColumn& column) {
    const Expression& formula = reference.formula;
    const SourceLocation& at = reference.formula.location;
    // For what it says where the dimension is another.
    static_cast<void>(read_formula({formula.text(), at, {}}, Expected(column.unit == "1" ? "1" : "1 " + column.unit),
                                   shown_path(reference) + ".formula"));
    if (formula.depends_on_position())
        throw InputError(at, "the reference for '" + column.name + "' depends on x, y or z: \"" + formula.text() + "\"",
                         "write a formula of t: a measure has one value at a time");
    const double end = reference.until.given() ? std::min(*reference.until, *scene.run.duration) : *scene.run.duration;
    const double from = reference.from;
    for (int k = 0; k <= tries; ++k) {
        const double time = from + std::max(0.0, end - from) * k / tries;
        if (std::isfinite(formula(time))) continue;
        throw InputError(
            at, "the reference for '" + column.name + "' is no finite number at t = " + number_text(time) + " s",
            "check for a division by zero, or a root or logarithm of a negative number; 'from' and "
            "'until' leave out times at which it does not hold");
    }
}

}  // namespace

void check_references(const Scene& scene) {
    for (const Reference& reference : scene.references) {
        const MeasureColumn column = column_of(scene, reference);
        refuse_second(scene, reference);
        need_one_origin(reference);
        check_times(reference);
        if (reference.formula.given()) check_formula(scene, reference, column);
    }
}

}  // namespace dmp::scene
