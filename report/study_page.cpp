// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/study_page.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>

#include <fmt/format.h>

#include "base/csv.hpp"
#include "report/embedded.hpp"
#include "report/html.hpp"
#include "report/limits_section.hpp"
#include "report/page_frame.hpp"
#include "report/study_plots.hpp"
#include "report/study_table.hpp"
#include "report/trade_section.hpp"
#include "report/write_report.hpp"

namespace dmp::report {

namespace {

using Items = std::vector<std::pair<std::string, std::string>>;

constexpr std::size_t most_kinds_of_failure = 20, most_runs_named = 6;

std::string count(std::size_t number, const std::string& word) {
    return fmt::format("{} {}{}", number, word, number == 1 ? "" : "s");
}

std::string title_of(const StudyFiles& study) {
    return study.facts.title.empty() ? study.folder.lexically_normal().filename().string() : study.facts.title;
}

/// Of a study of limits, which runs few of its runs.
std::pair<std::string, std::string> state_of(const LimitsFacts& limits, std::size_t runs) {
    const auto left =
        static_cast<std::size_t>(std::ranges::count(limits.dials, LimitWay::not_measured, &LimitsFacts::Dial::way));
    const auto unseen =
        static_cast<std::size_t>(std::ranges::count(limits.dials, LimitWay::no_measure, &LimitsFacts::Dial::way));
    const std::string all = count(limits.dials.size() - unseen, "limit");
    if (left > 0)
        return {"interrupted", fmt::format("Not complete: {} of {} measured, by {}",
                                           limits.dials.size() - unseen - left, all, count(runs, "run"))};
    return {"complete", fmt::format("Complete: {} measured, by {}", all, count(runs, "run"))};
}

/// A class of page.css, and what to say.
std::pair<std::string, std::string> state_of(const StudyFiles& study) {
    if (study.limits) return state_of(*study.limits, study.rows.size());
    const std::size_t ended = study.rows.size(), failed = study.failed();
    const std::string but = failed == 0 ? "" : fmt::format(", {} failed", failed);
    if (ended < study.facts.runs)
        return {"interrupted",
                fmt::format("Not complete: {} of {} ended{}", ended, count(study.facts.runs, "run"), but)};
    return {failed == 0 ? "complete" : "interrupted", fmt::format("Complete: {}{}", count(ended, "run"), but)};
}

std::string head(const StudyFiles& study) {
    const auto [kind, state] = state_of(study);
    Items items;
    if (!study.facts.purpose.empty()) items.emplace_back("purpose", study.facts.purpose);
    items.emplace_back("scene", study.facts.scene_title.empty()
                                    ? study.facts.scene_file
                                    : study.facts.scene_title + " (" + study.facts.scene_file + ")");
    items.emplace_back("dmp version", study.log.starts.empty() ? "not known" : study.log.starts.back().version);
    items.emplace_back("started", study.log.starts.empty() ? "not known" : study.log.starts.front().when);
    for (std::size_t k = 1; k < study.log.starts.size(); ++k) items.emplace_back("resumed", study.log.starts[k].when);
    items.emplace_back("folder", study.folder.lexically_normal().filename().string());
    return fmt::format("<header><h1>{}</h1>\n<p class=\"state {}\">{}</p>\n{}</header>\n", escaped(title_of(study)),
                       kind, escaped(state), list(items));
}

std::string what_was_studied(const StudyFiles& study) {
    std::vector<std::vector<std::string>> keys, results;
    for (const StudyFacts::Key& key : study.facts.keys) keys.push_back({csv_heading(key.name, key.unit), key.values});
    for (std::size_t k = 0; k < study.facts.results.size(); ++k)
        results.push_back(
            {csv_heading(study.facts.results[k].name, study.result_units[k]), study.facts.results[k].meaning});
    std::string text = "<p>" + escaped(study.facts.combination) + "</p>\n" +
                       table("Keys of the scene that were varied or set", {"key", "values"}, keys, 2);
    if (!results.empty()) text += table("What was kept of each run", {"result", "meaning"}, results, 2);
    return section("what", "What was studied", text);
}

std::string link_to(const StudyRow& row) {
    if (!row.has_page) return escaped(row.run);
    return fmt::format("<a href=\"runs/{0}/{1}\">{0}</a>", escaped(row.run), report_file_name);
}

/// "particles.spacing 0.8 mm, quality draft": what varies of the keys of a run.
std::string values_text(const StudyFiles& study, const StudyRow& row) {
    std::string text;
    for (std::size_t k = 0; k < study.facts.keys.size(); ++k) {
        const auto differs = [&](const StudyRow& other) { return other.values[k] != study.rows.front().values[k]; };
        if (std::ranges::none_of(study.rows, differs)) continue;
        const StudyFacts::Key& key = study.facts.keys[k];
        text += (text.empty() ? "" : ", ") + key.name + " " + short_cell(row.values[k]) +
                (key.unit.empty() ? "" : " " + key.unit);
    }
    return text;
}

std::string pictures_section(const StudyFiles& study) {
    if (study.pictures.empty()) return "";
    std::string text = "<p class=\"note\">The last frame of each run; each picture has its own range of colours.";
    if (study.pictures_left_out > 0)
        text += fmt::format(" {} of {}, evenly spaced: the pictures of {} are left out to keep the page small.",
                            study.pictures.size(), study.pictures.size() + study.pictures_left_out,
                            count(study.pictures_left_out, "run"));
    text += "</p>\n<div class=\"small-pictures\">\n";
    for (const RunPicture& each : study.pictures) {
        const StudyRow& row = study.rows[each.row];
        const std::string values = values_text(study, row);
        text += fmt::format("<figure>{}<figcaption>{}{}</figcaption></figure>\n",
                            image_element(each.picture, "The last frame of run " + row.run + ": " + values),
                            link_to(row), values.empty() ? "" : ": " + escaped(values));
    }
    return section("pictures", "Pictures of the runs", text + "</div>\n");
}

/// An error with its numbers left out: particles, places and times differ from run to run.
std::string without_numbers(const std::string& text) {
    static const std::regex number(R"([-+]?\d+(\.\d+)?(e[-+]?\d+)?)");
    return std::regex_replace(text, number, "0");
}

/// Runs that failed for the same reason, together, with the error of the first one.
std::string failures_section(const StudyFiles& study) {
    if (study.failed() == 0) return "";
    std::map<std::pair<int, std::string>, std::vector<const StudyRow*>> kinds;
    for (const StudyRow& row : study.rows)
        if (row.failed()) kinds[{row.exit_code, without_numbers(row.error)}].push_back(&row);
    std::vector<std::pair<std::pair<int, std::string>, std::vector<const StudyRow*>>> sorted(kinds.begin(),
                                                                                             kinds.end());
    std::ranges::stable_sort(sorted, std::greater(), [](const auto& kind) { return kind.second.size(); });
    std::string text = "<dl class=\"failures\">\n";
    for (std::size_t k = 0; k < std::min(sorted.size(), most_kinds_of_failure); ++k) {
        const auto& [failure, runs] = sorted[k];
        std::string names;
        for (std::size_t i = 0; i < std::min(runs.size(), most_runs_named); ++i)
            names += (i == 0 ? "" : ", ") + link_to(*runs[i]);
        if (runs.size() > most_runs_named) names += fmt::format(" and {} more", runs.size() - most_runs_named);
        const auto is_same = [&](const StudyRow* row) { return row->error == runs.front()->error; };
        text += fmt::format("<dt>{}, exit code {}</dt><dd>{}{}<br>{}</dd>\n", count(runs.size(), "run"), failure.first,
                            escaped(runs.front()->error),
                            std::ranges::all_of(runs, is_same) ? "" : " (of the first one; others with other numbers)",
                            names);
    }
    text += "</dl>\n";
    if (sorted.size() > most_kinds_of_failure)
        text += fmt::format("<p>There are {} other errors; results.csv has all of them.</p>\n",
                            sorted.size() - most_kinds_of_failure);
    return section("failed", "Failed runs",
                   text +
                       "<p class=\"note\">runs/NAME.log has all that such a run said. 'dmp sweep' with --resume tries "
                       "them again.</p>\n");
}

std::string time_section(const StudyFiles& study) {
    const StudyTiming& timing = study.timing;
    if (timing.starts == 0) return section("time", "Time spent", "<p>Not known.</p>\n");
    Items items{{"all runs", fmt::format("{} of processor time, {} of wall time together",
                                         wall_time_text(timing.processor_s), wall_time_text(timing.wall_s))},
                {"a run on average", wall_time_text(timing.wall_s / static_cast<double>(timing.starts))},
                {"the longest", wall_time_text(timing.longest_s) +
                                    (timing.longest_run.empty() ? "" : " (" + timing.longest_run + ")")},
                {"largest memory of a run",
                 std::isfinite(timing.peak_memory) ? fmt::format("{:.0f} MB", timing.peak_memory / 1e6) : "not known"},
                {"starts", fmt::format("{}; timing.csv has each", timing.starts)}};
    return section("time", "Time spent", list(items));
}

std::string reproduce_section(const StudyFiles& study) {
    std::string text;
    for (const LoggedRun::Start& start : study.log.starts)
        text += fmt::format("<p>{}, dmp {}:</p>\n<pre><code>{}</code></pre>\n", escaped(start.when),
                            escaped(start.version), escaped(start.command));
    text +=
        "<p>results.csv has a row for each run with all digits. The same study and version give the same one, to the "
        "last bit, however many runs go at a time.</p>\n";
    for (const auto& [name, content] :
         Items{{"The study (study.toml)", study.study_text}, {"The scene (scene.toml)", study.scene_text}})
        if (!content.empty())
            text += "<details><summary>" + name + "</summary>\n<pre><code>" + escaped(content) +
                    "</code></pre></details>\n";
    return section("reproduce", "How to run it again", text);
}

}  // namespace

std::string study_page(const StudyFiles& study) {
    Items anchors;
    if (study.trade) anchors.emplace_back("trade", "Cost and error");
    if (study.limits) anchors.emplace_back("limits", "Limits");
    anchors.insert(anchors.end(), {{"what", "What was studied"}, {"plots", "Plots"}, {"runs", "Runs"}});
    if (study.failed() > 0) anchors.emplace_back("failed", "Failed runs");
    if (!study.pictures.empty()) anchors.emplace_back("pictures", "Pictures");
    anchors.insert(anchors.end(), {{"time", "Time"}, {"reproduce", "How to run it again"}});
    const std::string text = head(study) + box("missing", "Not on this page", study.notes) + navigation(anchors) +
                             (study.trade ? trade_section(*study.trade) : "") +
                             (study.limits ? limits_section(*study.limits) : "") + what_was_studied(study) +
                             study_plots_section(study) + runs_section(study) + failures_section(study) +
                             pictures_section(study) + time_section(study) + reproduce_section(study);
    PageScripts run;
    if (!study.rows.empty())
        run = {{{"page-data", study_data(study)}}, {plotting_library(), std::string(study_script)}};
    return page_text(title_of(study), text, run);
}

}  // namespace dmp::report
