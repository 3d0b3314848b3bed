// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "geometry/geometry.hpp"

namespace dmp::geometry {

/// Points from end to end; two pieces are connected where their ends agree bit for bit.
using CurvePiece = std::vector<Vec>;

/// Joins pieces end to end into chains that stop at loose ends and at junctions of more than two; a chain that returns
/// to its start becomes a closed polyline. Chains follow the order and the direction of their first pieces.
std::vector<Polyline> maximal_chains(const std::vector<CurvePiece>& pieces);

struct LoopSearch {
    std::vector<Polyline> loops;   ///< closed, each point once, the region on their left
    std::optional<Vec> loose_end;  ///< an end that nothing continues: the boundary is open
};

/// Closed loops from the boundary pieces of all faces of a region. Pieces that occur twice lie between two of its
/// faces and cancel.
LoopSearch closed_loops(std::vector<CurvePiece> pieces);

/// A point where two boundary segments cross; nothing for a proper region. Exact.
std::optional<Vec> self_crossing(const Region& region);

}  // namespace dmp::geometry
