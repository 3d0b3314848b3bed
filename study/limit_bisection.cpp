// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/limit_bisection.hpp"

#include <algorithm>
#include <bit>

namespace dmp::study {

RungBracket bracket_of(const std::vector<RungState>& rungs) {
    RungBracket bracket;
    bracket.bad = static_cast<std::size_t>(std::ranges::find(rungs, RungState::bad) - rungs.begin()) + 1;
    for (std::size_t rung = 1; rung < bracket.bad; ++rung)
        if (rungs[rung - 1] == RungState::clean) bracket.clean = rung;
    return bracket;
}

std::optional<std::size_t> failed_rung(const std::vector<RungState>& rungs) {
    const RungBracket bracket = bracket_of(rungs);
    for (std::size_t rung = bracket.clean + 1; rung < bracket.bad; ++rung)
        if (rungs[rung - 1] == RungState::failed) return rung;
    return {};
}

std::optional<std::size_t> next_rung(const std::vector<RungState>& rungs) {
    const RungBracket bracket = bracket_of(rungs);
    if (bracket.is_settled() || failed_rung(rungs)) return {};
    return bracket.clean + (bracket.bad - bracket.clean) / 2;
}

std::size_t most_runs_left(const std::vector<RungState>& rungs) {
    const RungBracket bracket = bracket_of(rungs);
    return static_cast<std::size_t>(std::bit_width(bracket.bad - bracket.clean - 1));
}

}  // namespace dmp::study
