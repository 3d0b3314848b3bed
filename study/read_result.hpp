// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/toml_node.hpp"
#include "study/study.hpp"

namespace dmp::study {

/// Reads the next [[result]] of a study whose scene and keys are known: one result, or with `every` one of each of
/// those times. Throws InputError, also where the scene has no such measure.
std::vector<Result> read_results(const TomlNode& node, const Study& study);

/// The level of a first crossing in a measure's unit. Throws InputError where it is of another quantity.
double level_in(const Result& result, const std::string& unit);

}  // namespace dmp::study
