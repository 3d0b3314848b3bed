// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>

#include "geometry/exact_predicates.hpp"
#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// A triangle of a surface as lines parallel to x meet it.
class TriangleAlongX {
  public:
    TriangleAlongX(const TriangleSurface& surface, std::size_t triangle) {
        for (std::size_t k = 0; k < 3; ++k) {
            corner_.at(k) = surface.corners[static_cast<std::size_t>(surface.triangles[triangle].at(k))];
            shadow_.at(k) = Vec(corner_.at(k).y(), corner_.at(k).z(), 0);
        }
        normal_ = (corner_[1] - corner_[0]).cross(corner_[2] - corner_[0]);
        // Of the same exact kind as the test whether a line is in the shadow.
        direction_ = -side_of_line(shadow_[0], shadow_[1], shadow_[2]);
    }

    /// +1: a line goes into what the surface encloses, as x grows; -1: out of it; 0: seen edge-on, no line meets it.
    [[nodiscard]] int direction() const { return direction_; }
    /// Its corners, seen along x: (y, z, 0).
    [[nodiscard]] const std::array<Vec, 3>& shadow() const { return shadow_; }

    /// Whether the line at (y, z) meets it: whether a ray from there towards +y leaves the shadow an odd number of
    /// times. Of the triangles that share an edge or a corner on which the line lies, it meets one for each time that
    /// the surface passes there.
    [[nodiscard]] bool meets(double y, double z) const {
        const Vec point(y, z, 0);
        bool inside = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec& a = shadow_.at(k);
            const Vec& b = shadow_.at((k + 1) % 3);
            const Vec& low = a.y() <= b.y() ? a : b;
            const Vec& high = a.y() <= b.y() ? b : a;
            if (low.y() <= z && z < high.y() && side_of_line(low, high, point) > 0) inside = !inside;
        }
        return inside;
    }

    /// Where it does: on the triangle's plane, but never beyond its corners.
    [[nodiscard]] double x_at(double y, double z) const {
        const auto [low, high] = std::minmax({corner_[0].x(), corner_[1].x(), corner_[2].x()});
        if (normal_.x() == 0) return 0.5 * (low + high);
        const Vec& a = corner_[0];
        const double x = a.x() - (normal_.y() * (y - a.y()) + normal_.z() * (z - a.z())) / normal_.x();
        return std::clamp(x, low, high);
    }

  private:
    std::array<Vec, 3> corner_, shadow_;
    Vec normal_;
    int direction_;
};

}  // namespace dmp::geometry
