// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "geometry/geometry.hpp"
#include "mesher/solid_cells.hpp"
#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"

namespace dmp::mesher {

/// A turn about the origin in 2-D: from the axes of the scene to those of a lattice, and back.
class Turn {
  public:
    /// @param angle of the lattice's x axis from that of the scene [rad]
    explicit Turn(double angle = 0);

    [[nodiscard]] bool is_none() const { return sine_ == 0; }
    [[nodiscard]] Vec of(const Vec& point) const;
    [[nodiscard]] Vec back(const Vec& point) const;
    [[nodiscard]] Region of(Region region) const;
    [[nodiscard]] CurveSet of(CurveSet curves) const;

  private:
    double cosine_, sine_;
};

/// The direction of an area's straight sides [rad], -pi/4 to pi/4: of the direction that, with the one across it, has
/// four fifths of the length of its edge or more; 0 where none does.
[[nodiscard]] double direction_of(const Region& region, double spacing);

/// Where a solid of cells in 2-D has its lattice.
struct LatticeInPlane {
    Turn turn;
    BoxLattice boxes;  ///< in turned axes
    std::string text;  ///< what the report says of it; empty: it is the scene's
};

/// A lattice along the straight sides of an area, or along the scene's axes: where the area has no such sides or
/// reaches a periodic side or a plane of symmetry, and where nodes can stand on its anchor only there. The rest as
/// own_lattice. `anchor`: may be null, for none; `step`: of the scene's lattice [m].
[[nodiscard]] LatticeInPlane lattice_in_plane(const ParticleSpace& space, const Vec& step, const Region& region,
                                              const CurveSet* anchor);

}  // namespace dmp::mesher
