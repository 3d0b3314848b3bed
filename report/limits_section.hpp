// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/limits_facts.hpp"

namespace dmp::report {

/// The section of a study's page about the limits of its scene: their picture, the table of the dials, and the measures
/// that runs were compared by.
[[nodiscard]] std::string limits_section(const LimitsFacts& limits);

}  // namespace dmp::report
