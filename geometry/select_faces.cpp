// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/select_faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "base/length_text.hpp"
#include "base/nearest_name.hpp"
#include "base/shell_word.hpp"
#include "geometry/chains.hpp"
#include "geometry/number_text.hpp"
#include "geometry/segments.hpp"
#include "geometry/surface_box.hpp"

namespace dmp::geometry {

namespace {

/// Of a triangle in 3-D, or the two ends of a segment in 2-D.
template <std::size_t N>
using Corners = std::array<Vec, N>;
/// The corners' coordinates, the smallest first: the same triangle or segment is found again elsewhere.
template <std::size_t N>
using Key = std::array<std::array<double, 3>, N>;

Corners<3> corners_of(const TriangleSurface& surface, std::size_t triangle) {
    Corners<3> corners;
    for (std::size_t c = 0; c < 3; ++c)
        corners.at(c) = surface.corners[static_cast<std::size_t>(surface.triangles[triangle].at(c))];
    return corners;
}

template <std::size_t N>
Key<N> key_of(const Corners<N>& corners) {
    Key<N> key{};
    for (std::size_t c = 0; c < N; ++c) key.at(c) = {corners.at(c)[0], corners.at(c)[1], corners.at(c)[2]};
    std::ranges::sort(key);
    return key;
}

Vec outward(const Corners<3>& triangle) {
    return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
}

/// Areas lie on the left of their boundary.
Vec outward(const Corners<2>& segment) {
    const Vec along = segment[1] - segment[0];
    return Vec(along.y(), -along.x(), 0).normalized();
}

template <std::size_t N>
bool fits(const FaceSelection& asked, const Corners<N>& corners, double tolerance) {
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
    return outward(corners).dot(asked.normal->normalized()) >= std::cos(asked.angle) - 1e-12;
}

[[noreturn]] void refuse_unknown(const Geometry& geometry, const FaceSelection& asked, const std::string& what) {
    const auto names = geometry.names();
    const std::string near = nearest_name(asked.of, names);
    throw InputError(
        asked.location,
        "selection '" + asked.name + "': the geometry has no " + what + " '" + asked.of + "' (" + geometry.file + ")",
        "it names " + quoted_list(names) + (near.empty() ? "" : "; did you mean '" + near + "'?"));
}

[[noreturn]] void refuse_exception(const FaceSelection& asked, const std::string& name, const std::string& what) {
    throw InputError(asked.location,
                     "selection '" + asked.name + "': there is no " + what + " '" + name + "' to except",
                     "select '" + name + "' before it, or name it in the geometry");
}

[[noreturn]] void refuse_empty(const Geometry& geometry, const FaceSelection& asked, const Box& box) {
    // With the digits that a plane asks for.
    const LengthUnit unit = length_unit(std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff()));
    std::string span;
    for (int axis = 0; axis < geometry.dimension; ++axis)
        span += std::string(axis > 0 ? ", " : "") + "xyz"[axis] + " from " + number_text(box.low[axis] / unit.metres) +
                " " + unit.name + " to " + number_text(box.high[axis] / unit.metres) + " " + unit.name;
    throw InputError(
        asked.location,
        "selection '" + asked.name + "': no " + (geometry.dimension == 3 ? "face" : "curve") + " of '" + asked.of +
            "' is like that",
        "'" + asked.of + "' has " + span + "; " + quoted_command("dmp inspect", geometry.file) + " tells more");
}

SurfaceSet selected_faces(const Geometry& geometry, const FaceSelection& asked) {
    const Solid* solid = geometry.solid(asked.of);
    const SurfaceSet* of = geometry.surface_set(asked.of);
    if (solid == nullptr && of == nullptr) refuse_unknown(geometry, asked, "volume or surface");
    const TriangleSurface& whole = solid != nullptr ? solid->surface : of->surface;
    const Box box = box_of(whole);
    const double tolerance = 1e-5 * box.extent().norm();
    std::set<Key<3>> taken;
    for (const std::string& name : asked.except) {
        const SurfaceSet* set = geometry.surface_set(name);
        if (set == nullptr) refuse_exception(asked, name, "surface");
        for (std::size_t t = 0; t < set->surface.triangles.size(); ++t)
            taken.insert(key_of(corners_of(set->surface, t)));
    }
    SurfaceSet set{asked.name, {}, {}};
    std::vector<int> number(whole.corners.size(), -1);
    for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
        const Corners<3> corners = corners_of(whole, t);
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
    if (set.surface.triangles.empty()) refuse_empty(geometry, asked, box);
    return set;
}

std::vector<Corners<2>> segments_of(const CurveSet& set) {
    std::vector<Corners<2>> segments;
    for (const Polyline& piece : set.pieces)
        for_each_segment(piece, [&](const Vec& a, const Vec& b) { segments.push_back({a, b}); });
    return segments;
}

CurveSet selected_curves(const Geometry& geometry, const FaceSelection& asked) {
    const Region* region = geometry.region(asked.of);
    const CurveSet* of = geometry.curve_set(asked.of);
    if (region == nullptr && of == nullptr) refuse_unknown(geometry, asked, "area or curve");
    std::vector<Corners<2>> segments;
    if (region != nullptr)
        for_each_segment(*region, [&](const Vec& a, const Vec& b) { segments.push_back({a, b}); });
    else
        segments = segments_of(*of);
    Box box;
    box.low.setConstant(std::numeric_limits<double>::infinity());
    box.high = -box.low;
    for (const auto& segment : segments)
        for (const Vec& end : segment) {
            box.low = box.low.cwiseMin(end);
            box.high = box.high.cwiseMax(end);
        }
    const double tolerance = 1e-5 * box.extent().norm();
    std::set<Key<2>> taken;
    for (const std::string& name : asked.except) {
        const CurveSet* set = geometry.curve_set(name);
        if (set == nullptr) refuse_exception(asked, name, "curve");
        for (const auto& segment : segments_of(*set)) taken.insert(key_of(segment));
    }
    std::vector<CurvePiece> pieces;
    for (const auto& segment : segments)
        if (fits(asked, segment, tolerance) && !taken.contains(key_of(segment)))
            pieces.push_back({segment[0], segment[1]});
    if (pieces.empty()) refuse_empty(geometry, asked, box);
    return {.name = asked.name, .pieces = maximal_chains(pieces)};
}

}  // namespace

void select_faces(Geometry& geometry, const std::vector<FaceSelection>& selections) {
    for (const FaceSelection& asked : selections) {
        const auto names = geometry.names();
        if (std::ranges::find(names, asked.name) != names.end())
            throw InputError(asked.location, "the geometry has a '" + asked.name + "' already (" + geometry.file + ")",
                             "give the selection another name");
        if (geometry.dimension == 3)
            geometry.surfaces.push_back(selected_faces(geometry, asked));
        else
            geometry.curves.push_back(selected_curves(geometry, asked));
    }
}

}  // namespace dmp::geometry
