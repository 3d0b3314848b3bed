// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace dmp::scene {

/// A value that two scenes do not share.
struct ValueDifference {
    std::string key;          ///< as for --set: "part.blood.viscosity"
    std::string before, now;  ///< as resolved_scene writes them; "": not there
};

/// What differs between two resolved scenes (resolved_scene), in the order of the present one; values that are no
/// longer there come last. The number of threads is left out: it changes no result. Empty only if both are the same.
[[nodiscard]] std::vector<ValueDifference> differences(const std::string& before, const std::string& now);

/// The first five, a line each: "\n  part.blood.viscosity: was "0.0035 Pa*s", is "0.004 Pa*s"".
[[nodiscard]] std::string differences_text(const std::vector<ValueDifference>& differences);

}  // namespace dmp::scene
