// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/toml_node.hpp"
#include "study/study.hpp"

namespace dmp::study {

/// Reads the next [[vary]] of a study, whose file, scene and `combine` are known, and checks its values against the
/// scene's schema. Throws InputError.
Vary read_vary(const TomlNode& node, const Study& study);

/// The value of a formula of other keys that vary, "0.5 * particles.spacing", where these have the values given, in the
/// same order. A name with a dot in it is a key. Throws InputError.
Quantity formula_value(const WrittenText& formula, const std::string& subject, const std::vector<VariedKey>& keys,
                       const std::vector<VariedValue>& values);

}  // namespace dmp::study
