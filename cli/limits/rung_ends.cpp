// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/limits/rung_ends.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "base/text_lines.hpp"
#include "base/unlisted_value.hpp"
#include "cli/exit_codes.hpp"
#include "cli/sweep/compared_columns.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "cli/terminal.hpp"
#include "postproc/tables.hpp"
#include "study/measure_columns.hpp"

namespace dmp::cli {

namespace {

RungWay way_of_failure(int exit_code) {
    if (exit_code == exit_diverged) return RungWay::breaks;
    return exit_code == exit_bad_input ? RungWay::refused : RungWay::failed;
}

/// Of one that is not clean.
std::string verb_of(RungWay way) {
    switch (way) {
        case RungWay::breaks:
            return "breaks";
        case RungWay::refused:
            return "is refused";
        case RungWay::unknown:
        case RungWay::clean:
        case RungWay::departs:
        case RungWay::failed:
            return "failed";
    }
    unlisted_value(way);
}

/// As the stability monitor ranks them, in what a run said.
std::string likely_causes_in(const std::filesystem::path& output) {
    if (!std::filesystem::is_regular_file(output)) return "";
    for (const std::string& line : text_lines(read_file(output)))
        for (const std::string_view mark : {"likely causes: ", "likely cause: "})
            if (const auto at = line.find(mark); at != std::string::npos)
                return printable(std::string_view(line).substr(at + mark.size()), false);
    return "";
}

study::SeriesError distance_of(const LimitColumn& column, const MeasureSeries& measures, const MeasureSeries& own) {
    return study::error_of(column_of(measures, column.name), column_of(own, column.name), column.size);
}

bool has_column(const MeasureSeries& measures, const std::string& name) {
    return std::ranges::find(measures.names, name) != measures.names.end();
}

}  // namespace

study::RungState RungEnd::state() const {
    switch (way) {
        case RungWay::unknown:
            return study::RungState::unknown;
        case RungWay::clean:
            return study::RungState::clean;
        case RungWay::departs:
        case RungWay::breaks:
        case RungWay::refused:
            return study::RungState::bad;
        case RungWay::failed:
            return study::RungState::failed;
    }
    unlisted_value(way);
}

const RungEnd& RungEnds::of(std::size_t run) {
    static const RungEnd not_yet;
    const auto known = ends_.find(run);
    if (known != ends_.end()) return known->second;
    RungEnd end = end_of(run);
    return end.way == RungWay::unknown ? not_yet : ends_.emplace(run, std::move(end)).first->second;
}

bool RungEnds::has_reference() {
    if (of(study::LimitStudy::own).way != RungWay::clean) return false;
    if (study_.repeat() && of(*study_.repeat()).way == RungWay::unknown) return false;
    if (!own_) take_reference();
    return true;
}

std::vector<study::RungState> RungEnds::states_of(std::size_t dial) {
    std::vector<study::RungState> states;
    for (std::size_t rung = 1; rung <= study_.dials()[dial].rungs.size(); ++rung)
        states.push_back(has_reference() ? of(study_.run_of(dial, rung)).state() : study::RungState::unknown);
    return states;
}

bool RungEnds::can_compare(std::size_t dial) const {
    return study_.dials()[dial].is_physical || std::ranges::any_of(columns_, &LimitColumn::counts);
}

std::vector<std::string> RungEnds::notes() {
    std::vector<std::string> all;
    if (!has_reference()) return all;
    if (study_.repeat() && of(*study_.repeat()).way != RungWay::clean) {
        const RungEnd& end = of(*study_.repeat());
        all.push_back("The repeat, run " + rows_.points().at(*study_.repeat()).name + ", " + verb_of(end.way) + ": " +
                      end.text + ". The scatter of measures is not known.");
    }
    if (std::ranges::none_of(columns_, &LimitColumn::counts))
        all.emplace_back(
            "No measure counts: all are zero, or scatter by more than a fifth of their size. Dials that are seen by "
            "measures are not varied; give the scene a [[measure]] that is not zero.");
    return all;
}

RungEnd RungEnds::end_of(std::size_t run) {
    RungEnd end;
    const std::optional<SweepRow>& row = rows_.table().row(run);
    if (!row) return end;
    if (row->failed()) {
        end.way = way_of_failure(row->exit_code);
        end.text = row->error;
        end.likely_causes = likely_causes_in(run_output(rows_.folder().path(), row->run));
        return end;
    }
    end.way = RungWay::clean;
    const auto place = study_.place_of(run);
    if (!place || study_.dials()[place->dial].is_physical) return end;
    try {
        compare(end, measures_of(run));
    } catch (const Error& error) {
        end.way = RungWay::failed;
        end.text = one_line(error);
    }
    return end;
}

MeasureSeries RungEnds::measures_of(std::size_t run) const {
    return read_measures_csv(run_folder(rows_.folder().path(), rows_.points().at(run).name));
}

void RungEnds::take_reference() {
    own_ = measures_of(study::LimitStudy::own);
    for (const std::string& name : common_columns({*own_}, scene_, {})) {
        LimitColumn& column = columns_.emplace_back();
        column.name = name;
        for (const std::string& other : own_->names)
            if (study::vector_of(other) == study::vector_of(name))
                column.size = column.size.with(study::size_of(column_of(*own_, other)));
        column.allowed = tolerance_;
    }
    if (!study_.repeat() || of(*study_.repeat()).way != RungWay::clean) return;
    const MeasureSeries repeat = measures_of(*study_.repeat());
    for (LimitColumn& column : columns_) {
        if (!has_column(repeat, column.name)) continue;
        column.scatter = distance_of(column, repeat, *own_).largest();
        column.allowed = std::fmax(tolerance_, 3 * column.scatter);
    }
}

void RungEnds::compare(RungEnd& end, const MeasureSeries& measures) const {
    double largest = 0;  // in multiples of what is allowed
    for (const LimitColumn& column : columns_) {
        if (!column.counts()) continue;
        const double distance =
            has_column(measures, column.name) ? distance_of(column, measures, *own_).largest() : study::no_number;
        const double part = distance / column.allowed;
        if (!std::isnan(part) && part < largest) continue;
        end.distance = distance;
        end.column = column.name;
        largest = part;
        if (std::isnan(part)) break;
    }
    if (std::isnan(largest) || largest > 1) end.way = RungWay::departs;
}

}  // namespace dmp::cli
