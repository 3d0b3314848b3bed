// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/select_faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "base/nearest_name.hpp"
#include "geometry/number_text.hpp"
#include "geometry/surface_box.hpp"

namespace dmp {

namespace {

using Corners = std::array<Vec, 3>;
/// A triangle by its corners' coordinates, the smallest first: the same one in another surface is found again.
using Key = std::array<std::array<double, 3>, 3>;

Corners corners_of(const TriangleSurface& surface, std::size_t triangle) {
    Corners corners;
    for (std::size_t c = 0; c < 3; ++c)
        corners.at(c) = surface.corners[static_cast<std::size_t>(surface.triangles[triangle].at(c))];
    return corners;
}

Key key_of(const Corners& corners) {
    Key key{};
    for (std::size_t c = 0; c < 3; ++c) key.at(c) = {corners.at(c)[0], corners.at(c)[1], corners.at(c)[2]};
    std::ranges::sort(key);
    return key;
}

bool fits(const FaceSelection& asked, const Corners& corners, double tolerance) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto& plane = asked.in_plane.at(static_cast<std::size_t>(axis));
        for (const Vec& corner : corners)
            if (plane && std::abs(corner[axis] - *plane) > tolerance) return false;
    }
    if (asked.in_box) {
        const Vec low = asked.in_box->low.cwiseMin(asked.in_box->high).array() - tolerance;
        const Vec high = asked.in_box->low.cwiseMax(asked.in_box->high).array() + tolerance;
        for (const Vec& corner : corners)
            if ((corner.array() < low.array()).any() || (corner.array() > high.array()).any()) return false;
    }
    if (!asked.normal) return true;
    const Vec across = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    return across.dot(asked.normal->normalized()) >= std::cos(asked.angle) - 1e-12;
}

const TriangleSurface& surface_called(const Geometry& geometry, const FaceSelection& asked) {
    if (const Solid* solid = geometry.solid(asked.of)) return solid->surface;
    if (const SurfaceSet* set = geometry.surface_set(asked.of)) return set->surface;
    const auto names = geometry.names();
    const std::string near = nearest_name(asked.of, names);
    throw InputError(asked.place,
                     "selection '" + asked.name + "': the drawing has no volume or surface '" + asked.of + "' (" +
                         geometry.file + ")",
                     "it names " + quoted_list(names) + (near.empty() ? "" : "; did you mean '" + near + "'?"));
}

SurfaceSet selected(const Geometry& geometry, const FaceSelection& asked) {
    const TriangleSurface& whole = surface_called(geometry, asked);
    const Box box = box_of(whole);
    const double tolerance = 1e-5 * box.extent().norm();
    std::set<Key> taken;
    for (const std::string& name : asked.except) {
        const SurfaceSet* set = geometry.surface_set(name);
        if (set == nullptr)
            throw InputError(asked.place,
                             "selection '" + asked.name + "': there is no surface '" + name + "' to except",
                             "select '" + name + "' before it");
        for (std::size_t t = 0; t < set->surface.triangles.size(); ++t)
            taken.insert(key_of(corners_of(set->surface, t)));
    }
    SurfaceSet set{asked.name, {}, {}};
    std::vector<int> number(whole.corners.size(), -1);
    for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
        const Corners corners = corners_of(whole, t);
        if (!fits(asked, corners, tolerance) || (!taken.empty() && taken.contains(key_of(corners)))) continue;
        std::array<int, 3> renumbered{};
        for (std::size_t c = 0; c < 3; ++c) {
            int& known = number[static_cast<std::size_t>(whole.triangles[t].at(c))];
            if (known < 0) {
                known = static_cast<int>(set.surface.corners.size());
                set.surface.corners.push_back(corners.at(c));
            }
            renumbered.at(c) = known;
        }
        set.surface.triangles.push_back(renumbered);
    }
    if (!set.surface.triangles.empty()) return set;
    std::string span;
    for (int axis = 0; axis < 3; ++axis)
        span += std::string(axis > 0 ? ", " : "") + "xyz"[axis] + " from " + number_text(box.low[axis]) + " m to " +
                number_text(box.high[axis]) + " m";
    throw InputError(asked.place, "selection '" + asked.name + "': no face of '" + asked.of + "' is like that",
                     "'" + asked.of + "' has " + span + "; 'dmp inspect " + geometry.file + "' tells more");
}

}  // namespace

void select_faces(Geometry& geometry, const std::vector<FaceSelection>& selections) {
    for (const FaceSelection& asked : selections) {
        if (geometry.dimension != 3)
            throw InputError(asked.place, "selection '" + asked.name + "': the drawing lies in the plane",
                             "name the curves in the drawing");
        const auto names = geometry.names();
        if (std::ranges::find(names, asked.name) != names.end())
            throw InputError(asked.place, "the drawing has a '" + asked.name + "' already (" + geometry.file + ")",
                             "give the selection another name");
        geometry.surfaces.push_back(selected(geometry, asked));
    }
}

}  // namespace dmp
