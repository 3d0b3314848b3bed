// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cli/uses.hpp"
#include "study/points.hpp"
#include "study/study.hpp"

namespace dmp::cli {

/// The runs that have all of these values, "key=value" as given to --only; all runs where there are none. Throws
/// InputError for a key that does not vary, a value that it cannot have, or one that no run has.
[[nodiscard]] std::vector<std::size_t> chosen_runs(const study::Study& study, const study::Points& points,
                                                   const std::vector<std::string>& only);

}  // namespace dmp::cli
