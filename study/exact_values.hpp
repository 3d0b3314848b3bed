// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "study/series_error.hpp"
#include "study/time_series.hpp"
#include "study/uses.hpp"

namespace dmp::study {

/// What the scene says that a column of measures.csv should be; null where it says nothing.
[[nodiscard]] const Reference* reference_of(const Scene& scene, const std::string& column);

/// What a [[reference]] says, at any time.
class ExactValues {
  public:
    /// Of a scene that has been read. Throws InputError where the reference's file cannot be read, has not the column
    /// time and the measure's, or their units; where a number is missing, times do not increase, or there are less than
    /// two.
    ExactValues(const Scene& scene, const Reference& reference);

    /// In the column's SI unit: the formula's value, or that on the line between the file's rows. NaN before `from`,
    /// after `until`, and where the file has no rows on both sides.
    [[nodiscard]] double at(double time) const;

  private:
    double from_, until_;  ///< [s]
    Expression formula_;
    TimeSeries rows_;  ///< empty: there is a formula
};

/// The same at these times [s]. Throws InputError likewise.
[[nodiscard]] TimeSeries exact_series(const Scene& scene, const Reference& reference, const std::vector<double>& times);

/// How far each of some columns is from what it should be, over the times of both. `exact`: of the same columns; empty
/// where it is not known. A component, NAME_x beside NAME_y and NAME_z, is compared with the size of the vector, as
/// far as that is known.
[[nodiscard]] std::vector<SeriesError> errors_of(const std::vector<std::string>& columns,
                                                 const std::vector<TimeSeries>& series,
                                                 const std::vector<TimeSeries>& exact);

}  // namespace dmp::study
