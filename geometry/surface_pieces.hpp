// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// A connected piece of a surface.
struct SurfacePiece {
    std::vector<int> triangles;  ///< ascending
    bool closed = true;          ///< each of its edges has two of its triangles
    Box box;                     ///< [m]
    double area = 0;             ///< [m^2]
    double volume = 0;           ///< of a closed one, above 0 where it faces outward [m^3]

    /// Whether it is closed but holds no more than rounding does: a sheet with two sides.
    [[nodiscard]] bool has_no_volume() const;
};

/// The pieces of a surface: triangles are connected where they share an edge and no third triangle does.
class SurfacePieces {
  public:
    explicit SurfacePieces(const TriangleSurface& surface);

    /// By ascending number of their first triangle.
    [[nodiscard]] const std::vector<SurfacePiece>& all() const { return pieces_; }
    [[nodiscard]] std::size_t piece_of(int triangle) const { return piece_of_[static_cast<std::size_t>(triangle)]; }
    [[nodiscard]] double area_around(int triangle) const { return pieces_[piece_of(triangle)].area; }

  private:
    std::vector<SurfacePiece> pieces_;
    std::vector<std::size_t> piece_of_;  ///< by triangle
};

/// Gives each closed piece corners of its own, so that edges in which closed pieces touch others belong to one piece
/// each. Returns how many edges had more than two triangles and now have not.
std::size_t separate_closed_pieces(TriangleSurface& surface);

/// Some of a surface's triangles, with their corners.
TriangleSurface part_of(const TriangleSurface& surface, const std::vector<int>& triangles);

}  // namespace dmp::geometry
