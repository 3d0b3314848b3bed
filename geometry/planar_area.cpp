// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/planar_area.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/length_text.hpp"
#include "geometry/chains.hpp"
#include "geometry/number_text.hpp"

namespace dmp::geometry {

namespace {

template <class Visit>
void for_each_point(Geometry& geometry, Visit&& visit) {
    for (auto& region : geometry.regions) {
        for (auto& loop : region.loops) std::ranges::for_each(loop.points, visit);
    }
    for (auto& set : geometry.curves) {
        for (auto& piece : set.pieces) std::ranges::for_each(piece.points, visit);
    }
    for (auto& [name, positions] : geometry.points) std::ranges::for_each(positions, visit);
}

}  // namespace

Region planar_area(const std::string& name, const std::vector<int>& surfaces, CadCurves& curves,
                   const std::string& file) {
    const auto wrong = [&](const std::string& what, const std::string& what_to_do) {
        return InputError({.file = file}, "region '" + name + "' " + what, what_to_do);
    };
    auto search = closed_loops(curves.boundary(surfaces));
    if (search.loose_end) {
        throw wrong("is not closed: its boundary ends at " + position_text(*search.loose_end, 2),
                    "Curves that meet must share the point, or have the same coordinates to the last digit.");
    }
    Region region{.name = name, .loops = std::move(search.loops)};
    if (region.loops.empty()) throw wrong("is empty", "Give its Physical Surface a surface with a boundary.");
    if (const auto crossing = self_crossing(region)) {
        throw wrong("crosses itself near " + position_text(*crossing, 2),
                    "Check the geometry, or the parameters it was given.");
    }
    double around = 0;
    for (const auto& loop : region.loops) around += loop.length();
    if (region.area() <= 1e-12 * around * around) {
        throw wrong("has no area, or is thinner than 1e-12 of its length",
                    "Check the geometry, or the parameters and the unit that it was given.");
    }
    return region;
}

void lay_flat(Geometry& geometry) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box box{.low = Vec::Constant(infinity), .high = Vec::Constant(-infinity)};
    for_each_point(geometry, [&](const Vec& point) {
        box.low = box.low.cwiseMin(point);
        box.high = box.high.cwiseMax(point);
    });
    if (!box.low.allFinite() || !box.high.allFinite()) {
        throw InputError({.file = geometry.file}, "the geometry has a point without finite coordinates",
                         "Check the geometry, or the parameters it was given.");
    }
    const double height = std::max(-box.low.z(), box.high.z());
    const double width = std::max(box.extent().x(), box.extent().y());
    if (height > 1e-9 * width) {
        throw InputError({.file = geometry.file},
                         "the geometry leaves the plane z = 0: it reaches z = " +
                             length_text(box.high.z() == height ? height : -height),
                         "Draw it in the x-y plane, or give it volumes.");
    }
    for_each_point(geometry, [](Vec& point) { point.z() = 0; });
    box.low.z() = box.high.z() = 0;
    geometry.box = box;
}

}  // namespace dmp::geometry
