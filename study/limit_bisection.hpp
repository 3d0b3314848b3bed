// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "study/uses.hpp"

namespace dmp::study {

/// What is known of a rung of a ladder of values, which leads away from a value that is clean.
enum class RungState {
    unknown,  ///< not run to its end
    clean,
    bad,    ///< it breaks, departs, or is refused
    failed  ///< it ended otherwise, as one that was killed: what its value does is not known
};

/// Between which rungs a limit lies. Rungs count from 1; 0 is the value that the ladder begins at.
struct RungBracket {
    std::size_t clean = 0;  ///< the last one that is clean
    std::size_t bad = 0;    ///< the first one that is bad; one more than there are rungs: none is known to be

    [[nodiscard]] bool is_settled() const { return bad == clean + 1; }
};

/// What is beyond a bad rung is taken as bad, what is before a clean one as clean: the lowest bad rung, and the highest
/// clean one below it. A failed rung says nothing.
[[nodiscard]] RungBracket bracket_of(const std::vector<RungState>& rungs);

/// The failed rung that keeps the limit from being found, from 1; none where there is none, or the limit is known.
[[nodiscard]] std::optional<std::size_t> failed_rung(const std::vector<RungState>& rungs);

/// The rung that halves what is left, from 1; none where the limit is known, or a failed rung lies in between.
[[nodiscard]] std::optional<std::size_t> next_rung(const std::vector<RungState>& rungs);

/// How many runs it takes at most until the limit is known; failed ones are run again.
[[nodiscard]] std::size_t most_runs_left(const std::vector<RungState>& rungs);

}  // namespace dmp::study
