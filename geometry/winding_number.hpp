// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "geometry/triangle_surface.hpp"
#include "geometry/triangle_tree.hpp"

namespace dmp::geometry {

/// The solid angle of a triangle seen from a point, above 0 where its back is seen, from -2 pi to 2 pi (van Oosterom
/// and Strackee, IEEE Transactions on Biomedical Engineering 30 (1983) 125).
double solid_angle(const Vec& point, const std::array<Vec, 3>& triangle);

/// How often a surface winds around a point: the sum of the solid angles of its triangles over 4 pi (Jacobson, Kavan
/// and Sorkine-Hornung, ACM Transactions on Graphics 32 (2013) 33). It is 1 inside a closed surface that faces outward
/// and 0 outside; holes make it change gradually, and what is above one half is inside. This is the plain sum over all
/// triangles, which WindingNumber is tested against.
double winding_number(const TriangleSurface& surface, const Vec& point);

/// The same for many points: triangles far away count together, as one dipole at the mean of their places (Barill,
/// Dickson, Schmidt, Levin and Jacobson, ACM Transactions on Graphics 37 (2018) 43, their first order). Never changed
/// after construction: any number of threads may ask it.
class WindingNumber {
  public:
    /// @param farness how many radii away triangles are far; larger is closer to the plain sum.
    explicit WindingNumber(const TriangleSurface& surface, double farness = 3);

    [[nodiscard]] double at(const Vec& point) const;
    [[nodiscard]] bool inside(const Vec& point) const { return at(point) > 0.5; }

  private:
    struct Dipole {
        Vec moment = Vec::Zero();    ///< sum of areas times normals [m^2]
        Vec position = Vec::Zero();  ///< mean weighted with the areas
        double reach = 0;            ///< square of the distance from which on the point sees the dipole [m^2]
    };
    TriangleTree tree_;
    std::vector<Dipole> dipoles_;  ///< by node
};

}  // namespace dmp::geometry
