// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace dmp::scene {

/// Throws an InputError with the place of the first key of a TOML text that has more parts than any scene needs,
/// a.b.c...: the TOML library builds and removes a table for each part by recursion, which ends the process where they
/// are many. `file` is its name for errors.
void check_key_depth(std::string_view text, const std::string& file);

}  // namespace dmp::scene
