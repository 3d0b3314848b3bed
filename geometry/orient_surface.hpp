// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// What orient_outward found and did.
struct Orientation {
    std::size_t pieces = 0;        ///< connected ones
    std::size_t turned = 0;        ///< triangles whose sense of turning was changed
    std::size_t open_edges = 0;    ///< with one triangle
    std::size_t many_fold = 0;     ///< edges with more than two triangles
    std::size_t contradicted = 0;  ///< edges whose two triangles cannot both be turned right (a Moebius band)
    /// The ends of the first open edge.
    std::optional<std::array<Vec, 2>> first_open;
    /// Of the edges with more than two triangles, the middle of the first; else a place at the first contradicted one.
    std::optional<Vec> first_unclear;

    [[nodiscard]] bool closed() const { return open_edges == 0 && many_fold == 0 && contradicted == 0; }
};

/// Turns the triangles of a surface so that they face outward: neighbours alike, and each connected piece by how many
/// others lie around it (the inner wall of a hollow body faces into the hollow). Triangles are neighbours where they
/// share two corners and no third triangle does. The sides of a piece that is not closed are a guess. Where closed
/// pieces cross themselves, what all of them enclose is not negative.
Orientation orient_outward(TriangleSurface& surface);

}  // namespace dmp::geometry
