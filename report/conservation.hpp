// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run_files.hpp"

namespace dmp::report {

/// The section of what a run conserved: mass, momentum, species, energy of spheres; and density.
[[nodiscard]] std::string conservation_section(const RunFiles& run);

}  // namespace dmp::report
