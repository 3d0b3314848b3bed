// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/trade_section.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "base/length_text.hpp"
#include "base/shell_word.hpp"
#include "report/html.hpp"
#include "report/trade_picture.hpp"

namespace dmp::report {

namespace {

using Setting = TradeFacts::Setting;

/// "0.1414 mm, fine". `largest`: spacing of all [m].
std::string name_of_setting(const TradeFacts& trade, const Setting& setting, double largest) {
    return (setting.spacing > 0 ? length_text(setting.spacing, largest) + ", " : "") + trade.level_of(setting);
}

std::string remark_on(const TradeFacts& trade, std::size_t index) {
    const Setting& setting = trade.settings[index];
    if (!setting.failure.empty()) return setting.failure;
    if (setting.is_reference_given) return "the reference: " + setting.run;
    if (setting.is_repeat) return "repeat, for the scatter";
    std::string remark = trade.reference == index ? "the reference" : "";
    if (trade.is_on_front(index))
        remark += (remark.empty() ? "" : "; ") + std::string("no other is cheaper and as good");
    return remark;
}

/// Processor time, error, and what it is of.
std::vector<std::string> findings_of(const Setting& setting) {
    if (setting.has_ended) return {wall_time_text(setting.cost), error_text(setting.error), setting.error_is_of};
    return {setting.failure.empty() ? "not run to its end" : "failed", "", ""};
}

std::string settings_table(const TradeFacts& trade) {
    std::vector<std::vector<std::string>> rows;
    const double largest = trade.largest_spacing();
    for (std::size_t index = 0; index < trade.settings.size(); ++index) {
        const Setting& setting = trade.settings[index];
        std::vector<std::string>& row = rows.emplace_back(std::vector<std::string>{
            setting.spacing > 0 ? length_text(setting.spacing, largest) : "-", trade.level_of(setting)});
        for (std::string& cell : findings_of(setting)) row.push_back(std::move(cell));
        row.push_back(remark_on(trade, index));
    }
    return table("Settings", {"spacing", "level", "processor time", "error", "of", ""}, rows, 6);
}

std::string command_of(const TradeFacts& trade, const Setting& setting) {
    std::string line = "dmp run " + shell_word(trade.scene);
    for (const std::string& each : trade.set_in_all) line += " --set " + shell_word(each);
    for (const std::string& each : setting.set) line += " --set " + shell_word(each);
    return line;
}

/// Why no setting has an error that is as small as one would like.
std::string best_of(const TradeFacts& trade) {
    const auto best = trade.best();
    if (!best) return "not reachable: no error is known.";
    const Setting& setting = trade.settings[*best];
    std::string words = "not reachable: the smallest error is " + error_text(setting.error);
    if (setting.error_is_of.empty()) return words + ".";
    words += ", in " + setting.error_is_of;
    const auto measure = std::ranges::find(trade.measures, setting.error_is_of, &TradeFacts::Measure::name);
    if (measure != trade.measures.end() && measure->scatter > 0)
        words += ", and repeats scatter by " + error_text(measure->scatter);
    return words + ".";
}

/// Where the runs do not go on to the end of the scene.
bool is_shortened(const TradeFacts& trade) { return trade.simulated < trade.duration * (1 - 1e-9); }
std::string compared_time(const TradeFacts& trade) {
    if (!is_shortened(trade)) return "";
    return fmt::format(" up to {:.4g} s of {:.4g} s", trade.simulated, trade.duration);
}

/// Of runs that are shorter than the scene: what was not seen.
std::string unseen(const TradeFacts& trade) {
    if (!is_shortened(trade)) return "";
    return fmt::format(
        "<p>The runs end at {:.4g} s of {:.4g} s: what happens later was not measured, and no level below the scene's "
        "own "
        "is advised.</p>\n",
        trade.simulated, trade.duration);
}

std::string advice(const TradeFacts& trade) {
    std::string all = "<h3>The cheapest setting</h3>\n";
    for (const double tolerance : trade_tolerances) {
        const auto index = trade.cheapest_within(tolerance);
        std::string words = best_of(trade);
        if (index) {
            const Setting& setting = trade.settings[*index];
            const double whole = setting.cost * trade.duration / trade.simulated;
            words =
                name_of_setting(trade, setting, trade.largest_spacing()) + ", with an error of " +
                error_text(setting.error) + compared_time(trade) +
                (std::isfinite(whole) ? "; the whole scene takes about " + wall_time_text(whole) + " of one processor."
                                      : ".");
        }
        all += fmt::format("<p>For {}: {}</p>\n", error_text(tolerance), escaped(words));
        if (index) all += "<pre><code>" + escaped(command_of(trade, trade.settings[*index])) + "</code></pre>\n";
    }
    return all + unseen(trade);
}

}  // namespace

std::string trade_section(const TradeFacts& trade) {
    return section(
        "trade", "Cost and error",
        "<figure class=\"trade-picture\">" + trade_picture(trade) +
            "<figcaption>Each mark is a run. Its error is that of the measure that is most wrong; repeats are "
            "in the table only. trade.json has all numbers.</figcaption></figure>\n" +
            settings_table(trade) + advice(trade));
}

}  // namespace dmp::report
