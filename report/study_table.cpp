// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/study_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "base/csv.hpp"
#include "report/html.hpp"
#include "report/page_frame.hpp"
#include "report/study_plots.hpp"

namespace dmp::report {

namespace {

using Json = JsonValue::Json;

constexpr std::size_t rows_without_scripts = 30;
constexpr std::size_t most_error_length = 300;

/// Null for what is missing.
Json rounded(double value) { return std::isfinite(value) ? Json(std::stod(fmt::format("{:.7g}", value))) : Json(); }

Json columns_of_keys(const StudyFiles& study, const std::vector<std::size_t>& rows) {
    Json keys = Json::array();
    for (std::size_t k = 0; k < study.facts.keys.size(); ++k) {
        const StudyFacts::Key& key = study.facts.keys[k];
        Json values = Json::array();
        for (const std::size_t row : rows) values.push_back(study.rows[row].values[k]);
        keys.push_back({{"name", key.name}, {"unit", key.unit}, {"is_formula", key.is_formula}, {"values", values}});
    }
    return keys;
}

Json columns_of_results(const StudyFiles& study, const std::vector<std::size_t>& rows) {
    Json results = Json::array();
    for (std::size_t k = 0; k < study.facts.results.size(); ++k) {
        Json values = Json::array();
        for (const std::size_t row : rows) values.push_back(rounded(study.rows[row].results[k]));
        results.push_back({{"name", study.facts.results[k].name}, {"unit", study.result_units[k]}, {"values", values}});
    }
    return results;
}

}  // namespace

std::vector<std::size_t> rows_of_page(const StudyFiles& study) {
    const std::size_t columns = 2 + study.facts.keys.size() + study.facts.results.size();
    const std::size_t most = std::max<std::size_t>(most_table_cells / columns, 2), all = study.rows.size();
    std::vector<std::size_t> rows;
    for (std::size_t k = 0; k < std::min(all, most); ++k) rows.push_back(all <= most ? k : k * (all - 1) / (most - 1));
    return rows;
}

std::string study_data(const StudyFiles& study) {
    const std::vector<std::size_t> rows = rows_of_page(study);
    Json runs = Json::array(), failures = Json::object(), errors = Json::array();
    std::map<std::string, std::size_t> known;
    std::string pages;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const StudyRow& row = study.rows[rows[k]];
        runs.push_back(row.run);
        pages += row.has_page ? '1' : '0';
        if (!row.failed()) continue;
        const std::string error = shortened(row.error, most_error_length);
        const auto [at, is_new] = known.emplace(error, errors.size());
        if (is_new) errors.push_back(error);
        failures[std::to_string(k)] = {row.exit_code, at->second};
    }
    const Json json{{"keys", columns_of_keys(study, rows)},
                    {"results", columns_of_results(study, rows)},
                    {"runs", runs},
                    {"failures", failures},
                    {"errors", errors},
                    {"pages", pages},
                    {"plots", plots_json(study)},
                    {"is_scattered", study.facts.is_scattered}};
    return without_markup(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string runs_section(const StudyFiles& study) {
    if (study.rows.empty()) return section("runs", "Runs", "<p>No run has ended yet.</p>\n");
    const std::size_t shown = rows_of_page(study).size();
    std::string text;
    if (shown < study.rows.size())
        text += fmt::format(
            "<p class=\"note\">This page has {} of the {} runs, evenly spaced; results.csv has all of them.</p>\n",
            shown, study.rows.size());
    text +=
        "<div class=\"script-only\"><p>Click a heading to sort; a key with one value in all runs has no column.</p>\n"
        "<div id=\"table-controls\" class=\"controls\"></div>\n<div id=\"run-table\"></div></div>\n";
    std::vector<std::string> heading{"run"};
    for (const StudyFacts::Key& key : study.facts.keys) heading.push_back(csv_heading(key.name, key.unit));
    for (std::size_t k = 0; k < study.facts.results.size(); ++k)
        heading.push_back(csv_heading(study.facts.results[k].name, study.result_units[k]));
    std::vector<std::vector<std::string>> rows;
    for (const StudyRow& row : study.rows) {
        if (rows.size() == rows_without_scripts) break;
        std::vector<std::string>& cells = rows.emplace_back(1, row.run);
        cells.insert(cells.end(), row.values.begin(), row.values.end());
        for (const double value : row.results)
            cells.push_back(std::isfinite(value) ? number_text(value) : row.failed() ? "failed" : "none");
    }
    text += fmt::format(
        "<noscript><p class=\"note\">Plots and the sortable table need JavaScript, which is off in this browser. "
        "results.csv has all {} runs.</p>\n{}</noscript>\n",
        study.rows.size(), table("The first runs", heading, rows));
    return section("runs", "Runs", text);
}

}  // namespace dmp::report
