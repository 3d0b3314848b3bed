// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "geometry/geometry.hpp"
#include "mesher/solid_cells.hpp"
#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"

namespace dmp::mesher {

/// Where nodes of a solid of cells should stand.
struct LatticeMarks {
    Box extent;  ///< of the drawn solid [m]
    /// By axis, low and high: whether the solid has a flat side there, across the axis, of a spacing or more.
    std::array<std::array<bool, 2>, 3> flat{};
    /// By axis: the coordinate of the outermost points of what is clamped (its ends in 2-D, its rim in 3-D), where
    /// they all have the same one [m].
    std::array<std::optional<double>, 3> anchor{};
};

/// The marks of an area. What is clamped are the segments of its edge that lie on the anchor; where none does, the
/// anchor itself. `anchor`: may be null, for none; `spacing`: of the particles [m].
[[nodiscard]] LatticeMarks marks_of(const Region& region, const CurveSet* anchor, double spacing);
/// What lies between a bent anchor and the straight line through its ends, outside the area: where a cell of the solid
/// reaches into it, the anchor holds it as if it were full. Loops as those of the area.
[[nodiscard]] Region behind_anchor(const Region& region, const CurveSet& anchor, double spacing);
/// The same marks of a volume, with triangles.
[[nodiscard]] LatticeMarks marks_of(const TriangleSurface& solid, const TriangleSurface* anchor, double spacing);

/// A lattice for one solid: along each axis nodes stand on the anchor's mark, or else on a flat side of the solid, and
/// the step changes by at most `most_stretched`, if that lets nodes stand on the flat side beyond, too. The scene's
/// lattice stays along an axis without either, and where the solid reaches a periodic side or a plane of symmetry, on
/// which nodes have to stand.
[[nodiscard]] BoxLattice own_lattice(const ParticleSpace& space, const BoxLattice& of_scene, const LatticeMarks& marks);
/// Of a step's change by which the solid's far side is on the lattice, too [-].
constexpr double most_stretched = 0.05;

/// What the report says of a lattice that is not the scene's; empty: it is.
[[nodiscard]] std::string lattice_text(const BoxLattice& of_scene, const BoxLattice& own);

}  // namespace dmp::mesher
