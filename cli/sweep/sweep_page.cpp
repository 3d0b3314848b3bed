// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep_page.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "base/shell_word.hpp"
#include "base/text_lines.hpp"
#include "base/unlisted_value.hpp"
#include "cli/run_log.hpp"
#include "cli/sweep/sweep_table.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "report/html.hpp"
#include "report/study_files.hpp"
#include "report/write_report.hpp"
#include "study/csv_table.hpp"
#include "study/read_plot.hpp"
#include "study/values_taken.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_values_listed = 12;

/// "0.8", "1e-06, 2e-06, 3e-06", "20 values from 0.1 to 1".
std::string values_text(const study::ValuesTaken& taken) {
    std::string text;
    if (taken.count <= most_values_listed && taken.count == taken.values.size()) {
        for (const study::VariedValue& value : taken.values)
            text += (text.empty() ? "" : ", ") + short_cell(value.cell);
    } else if (taken.are_numbers()) {
        const auto [low, high] =
            std::ranges::minmax(taken.values, {}, [](const study::VariedValue& value) { return value.quantity->si; });
        text = fmt::format("{} values from {} to {}", taken.count, short_cell(low.cell), short_cell(high.cell));
    } else {
        text = fmt::format("{} values: {}, {}, ...", taken.count, taken.values[0].cell, taken.values[1].cell);
    }
    if (taken.log_range) text += " (of equal ratios)";
    return text;
}

std::string combination_text(const study::Study& study, std::size_t runs) {
    const std::string count = count_text(runs, "run");
    switch (*study.combine) {
        case study::Combine::grid:
            return count + ": each value with each.";
        case study::Combine::zip:
            return count + ": the first values of all keys together, the second ones, and so on.";
        case study::Combine::latin_hypercube:
            return count + ", spread over the ranges of all keys (a Latin hypercube, seed " +
                   std::to_string(*study.seed) + ").";
    }
    unlisted_value(*study.combine);
}

/// "maximum of tip_gap from 1 s until the end".
std::string meaning_of(const study::Result& result) {
    std::string text = std::string(to_string(*result.reduce)) + " of " + result.column_name();
    if (result.level.given())
        text += fmt::format(", level {:.6g} {}", result.level->si, result.level->dimension.si_unit());
    if (result.period.given()) text += ", period " + quantity_text(*result.period, "s");
    if (!result.from.given() && !result.until.given()) return text + ", over the whole run";
    return text + ", from " + quantity_text(*result.from, "s") + " until " +
           (result.until.given() ? quantity_text(*result.until, "s") : "the end");
}

/// Units of the columns of results.csv, by name.
std::map<std::string, std::string> units_in(const std::string& results_csv) {
    std::map<std::string, std::string> units;
    const std::vector<std::string> lines = text_lines(results_csv);
    if (lines.empty()) return units;
    for (const std::string& heading : csv_cells(lines.front())) units.insert(name_and_unit(heading));
    return units;
}

/// Why the points of a reference cannot stand in a plot of results in this unit; "": they can, or nobody knows yet.
std::string problem_of(const study::ReferencePoints& points, const std::string& unit) {
    if (unit.empty()) return "";
    try {
        const Dimension dimension = study::dimension_of(unit);
        if (dimension == points.y_dimension) return "";
        return "they are " + points.y_dimension.name_with_article() + ", the result is " +
               dimension.name_with_article();
    } catch (const InputError&) {
        return "the unit of the result, " + unit + ", is not known";
    }
}

}  // namespace

StudyFacts study_facts(const study::Study& study, const study::Points& points, const std::string& results_csv) {
    StudyFacts facts;
    facts.title = study.title.empty() ? study.name : study.title;
    facts.purpose = study.purpose;
    facts.study_file = fs::path(study.file).filename().string();
    facts.scene_file = *study.scene_path;
    facts.scene_title = *study.scene.title;
    facts.combination = combination_text(study, points.size());
    facts.runs = points.size();
    const std::vector<study::VariedKey> keys = study.keys();
    const std::vector<study::ValuesTaken> taken = study::values_taken(study, points);
    for (std::size_t k = 0; k < keys.size(); ++k)
        facts.keys.push_back({*keys[k].key, keys[k].unit, values_text(taken[k]), taken[k].is_formula});
    const auto axes = std::ranges::count_if(study.vary, [](const study::Vary& vary) { return vary.is_axis(); });
    facts.is_scattered = *study.combine == study::Combine::latin_hypercube && axes > 1;
    for (const study::Result& result : study.results) facts.results.push_back({*result.name, meaning_of(result)});
    facts.default_plots = study.plots.empty();
    const std::map<std::string, std::string> units = units_in(results_csv);
    for (const study::Plot& plot : facts.default_plots ? study::default_plots(study, points) : study.plots) {
        StudyFacts::Plot& to = facts.plots.emplace_back(
            StudyFacts::Plot{plot.title, plot.result, plot.key, plot.lines_by, plot.log_x, plot.log_y, {}});
        const auto unit = units.find(plot.result);
        if (plot.reference)
            to.references.push_back({*plot.reference->file, plot.reference->x, plot.reference->y,
                                     problem_of(*plot.reference, unit == units.end() ? "" : unit->second)});
    }
    return facts;
}

void begin_sweep_page(const fs::path& folder, const study::Study& study, const study::Points& points,
                      const TypedCommand& typed) {
    write_study_facts(folder, study_facts(study, points, ""));
    static_cast<void>(RunLog(folder, typed.text(), study_log_name));
}

std::string write_sweep_page(const fs::path& folder, const study::Study& study, const study::Points& points) {
    try {
        const fs::path table = folder / sweep_results_name;
        const StudyFacts facts = study_facts(study, points, fs::is_regular_file(table) ? read_file(table) : "");
        for (const StudyFacts::Plot& plot : facts.plots)
            for (const StudyFacts::Reference& of : plot.references)
                if (!of.problem.empty())
                    print_error(Style(Stream::error).warning("warning") + ": the points of " + of.file +
                                " are not plotted: " + of.problem + "\n");
        write_study_facts(folder, facts);
        write_study_report(folder);
    } catch (const Error& error) {
        print_error(Style(Stream::error).warning("warning") +
                    fmt::format(": the study's page {} was not written: {}\n", report_file_name, error.problem()));
        return "";
    }
    return shell_word((folder / report_file_name).string()) + "   the page of the study, for a browser";
}

}  // namespace dmp::cli
