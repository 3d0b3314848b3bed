// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace dmp {

/// XXH64 with seed 0.
std::uint64_t text_hash(std::string_view text);

}  // namespace dmp
