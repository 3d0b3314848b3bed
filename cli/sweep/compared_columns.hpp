// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/uses.hpp"
#include "scene/scene.hpp"
#include "solver/results/frame.hpp"
#include "study/time_series.hpp"

namespace dmp::cli {

/// Columns that all tables have, in the order of the first one, without those that count particles. `measures`: names
/// of the scene's measures that they are to be of; empty: any.
[[nodiscard]] std::vector<std::string> common_columns(const std::vector<MeasureSeries>& tables, const Scene& scene,
                                                      const std::vector<std::string>& measures);

/// A column that the table has.
[[nodiscard]] study::TimeSeries column_of(const MeasureSeries& table, const std::string& name);

}  // namespace dmp::cli
