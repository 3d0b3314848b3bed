// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/narrow_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "particles/set_grid.hpp"

namespace dmp::particles {

namespace {

/// Cosine of the largest angle between opposite directions: 180 - 30 degrees.
constexpr double opposite = -0.866;

/// Particles across the gap in which a particle stands, by the solids around it; infinite if there is none.
double across_at(const std::vector<Vec>& solids, double spacing) {
    double nearest = std::numeric_limits<double>::infinity();
    const auto first = std::ranges::min_element(solids, {}, [](const Vec& to) { return to.squaredNorm(); });
    if (std::ranges::none_of(solids, [&](const Vec& to) { return to.dot(*first) < 0; })) return nearest;
    for (std::size_t a = 0; a < solids.size(); ++a)
        for (std::size_t b = a + 1; b < solids.size(); ++b) {
            const double to_a = solids[a].norm(), to_b = solids[b].norm();
            if (solids[a].dot(solids[b]) < opposite * to_a * to_b) nearest = std::min(nearest, to_a + to_b);
        }
    return nearest / spacing - 1;
}

}  // namespace

NarrowGaps find_narrow_gaps(const ParticleSet& set, int across) {
    NarrowGaps found;
    found.fewest = across;
    // In a gap of n particles the farther wall is at most n spacings away; half of one for lattices that do not meet
    // it.
    const SetGrid grid(set, (across - 0.5) * set.spacing);
    std::vector<Vec> solids;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::fluid) continue;
        ++found.fluid;
        solids.clear();
        grid.for_each_near(i, [&](std::size_t j, const Vec& offset) {
            if (set.kind(j) != PartKind::fluid) solids.push_back(offset);
        });
        const double here = across_at(solids, set.spacing);
        if (!(here < across - 0.5)) continue;
        ++found.inside;
        if (const int whole = static_cast<int>(std::lround(here)); whole < found.fewest) {
            found.fewest = whole;
            found.place = set.position[i];
        }
    }
    return found;
}

}  // namespace dmp::particles
