// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/toml_node.hpp"
#include "study/points.hpp"
#include "study/study.hpp"

namespace dmp::study {

/// Reads the [[plot]]s of a study whose keys and results are known. Throws InputError with file:line:column.
[[nodiscard]] std::vector<Plot> read_plots(const TomlNode& document, const Study& study, const Points& points);

/// What to plot where the study does not say: each result over the key that takes most values, with a line for each
/// value of the key that takes most after it, if these are at most most_lines. Random seeds and formulas come last. Of
/// a Latin hypercube, each result over each key. Axes of ranges with scale = "log" are logarithmic.
[[nodiscard]] std::vector<Plot> default_plots(const Study& study, const Points& points);

/// Whether a key only chooses random numbers: runs that differ in it alone are repetitions.
[[nodiscard]] bool is_seed(const std::string& key);

}  // namespace dmp::study
