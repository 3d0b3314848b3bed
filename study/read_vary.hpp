// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/toml_node.hpp"
#include "study/study.hpp"

namespace dmp::study {

/// Reads the next [[vary]] of a study, whose file, scene and `combine` are known, and checks its values against the
/// scene's schema. Throws InputError.
Vary read_vary(const TomlNode& node, const Study& study);

}  // namespace dmp::study
