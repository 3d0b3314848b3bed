// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/trade_facts.hpp"

namespace dmp::report {

/// The section of a study's page about what a trade has found: its picture, the cheapest setting for each of
/// trade_tolerances as a command, and all settings.
[[nodiscard]] std::string trade_section(const TradeFacts& trade);

}  // namespace dmp::report
