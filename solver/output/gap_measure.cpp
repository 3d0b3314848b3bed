// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/gap_measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/disjoint_sets.hpp"
#include "base/errors.hpp"
#include "particles/cell_pieces.hpp"

namespace dmp::solver {

GapMeasure::GapMeasure(const Measure& measure, const ParticleSet& set)
    : space_(static_cast<const ParticleSpace&>(set)) {
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

double GapMeasure::smallest(const SpringBodies& springs) const {
    struct Node {
        std::pair<std::size_t, int> piece;  ///< body now, and piece as drawn
        Vec position;
    };
    std::vector<Node> nodes;
    for (std::size_t body = 0; body < springs.bodies().size(); ++body) {
        const SpringBody& of = *springs.bodies()[body];
        for (std::size_t node = 0; node < of.nodes(); ++node)
            if (const auto found = piece_.find(of.ids()[node]); found != piece_.end())
                nodes.push_back({{body, found->second}, of.position(node)});
    }
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < nodes.size(); ++a)
        for (std::size_t b = a + 1; b < nodes.size(); ++b)
            if (nodes[a].piece != nodes[b].piece)
                smallest =
                    std::min(smallest, nearest_image(nodes[a].position - nodes[b].position, space_).squaredNorm());
    return std::sqrt(smallest);
}

}  // namespace dmp::solver
