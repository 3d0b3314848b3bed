// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/plots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "base/csv.hpp"
#include "base/number_text.hpp"
#include "report/html.hpp"
#include "report/page_frame.hpp"
#include "report/thin.hpp"

namespace dmp::report {

namespace {

using Json = JsonValue::Json;

Curve curve_of(const MeasureSeries& measures, std::size_t column) {
    Curve curve{measures.time, {}};
    curve.value.reserve(measures.rows.size());
    for (const auto& row : measures.rows) curve.value.push_back(row[column]);
    return curve;
}

/// Null for what is missing.
Json rounded(const std::vector<double>& values) {
    Json list = Json::array();
    for (const double value : values)
        list.push_back(std::isfinite(value) ? Json(std::stod(fmt::format("{:.7g}", value))) : Json());
    return list;
}

/// The values of a column at some of the series' times; no number at others.
std::vector<double> values_at(const std::vector<double>& times, const MeasureSeries& series, std::size_t column) {
    std::vector<double> values;
    for (const double time : times) {
        const auto found = std::ranges::lower_bound(series.time, time);
        const bool is_there = found != series.time.end() && *found == time;
        values.push_back(is_there ? series.rows[static_cast<std::size_t>(found - series.time.begin())][column]
                                  : std::numeric_limits<double>::quiet_NaN());
    }
    return values;
}

std::optional<std::size_t> place_of(const std::string& name, const MeasureSeries& series) {
    const auto found = std::ranges::find(series.names, name);
    if (found == series.names.end()) return {};
    return static_cast<std::size_t>(found - series.names.begin());
}

/// " <span>...</span>" for the caption of a plot with a reference.
std::string reference_note(const RunFiles& run, const std::string& column) {
    if (!place_of(column, run.references)) return "";
    std::string text = "dashed: reference";
    for (const JsonValue& each : run.facts()["references"].elements()) {
        if (each["column"].text() != column) continue;
        text += " (" + each["source"].text() + ")";
        if (const double error = each["error"].number(); std::isfinite(error))
            text += "; " + percentage_text(error) + " from it";
    }
    return " <span class=\"note\">" + escaped(text) + "</span>";
}

std::string extremes_table(const RunFiles& run) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& [name, of] : run.facts()["measures"].members())
        rows.push_back({csv_heading(name, of["unit"].text()), number_text(of["min"].number()),
                        number_text(of["max"].number()), number_text(of["mean"].number()),
                        number_text(of["last"].number()), number_text(of["missing"].number())});
    return rows.empty() ? ""
                        : table("Extremes of the measures",
                                {"measure", "smallest", "largest", "mean", "last", "rows without a value"}, rows);
}

}  // namespace

std::size_t points_of_each(std::size_t plots) {
    return std::clamp(most_points_of_page / std::max<std::size_t>(plots, 1), std::size_t{50}, most_points);
}

std::string plot_data(const MeasureSeries& measures, const MeasureSeries& references) {
    Json list = Json::array();
    for (std::size_t column = 0; column < measures.names.size(); ++column) {
        const Curve curve = thinned(curve_of(measures, column), points_of_each(measures.names.size()));
        list.push_back({{"name", measures.names[column]},
                        {"unit", measures.units[column]},
                        {"time", rounded(curve.time)},
                        {"value", rounded(curve.value)}});
        if (const auto reference = place_of(measures.names[column], references))
            list.back()["reference"] = rounded(values_at(curve.time, references, *reference));
    }
    return without_markup(Json{{"measures", list}}.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string measures_section(const RunFiles& run) {
    std::string text;
    if (run.measures && !run.measures->rows.empty()) {
        const MeasureSeries& measures = *run.measures;
        text +=
            "<noscript><p class=\"note\">The plots need JavaScript, which is off in this browser. The table below, the "
            "picture of the measures and measures.csv hold the values.</p></noscript>\n"
            "<p class=\"script-only\">The values at the pointer stand below each plot. Drag across a plot to zoom in, "
            "double-click to see all. With the keyboard, in a plot: arrow keys move the pointer, + and - zoom, 0 shows "
            "all. <button type=\"button\" id=\"show-all\">Show all</button></p>\n";
        const std::size_t most = points_of_each(measures.names.size());
        if (measures.rows.size() > most)
            text += fmt::format(
                "<p class=\"note\">Plots show at most {} of the {} rows: the smallest and the largest value and gaps "
                "of "
                "each of {} stretches of time. measures.csv has all rows.</p>\n",
                most, measures.rows.size(), (most - 2) / 3);
        text += "<div class=\"plots\">\n";
        for (std::size_t k = 0; k < measures.names.size(); ++k) {
            const std::string name = escaped(csv_heading(measures.names[k], measures.units[k]));
            text += fmt::format(
                "<figure><figcaption>{0}{2}</figcaption><div class=\"plot\" data-measure=\"{1}\" tabindex=\"0\" "
                "role=\"group\" aria-label=\"Plot of {0} over time\"></div></figure>\n",
                name, k, reference_note(run, measures.names[k]));
        }
        text += "</div>\n";
    } else {
        text += "<p>No values over time are there.</p>\n";
    }
    return section("measures", "Measures", text + extremes_table(run));
}

}  // namespace dmp::report
