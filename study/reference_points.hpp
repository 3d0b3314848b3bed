// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/toml_node.hpp"
#include "study/study.hpp"

namespace dmp::study {

/// The points of the CSV file that a plot's `reference` names. Its heading names the plot's key and result, with their
/// units; other columns are left alone. Throws InputError where the file, one of both columns or a number is missing, a
/// unit is of another quantity, or a number has no place on a logarithmic axis.
[[nodiscard]] ReferencePoints read_reference(const TomlNode& node, const Plot& plot, const Study& study);

}  // namespace dmp::study
