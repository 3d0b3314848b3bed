// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "scene/toml_node.hpp"
#include "study/slurm.hpp"

namespace dmp::study {

/// [slurm] of a study; all defaults where it has none. Throws InputError with file:line:column.
[[nodiscard]] Slurm read_slurm(const TomlNode& document);

/// With these values in place of the study's, by their options: {"--partition", "short"}, {"--time", "2 h"}. An empty
/// text: not given. Throws InputError.
[[nodiscard]] Slurm with_options(Slurm slurm, const std::map<std::string, std::string>& options);

}  // namespace dmp::study
