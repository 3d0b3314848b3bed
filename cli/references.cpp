// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/references.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/number_text.hpp"

namespace dmp::cli {

namespace {

std::size_t place_of(const std::string& name, const MeasureSeries& series) {
    return static_cast<std::size_t>(std::ranges::find(series.names, name) - series.names.begin());
}

study::TimeSeries column_in(const MeasureSeries& measures, std::size_t column) {
    study::TimeSeries series;
    for (std::size_t row = 0; row < measures.rows.size(); ++row)
        series.add(measures.time[row], measures.rows[row][column]);
    return series;
}

/// Of series that cannot be compared.
std::string reason(const study::TimeSeries& series, const study::TimeSeries& exact) {
    const auto rows = study::finite_rows(exact);
    if (rows.time.size() < 2) return "fewer than two rows are at times for which it holds";
    if (study::size_of(exact).peak == 0 && study::finite_rows(series).time.size() > 1)
        return "it is 0, and no difference can be a part of it";
    return "there are too few values to compare with it";
}

}  // namespace

References::References(const Scene& scene) {
    for (const Reference& reference : scene.references)
        known_.push_back({reference, study::ExactValues(scene, reference)});
}

const MeasureSeries& References::at_times_of(const MeasureSeries& measures) {
    if (series_.names.empty())
        for (const Known& each : known_) {
            const std::size_t column = place_of(each.reference.column_name(), measures);
            if (column == measures.names.size()) continue;  // its part is not enabled
            measured_.push_back(&each);
            series_.names.push_back(measures.names[column]);
            series_.units.push_back(measures.units[column]);
        }
    for (std::size_t row = series_.rows.size(); row < measures.rows.size(); ++row) {
        series_.time.push_back(measures.time[row]);
        std::vector<double>& values = series_.rows.emplace_back();
        for (const Known* each : measured_) values.push_back(each->exact.at(measures.time[row]));
    }
    return series_;
}

std::vector<ReferenceDistance> References::distances(const MeasureSeries& measures) {
    const MeasureSeries& exact = at_times_of(measures);
    std::vector<study::TimeSeries> found, wanted;
    for (std::size_t k = 0; k < exact.names.size(); ++k) {
        found.push_back(column_in(measures, place_of(exact.names[k], measures)));
        wanted.push_back(column_in(exact, k));
    }
    const std::vector<study::SeriesError> errors = study::errors_of(exact.names, found, wanted);
    std::vector<ReferenceDistance> distances;
    for (const Known& each : known_) {
        const std::string column = each.reference.column_name();
        const std::size_t k = place_of(column, exact);
        const bool is_measured = k < exact.names.size();
        const study::SeriesError error =
            is_measured ? errors[k]
                        : study::SeriesError{study::no_number, study::no_number, study::no_number, study::no_number};
        ReferenceDistance distance{
            each.reference.measure, column,         each.reference.source, error.whole, error.end, error.peak,
            error.integral,         error.largest()};
        if (!is_measured)
            distance.why_not = "it is not measured in this run";
        else if (std::isnan(distance.largest))
            distance.why_not = reason(found[k], wanted[k]);
        distances.push_back(std::move(distance));
    }
    return distances;
}

std::string distances_text(const std::vector<ReferenceDistance>& distances) {
    std::string text;
    for (const ReferenceDistance& each : distances)
        text += each.why_not.empty() ? fmt::format("  {}: {} from its reference ({})\n", each.column,
                                                   percentage_text(each.largest), each.source)
                                     : fmt::format("  {}: not compared with its reference ({}): {}\n", each.column,
                                                   each.source, each.why_not);
    return text;
}

}  // namespace dmp::cli
