// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace dmp {

/// The candidate with the smallest edit distance to `name` (a swap of neighbouring letters is one edit; of equals the
/// first); empty when nothing is near: more than one letter and more than a third of the longer word would have to
/// change.
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

/// "'a', 'b' and 'c'"; "nothing" for an empty list.
std::string quoted_list(std::span<const std::string> names);

}  // namespace dmp
