// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/gap_measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/disjoint_sets.hpp"
#include "base/errors.hpp"
#include "base/unlisted_value.hpp"
#include "particles/cell_pieces.hpp"

namespace dmp::solver {

GapMeasure::GapMeasure(const Measure& measure, const ParticleSet& set)
    : space_(static_cast<const ParticleSpace&>(set)), between_(measure.between) {
    const int part = set.part_named(*measure.part);
    DisjointSets together(set.size());
    join_cells(set, together);
    for (const Bond& bond : set.bonds)
        if (bond.join < 0) together.join(static_cast<std::size_t>(bond.a), static_cast<std::size_t>(bond.b));
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.part[i] == part) piece_[static_cast<int>(i)] = static_cast<int>(together.find(i));
    const auto is_first = [&](const auto& node) { return node.second == piece_.begin()->second; };
    if (std::ranges::all_of(piece_, is_first))
        throw InputError(measure.part.location,
                         "'" + *measure.part + "' is one body, and the gap '" + *measure.name +
                             "' is measured between two of one part",
                         "leave the measure out, or draw the part as two curves or areas");
}

GapMeasure::Patch GapMeasure::patch_of(const Vec& position, const SolidSurface& surface) const {
    const double thickness = surface.depth + surface.opposite;
    switch (between_) {
        case GapBetween::surfaces:
            if (surface.normal.isZero()) return {{}, position, Vec::Zero(), surface.depth, 0};
            return {{}, position + surface.depth * surface.normal, surface.normal, 0, thickness / 2};
        case GapBetween::middles:
            return {{}, position + (surface.depth - thickness / 2) * surface.normal, surface.normal, 0, 0};
        case GapBetween::particles:
            return {{}, position, Vec::Zero(), 0, 0};
    }
    unlisted_value(between_);
}

double GapMeasure::distance(const Patch& from, const Patch& to) const {
    const Vec apart = nearest_image(from.centre - to.centre, space_);
    const double rounded = from.radius + to.radius;
    const double across = apart.dot(to.normal), along = (apart - across * to.normal).norm();
    if (to.normal.isZero() || along > space_.spacing / 2) {
        const double beyond = to.normal.isZero() ? along : along - space_.spacing / 2;
        return std::hypot(across, beyond) - rounded;
    }
    // Below 0 where two surfaces that face each other overlap; those of the far sides are farther behind.
    const bool overlaps = to.half_through > 0 && from.normal.dot(to.normal) < 0 && -across < to.half_through;
    return (overlaps ? across : std::abs(across)) - rounded;
}

double GapMeasure::smallest(const SpringBodies& springs) const {
    constexpr double any = std::numeric_limits<double>::infinity();
    std::vector<Patch> patches;
    for (std::size_t body = 0; body < springs.bodies().size(); ++body) {
        const SpringBody& of = *springs.bodies()[body];
        const std::vector<PresentSurface> surfaces = of.surfaces(0, any);
        for (std::size_t node = 0; node < of.nodes(); ++node)
            if (const auto found = piece_.find(of.ids()[node]); found != piece_.end()) {
                patches.push_back(patch_of(of.position(node), surfaces[node].surface));
                patches.back().piece = {body, found->second};
            }
    }
    double smallest = any;
    for (const Patch& from : patches)
        for (const Patch& to : patches)
            if (from.piece != to.piece) smallest = std::min(smallest, distance(from, to));
    return smallest;
}

}  // namespace dmp::solver
