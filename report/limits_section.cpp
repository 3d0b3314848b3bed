// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/limits_section.hpp"

#include <cmath>
#include <vector>

#include "report/html.hpp"
#include "report/limits_picture.hpp"
#include "report/trade_facts.hpp"

namespace dmp::report {

namespace {

using Dial = LimitsFacts::Dial;

std::string remark_on(const Dial& dial) {
    std::string remark = dial.what;
    if (dial.stated && dial.stated_by != dial.cause) remark += "; stated: " + dial.stated_by;
    // What a run says of its particles is in the list of failed runs.
    const std::string& why = dial.likely_causes.empty() ? dial.cause : dial.likely_causes;
    if (!why.empty()) remark += "; " + why;
    return remark;
}

std::string dials_table(const LimitsFacts& limits) {
    std::vector<std::vector<std::string>> rows;
    for (const Dial& dial : limits.dials)
        rows.push_back({dial.name, dial.is_up ? "up" : "down", limit_value_text(dial.own, dial.unit),
                        stated_text(limit_value_text(dial.stated, dial.unit), dial.stated_margin()),
                        limit_value_text(dial.clean, dial.unit), limit_value_text(dial.bad, dial.unit),
                        margin_text(dial.margin()), limit_way_text(dial), remark_on(dial)});
    return table("Dials", {"dial", "", "own", "stated", "last clean", "first bad", "margin", "ends", ""}, rows, 9);
}

std::string columns_table(const LimitsFacts& limits) {
    std::vector<std::vector<std::string>> rows;
    for (const LimitsFacts::Column& column : limits.columns)
        rows.push_back({column.name, error_text(column.scatter),
                        column.counts ? error_text(column.allowed) : "not counted: zero, or scattered"});
    if (rows.empty()) return "";
    std::string notes;
    for (const std::string& note : limits.notes) notes += "<p>" + escaped(note) + "</p>\n";
    return "<h3>Measures</h3>\n" + notes + table("Measures", {"measure", "scatter", "departs above"}, rows, 3);
}

}  // namespace

std::string limits_section(const LimitsFacts& limits) {
    return section(
        "limits", "Limits",
        "<figure class=\"trade-picture\">" + limits_picture(limits) +
            "<figcaption>Each value was varied until the scene breaks, or its measures deviate too much from those of "
            "its own settings. limits.json has all numbers.</figcaption></figure>\n" +
            dials_table(limits) + columns_table(limits));
}

}  // namespace dmp::report
