// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/toml_node.hpp"
#include "study/study.hpp"
#include "study/uses.hpp"

namespace dmp::study {

/// Takes a formula, or a list of them for a key that takes a list. Throws InputError where it is neither.
void read_formulas(const TomlNode& node, Vary& vary);

/// The value of a key that has formulas, from those of the keys before it. Throws InputError where a name in it is none
/// of theirs, or units do not fit together.
[[nodiscard]] VariedValue value_of(const Vary& vary, const std::vector<VariedKey>& keys,
                                   const std::vector<VariedValue>& values);

}  // namespace dmp::study
