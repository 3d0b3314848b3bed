// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "report/limits_facts.hpp"

namespace dmp::report {

/// The limits of a scene as SVG that needs nothing else: a row for each dial, with values as multiples of the scene's
/// own on a logarithmic axis. A bar goes to the last clean value, a paler one from there to the first bad one, where a
/// mark says how it ends; a line stands at the limit that the program states.
[[nodiscard]] std::string limits_picture(const LimitsFacts& limits);

/// Writes limits.svg, of what limits.json has. Throws InputError where that cannot be read, ResourceError.
void write_limits_picture(const std::filesystem::path& folder);

}  // namespace dmp::report
