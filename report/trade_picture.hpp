// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "report/trade_facts.hpp"

namespace dmp::report {

/// Error over processor time, both logarithmic, as an SVG that needs no script, font or file: a mark for each setting,
/// by its quality, labelled with its spacing; those that no other beats are filled and joined by a line. The reference
/// has a ring; repeats are left out, as they lie where the run does that they repeat. What has no processor time or
/// error is counted below; an error of 0 is at the lower edge.
[[nodiscard]] std::string trade_picture(const TradeFacts& trade);

/// Writes folder/trade.svg of folder/trade.json. Throws InputError where that is damaged, ResourceError where it cannot
/// be written.
void write_trade_picture(const std::filesystem::path& folder);

}  // namespace dmp::report
