// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/crossing_pieces.hpp"

#include "geometry/surface_intersections.hpp"
#include "geometry/surface_pieces.hpp"

namespace dmp::geometry {

std::vector<std::pair<int, int>> turn_crossing_pieces(TriangleSurface& surface) {
    auto pairs = self_intersections(surface);
    if (pairs.empty()) return pairs;
    const SurfacePieces pieces(surface);
    std::vector<char> crosses(pieces.all().size(), 0);
    for (const auto& [one, other] : pairs)
        if (pieces.piece_of(one) != pieces.piece_of(other))
            crosses[pieces.piece_of(one)] = crosses[pieces.piece_of(other)] = 1;
    for (std::size_t k = 0; k < crosses.size(); ++k) {
        if (crosses[k] == 0 || pieces.all()[k].volume >= 0) continue;
        for (const int t : pieces.all()[k].triangles) {
            auto& corners = surface.triangles[static_cast<std::size_t>(t)];
            std::swap(corners[1], corners[2]);
        }
    }
    return pairs;
}

}  // namespace dmp::geometry
