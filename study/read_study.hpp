// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "study/study.hpp"

namespace dmp::study {

/// Reads and checks a study and its scene. `path` is a study file, or a folder with a study.toml. Throws InputError
/// with file:line:column. `overrides`: values of the scene, "key=value", of which none may be of a key that varies.
Study read_study(const std::string& path, const std::vector<std::string>& overrides = {});

/// Likewise of the text of a study that is, or is to be, in `file`.
Study parse_study(const std::string& text, const std::string& file, const std::vector<std::string>& overrides = {});

}  // namespace dmp::study
