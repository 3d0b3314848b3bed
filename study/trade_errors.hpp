// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "study/series_error.hpp"
#include "study/time_series.hpp"
#include "study/trade_settings.hpp"
#include "study/uses.hpp"

namespace dmp::study {

/// A run of a trade that has ended.
struct TradeRun {
    std::size_t setting = 0;           ///< index of TradeSettings::settings
    double cost = 0;                   ///< processor time [s]
    std::vector<TimeSeries> measures;  ///< one for each column of measures
};

/// A column of measures.
struct TradeColumn {
    std::size_t vector = 0;           ///< a number of the vector that it is a component of; of its own, else
    std::optional<TimeSeries> exact;  ///< what it should be, where that is known
};

/// How well one column of measures is known.
struct ColumnTrust {
    double scatter = no_number;    ///< largest error of the repeats against the run that they repeat; NaN: not known
    double reference = no_number;  ///< of the reference itself, by the convergence with the spacing; NaN: not known
    double order = no_number;      ///< observed, of the error; NaN: `why_not`
    std::string why_not;           ///< no order was observed
    bool has_size = true;          ///< false: it is zero, or without values, in the reference
    bool is_exact = false;         ///< its reference is what it should be

    /// Not where it has no size, or scatters by more than half of it: it is zero, or chance.
    [[nodiscard]] bool counts() const { return has_size && !(scatter > 0.5); }
};

/// How wrong a run is, by all columns.
struct RunError {
    std::vector<SeriesError> distance;  ///< from the reference, of each column
    double error = no_number;  ///< largest over the columns that count, with the reference's own; NaN: not known
    std::size_t column = 0;    ///< which it is of
};

struct TradeErrors {
    std::size_t reference = 0;         ///< index of the run that all are compared with: the one given, or the finest
    std::vector<ColumnTrust> columns;  ///< one for each column
    std::vector<RunError> runs;        ///< one for each run
};

/// What a run's error is of a column: its distance from the reference, plus the reference's own error; not less than
/// the scatter. It is unknown where a column that counts is: a run without values has not a small error.
///
/// The reference's own error follows from how the distances d of runs of its level fall as their spacings h approach
/// its own, h0: d = C (h^p - h0^p), an error of C h0^p, with p from the largest and the middle one and likewise from
/// the middle and the smallest one, in 0.5 to 4, and both within 0.75 of each other. Where that is not so, p is taken
/// as 1, or as 0.5 where the distances fall more slowly, and the run next to twice the spacing; where none of its level
/// has another spacing, the distance of the next finest run. Where a higher level has been run at all, the distance
/// between both levels at the finest spacing that both have comes on top. Where it is known what a column should be,
/// that is its reference, without an error of its own.
///
/// `runs`: two or more candidates, at most one reference. `columns`: for each column of measures; the distances of the
/// components of a vector are parts of its size.
[[nodiscard]] TradeErrors trade_errors(const TradeSettings& settings, const std::vector<TradeRun>& runs,
                                       const std::vector<TradeColumn>& columns);

}  // namespace dmp::study
