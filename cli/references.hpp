// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/uses.hpp"
#include "postproc/tables.hpp"
#include "scene/scene.hpp"
#include "solver/results/run_summary.hpp"
#include "study/exact_values.hpp"

namespace dmp::cli {

/// What the scene says that measures of a run should be.
class References {
  public:
    /// Throws InputError where a reference's file is wrong (study::ExactValues).
    explicit References(const Scene& scene);
    References(const References&) = delete;
    References& operator=(const References&) = delete;
    References(References&&) = default;
    References& operator=(References&&) = default;
    ~References() = default;

    /// At the times of the measures, with the columns of these that have a reference: references.csv. Of a series that
    /// grows, only what is new is worked out.
    const MeasureSeries& at_times_of(const MeasureSeries& measures);

    /// One for each reference of the scene.
    [[nodiscard]] std::vector<ReferenceDistance> distances(const MeasureSeries& measures);

  private:
    struct Known {
        Reference reference;
        study::ExactValues exact;
    };
    std::vector<Known> known_;
    std::vector<const Known*> measured_;  ///< one for each column of series_
    MeasureSeries series_;
};

/// A line for each.
[[nodiscard]] std::string distances_text(const std::vector<ReferenceDistance>& distances);

}  // namespace dmp::cli
