// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::cli {

// What commands share that write a study of a scene themselves.

/// A time [s]. Throws InputError where it is none above 0; `option` names it.
[[nodiscard]] double time_of(const std::string& text, const char* option);

/// "5 %", or "0.05". Throws InputError where it is no number above 0.
[[nodiscard]] double tolerance_of(const std::string& text);

/// Kinds of measures that are added to a scene without any, to compare its runs by: conserved ones, its kinetic energy,
/// and the amount of its one species.
[[nodiscard]] std::vector<std::string> measures_to_add(const Scene& scene);
/// What adds them, each under the name of its kind, as --set takes it.
[[nodiscard]] std::vector<std::string> overrides_that_add(const std::vector<std::string>& measures);

/// Throws InputError where its runs have fewer than two rows of measures; `until`: what --until says, "": nothing.
void need_two_rows(const Scene& scene, const std::string& until);

}  // namespace dmp::cli
