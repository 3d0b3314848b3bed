// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/text_hash.hpp"

#include <xxhash.h>

namespace dmp {

std::uint64_t text_hash(std::string_view text) { return XXH64(text.data(), text.size(), 0); }

}  // namespace dmp
