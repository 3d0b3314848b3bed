// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solids_that_meet.hpp"

#include <cmath>
#include <cstddef>

#include "geometry/number_text.hpp"
#include "geometry/surface_intersections.hpp"

namespace dmp::geometry {

namespace {

std::vector<const Solid*> solids_called(const Geometry& geometry, const std::vector<std::string>& names) {
    std::vector<const Solid*> solids;
    for (const std::string& name : names)
        if (const Solid* solid = geometry.solid(name)) solids.push_back(solid);
    return solids;
}

Box box_of_triangle(const TriangleSurface& surface, int number) {
    const auto& [a, b, c] = surface.triangles[static_cast<std::size_t>(number)];
    const auto corner = [&](int k) -> const Vec& { return surface.corners[static_cast<std::size_t>(k)]; };
    return {corner(a).cwiseMin(corner(b)).cwiseMin(corner(c)), corner(a).cwiseMax(corner(b)).cwiseMax(corner(c))};
}

}  // namespace

std::string SolidMeeting::text(double metres, const std::string& unit) const {
    const Vec at = position / metres;
    const std::string around =
        "(" + number_text(at.x()) + ", " + number_text(at.y()) + ", " + number_text(at.z()) + ") " + unit;
    if (other.empty())
        return "'" + one + "' meets itself in " + std::to_string(crossings) +
               (crossings == 1 ? " pair of triangles, at " : " pairs of triangles, the first at ") + around;
    const std::string both = "'" + one + "' and '" + other + "' ";
    if (volume > 0)
        return both + "share " + number_text(volume / std::pow(metres, 3)) + " " + unit + "^3, around " + around;
    return both + "cross each other in " + std::to_string(crossings) + " places, the first at " + around;
}

std::vector<SolidMeeting> solids_that_meet_themselves(const Geometry& geometry, const std::vector<std::string>& names) {
    std::vector<SolidMeeting> found;
    for (const Solid* solid : solids_called(geometry, names)) {
        const auto pairs = self_intersections(solid->surface);
        if (pairs.empty()) continue;
        const Box first = box_of_triangle(solid->surface, pairs.front().first);
        const Box second = box_of_triangle(solid->surface, pairs.front().second);
        found.push_back({.one = solid->name,
                         .other = {},
                         .crossings = pairs.size(),
                         .position = 0.5 * (first.low.cwiseMax(second.low) + first.high.cwiseMin(second.high))});
    }
    return found;
}

std::vector<SolidMeeting> solids_that_overlap(const Geometry& geometry, const std::vector<std::string>& names,
                                              double tolerance) {
    std::vector<SolidMeeting> found;
    const auto solids = solids_called(geometry, names);
    for (std::size_t one = 0; one < solids.size(); ++one)
        for (std::size_t other = one + 1; other < solids.size(); ++other) {
            const SolidOverlap overlap = overlap_of(solids[one]->surface, solids[other]->surface, tolerance);
            if (!overlap.any()) continue;
            found.push_back({.one = solids[one]->name,
                             .other = solids[other]->name,
                             .crossings = overlap.crossings,
                             .volume = overlap.volume,
                             .position = *overlap.first});
        }
    return found;
}

}  // namespace dmp::geometry
