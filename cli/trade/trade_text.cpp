// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What a trade tells on the terminal.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/shell_word.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/trade/trade_outcome.hpp"
#include "study/front.hpp"

namespace dmp::cli {

namespace {

std::string setting_text(const study::TradeSetting& setting) {
    return setting.spacing_text + (setting.spacing_text.empty() ? "" : ", ") + setting.level.text;
}

std::string settings_table(const TradeOutcome& outcome) {
    std::vector<std::vector<std::string>> rows{{"spacing", "level", "processor time", "error", "of", ""}};
    const std::vector<std::size_t> front = outcome.front();
    const bool is_exact = std::ranges::all_of(outcome.errors.columns, &study::ColumnTrust::is_exact);
    for (std::size_t index = 0; index < outcome.settings.settings.size(); ++index) {
        const study::TradeSetting& setting = outcome.settings.settings[index];
        std::vector<std::string> row{
            setting.spacing_text.empty() ? "-" : setting.spacing_text, setting.level.text, "", "", "", ""};
        const auto run = std::ranges::find(outcome.runs, index, &study::TradeRun::setting);
        if (run == outcome.runs.end()) {
            row[2] = !outcome.failures[index].empty() ? "failed" : outcome.begun[index] ? "stopped" : "not run";
            row[4] = outcome.failures[index];
        } else {
            const auto r = static_cast<std::size_t>(run - outcome.runs.begin());
            const study::RunError& error = outcome.errors.runs[r];
            row[2] = std::isnan(run->cost) ? "-" : duration_text(run->cost);
            row[3] = part_text(error.error);
            row[4] = outcome.columns[error.column] + (std::isnan(error.error) ? " is not known" : "");
            row[5] = setting.role == study::TradeRole::reference  ? "the reference, given"
                     : r == outcome.errors.reference && !is_exact ? "the reference"
                     : setting.role == study::TradeRole::repeat   ? "repeat, for the scatter"
                     : std::ranges::find(front, r) != front.end() ? "*"
                                                                  : "";
        }
        rows.push_back(std::move(row));
    }
    const bool has_lower_levels = std::ranges::any_of(outcome.settings.settings, [&](const auto& each) {
        return each.role == study::TradeRole::candidate && !outcome.may_be_advised(each);
    });
    return table_text(rows) + "  *: no other setting is cheaper and as good\n" +
           (has_lower_levels
                ? fmt::format("  Lower levels than {} are not advised by runs that do not go on to the end.\n",
                              outcome.settings.own_level.text)
                : "");
}

std::string measures_table(const TradeOutcome& outcome) {
    std::vector<std::vector<std::string>> rows{{"measure", "scatter", "reference's error", "order", ""}};
    for (std::size_t c = 0; c < outcome.columns.size(); ++c) {
        const study::ColumnTrust& trust = outcome.errors.columns[c];
        rows.push_back({outcome.columns[c], std::isnan(trust.scatter) ? "not measured" : part_text(trust.scatter),
                        trust.is_exact ? "exact" : part_text(trust.reference),
                        std::isnan(trust.order) ? "-" : fmt::format("{:.1f}", trust.order),
                        trust.counts()   ? trust.why_not
                        : trust.has_size ? "not counted: it scatters by more than half its size"
                                         : "not counted: " + trust.why_not});
    }
    return table_text(rows);
}

/// The smallest error, and how much of it is scatter, where it is that of a measure whose runs scatter.
std::string best_text(const TradeOutcome& outcome) {
    const std::vector<std::size_t> front = outcome.front();
    if (front.empty()) return "not reachable: no error is known";
    const study::RunError& best = outcome.errors.runs[front.back()];
    const double scatter = outcome.errors.columns[best.column].scatter;
    return fmt::format("not reachable: the smallest error is {}, in {}{}", part_text(best.error),
                       outcome.columns[best.column],
                       scatter > 0 ? fmt::format(", and repeats scatter by {}", part_text(scatter)) : "");
}

std::string advice(const TradeOutcome& outcome, double tolerance, const std::string& program) {
    for (const std::size_t r : outcome.front()) {
        if (outcome.errors.runs[r].error > tolerance) continue;
        const study::TradeRun& run = outcome.runs[r];
        std::string line = program + " run " + shell_word(outcome.scene_path);
        for (const std::string& each : outcome.common) line += " --set " + shell_word(each);
        for (const std::string& each : outcome.settings.overrides(outcome.setting(run)))
            line += " --set " + shell_word(each);
        return fmt::format("{}, error {}{}, about {} of one processor\n  {}\n", setting_text(outcome.setting(run)),
                           part_text(outcome.errors.runs[r].error), compared_time_text(outcome.until, outcome.duration),
                           duration_text(run.cost * outcome.duration / outcome.until), line);
    }
    return best_text(outcome) + "\n";
}

}  // namespace

std::string compared_time_text(double until, double duration) {
    if (!(until < duration * (1 - 1e-9))) return "";
    return fmt::format(" up to {} of {}", duration_text(until), duration_text(duration));
}

std::string trade_text(const TradeOutcome& outcome, const std::vector<double>& tolerances, const std::string& program) {
    const Style style(Stream::output);
    std::string text = style.strong("Settings") + "\n" + settings_table(outcome) + style.strong("Measures") + "\n" +
                       measures_table(outcome) + style.strong("The cheapest setting") + "\n";
    for (const double tolerance : tolerances)
        text += fmt::format("For {}: {}", part_text(tolerance), advice(outcome, tolerance, program));
    return text;
}

}  // namespace dmp::cli
