// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "particles/particle_set.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Which triangles of walls belong to one smooth surface: those of one part that share an edge, also across a periodic
/// side, at which they bend by less than 32 degrees: more than those of a tube of 12 facets. Whether triangles face the
/// same side does not matter.
class SmoothEdges {
  public:
    static constexpr double largest_bend_cosine = 0.8480480961564260;  ///< of 32 degrees

    explicit SmoothEdges(const ParticleSpace& space);

    /// Whether two triangles, by their numbers in wall_triangles, share a smooth edge.
    [[nodiscard]] bool join(std::size_t a, std::size_t b) const;

  private:
    std::vector<std::array<std::size_t, 2>> joined_;  ///< pairs of triangles, the lower number first; ascending
};

}  // namespace dmp::solver
