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

/// The resolved scene `as_run`, with a comment where the one that was written has another value:
///   duration = "0.5 s"  # in the scene: "4 s"
/// Both have the same keys. differences() goes by the values in the comments, and knows lines that are comments: # KEY
/// = VALUE. Lines that begin with ## are remarks.
[[nodiscard]] std::string with_values_of(const std::string& written, const std::string& as_run);

/// What differs between two resolved scenes (resolved_scene), in the order of the present one; values that are no
/// longer there come last. The number of threads is left out: it changes no result. Empty only if both are the same.
[[nodiscard]] std::vector<ValueDifference> differences(const std::string& before, const std::string& now);

/// Those of them that change the state of a run at a later time: a run may go on with any others. Left out are how long
/// it runs (run.duration; run.until_steady where it is taken away), how often and what it writes (output, but for
/// output.average_from), what it measures and what that should be, and its title. How often it writes changes the
/// lengths of its steps, and so the last digits of what follows.
[[nodiscard]] std::vector<ValueDifference> differences_in_state(const std::string& before, const std::string& now);

/// The first five, a line each: "\n  part.blood.viscosity: was "0.0035 Pa*s", is "0.004 Pa*s"".
[[nodiscard]] std::string differences_text(const std::vector<ValueDifference>& differences);

}  // namespace dmp::scene
