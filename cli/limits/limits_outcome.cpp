// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/limits/limits_outcome.hpp"

#include <utility>

#include "base/unlisted_value.hpp"
#include "cli/output_folder.hpp"
#include "cli/scene_name.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/version.hpp"
#include "report/html.hpp"
#include "report/limits_picture.hpp"

namespace dmp::cli {

namespace {

LimitWay way_of(RungWay way) {
    switch (way) {
        case RungWay::unknown:
        case RungWay::clean:
        case RungWay::failed:
            return LimitWay::not_measured;
        case RungWay::departs:
            return LimitWay::departs;
        case RungWay::breaks:
            return LimitWay::breaks;
        case RungWay::refused:
            return LimitWay::refused;
    }
    unlisted_value(way);
}

constexpr std::size_t longest_cause = 72;

/// What is known of one dial.
LimitsFacts::Dial found_of(const study::LimitStudy& study, std::size_t index, RungEnds& ends,
                           const study::Points& points) {
    const study::Dial& dial = study.dials()[index];
    LimitsFacts::Dial found;
    found.name = dial.name;
    for (const study::DialKey& key : dial.keys) found.keys.push_back(key.key);
    found.what = dial.what;
    found.is_up = dial.side == study::DialSide::up;
    found.is_physical = dial.is_physical;
    found.unit = dial.unit();
    found.own = dial.own();
    found.distance = study::no_number;
    if (dial.stated) {
        found.stated = dial.stated->value;
        found.stated_by = dial.stated->formula;
    }
    if (!ends.has_reference()) return found;
    if (!ends.can_compare(index)) {
        found.way = LimitWay::no_measure;
        return found;
    }
    const std::vector<study::RungState> states = ends.states_of(index);
    const study::RungBracket bracket = study::bracket_of(states);
    const auto name_of = [&](std::size_t rung) { return points.at(study.run_of(index, rung)).name; };
    found.clean = bracket.clean == 0 ? dial.own() : dial.rungs[bracket.clean - 1].value;
    found.clean_run = name_of(bracket.clean);
    if (bracket.clean > 0) found.set = study.overrides({index, bracket.clean});
    const bool has_bad = bracket.bad <= dial.rungs.size();
    if (has_bad) {
        const RungEnd& end = ends.of(study.run_of(index, bracket.bad));
        found.bad = dial.rungs[bracket.bad - 1].value;
        found.bad_run = name_of(bracket.bad);
        if (bracket.is_settled()) {
            found.cause = end.text;
            found.likely_causes = end.likely_causes;
            found.distance = end.distance;
            found.column = end.column;
            found.way = way_of(end.way);
        }
    } else if (bracket.is_settled()) {
        found.cause = dial.refused.empty() ? dial.end : dial.refused;
        found.way = dial.refused.empty() ? LimitWay::none_found : LimitWay::refused;
        found.bound = dial.bound;
    }
    if (const auto failed = study::failed_rung(states))
        found.cause = "run " + name_of(*failed) + " failed: " + ends.of(study.run_of(index, *failed)).text;
    return found;
}

}  // namespace

std::filesystem::path default_limits_folder(const Scene& scene) {
    return output_folder("", scene_name(scene) + "_limits");
}

LimitsFacts limits_found(const LimitsRequest& request, const std::string& scene, RungEnds& ends,
                         const study::Points& points) {
    LimitsFacts limits;
    limits.scene = scene;
    limits.name = scene_name(request.read);
    limits.version = build_facts().version;
    limits.set_in_all = request.common;
    limits.simulated = *request.read.run.duration;
    limits.duration = request.duration;
    limits.tolerance = request.tolerance;
    limits.own_run = points.at(study::LimitStudy::own).name;
    if (ends.has_reference())
        for (const LimitColumn& column : ends.columns())
            limits.columns.push_back({column.name, column.scatter, column.allowed, column.counts()});
    limits.notes = ends.notes();
    for (std::size_t k = 0; k < request.study.dials().size(); ++k) {
        LimitsFacts::Dial found = found_of(request.study, k, ends, points);
        const bool has_end = found.way != LimitWay::not_measured && found.way != LimitWay::no_measure;
        if (request.asked[k] || has_end) limits.dials.push_back(std::move(found));
    }
    return limits;
}

std::string limits_text(const LimitsFacts& limits) {
    const Style style(Stream::output);
    std::vector<std::vector<std::string>> rows{
        {"dial", "", "own", "stated", "last clean", "first bad", "margin", "ends"}};
    for (const LimitsFacts::Dial& dial : limits.dials) {
        const std::string& why = dial.likely_causes.empty() ? dial.cause : dial.likely_causes;
        rows.push_back({dial.name, dial.is_up ? "up" : "down", limit_value_text(dial.own, dial.unit),
                        stated_text(limit_value_text(dial.stated, dial.unit), dial.stated_margin()),
                        limit_value_text(dial.clean, dial.unit), limit_value_text(dial.bad, dial.unit),
                        margin_text(dial.margin()),
                        limit_way_text(dial) + (why.empty() ? "" : ": " + shortened(why, longest_cause))});
    }
    std::string text = style.strong("Limits") + "\n" + table_text(rows);
    std::vector<std::vector<std::string>> measures{{"measure", "scatter", "departs above"}};
    for (const LimitsFacts::Column& column : limits.columns)
        measures.push_back({column.name, part_text(column.scatter),
                            column.counts ? part_text(column.allowed) : "not counted: zero, or scattered"});
    if (!limits.columns.empty()) text += style.strong("Measures") + "\n" + table_text(measures);
    for (const std::string& note : limits.notes) text += note + "\n";
    return text;
}

void write_limits(const std::filesystem::path& folder, const LimitsFacts& limits) {
    write_limits_facts(folder, limits);
    write_limits_picture(folder);
}

}  // namespace dmp::cli
