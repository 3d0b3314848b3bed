// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/repair_report.hpp"

#include <algorithm>
#include <functional>

#include "base/length_text.hpp"
#include "geometry/number_text.hpp"

namespace dmp::geometry {

namespace {

std::string count_of(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// A line for each of a few things, the largest first; of more of them, how many there are.
template <class Thing, class Size, class Text>
void said_of_many(std::vector<std::string>& said, std::vector<Thing> things, Size size, const std::string& what,
                  const Text& text) {
    constexpr std::size_t few = 5;
    std::ranges::stable_sort(things, std::ranges::greater{}, size);
    for (std::size_t k = 0; k < std::min(few, things.size()); ++k) said.push_back(text(things[k]));
    if (things.size() > few) said.push_back("and " + std::to_string(things.size() - few) + " smaller " + what);
}

}  // namespace

bool RepairReport::changed() const {
    const auto filled = [](const SurfaceHole& hole) { return hole.triangles > 0; };
    return welded_corners + without_area + duplicates + inner_walls + t_junctions + turned > 0 || !thrown.empty() ||
           std::ranges::any_of(holes, filled) || by == RepairedBy::vote || by == RepairedBy::wrap;
}

std::vector<std::string> RepairReport::lines() const {
    std::vector<std::string> said;
    const auto in_spacings = [&](double length) { return number_text(length / spacing) + " spacings"; };
    if (equal_corners > 0)
        said.push_back(count_of(equal_corners, "corner", "corners") + " made one with another at the same place");
    if (welded_corners > 0)
        said.push_back(count_of(welded_corners, "corner", "corners") + " welded to another within " +
                       in_spacings(weld_distance));
    if (without_area > 0) said.push_back(count_of(without_area, "triangle", "triangles") + " without area dropped");
    if (duplicates > 0)
        said.push_back(count_of(duplicates, "triangle", "triangles") + " dropped that were there already");
    if (inner_walls > 0)
        said.push_back(count_of(inner_walls, "triangle", "triangles") +
                       " dropped that lay back to back between bodies that touch");
    if (t_junctions > 0)
        said.push_back(count_of(t_junctions, "corner", "corners") + " put on edges of other triangles (T-junctions)");
    if (separated_edges > 0)
        said.push_back(count_of(separated_edges, "edge", "edges") + " in which pieces touched given to one piece each");
    if (turned > 0) said.push_back(count_of(turned, "triangle", "triangles") + " turned to face outward");
    said_of_many(said, thrown, &ThrownPiece::area, "pieces thrown away", [&](const ThrownPiece& piece) {
        return "a piece of " + count_of(piece.triangles, "triangle", "triangles") + " at " +
               position_text(piece.position) + " thrown away: " +
               (piece.is_small ? "it is " + in_spacings(piece.diagonal) + " large"
                               : "it has no volume, its area is " + number_text(piece.area) + " m^2");
    });
    std::vector<SurfaceHole> filled, left;
    for (const SurfaceHole& hole : holes) (hole.triangles > 0 ? filled : left).push_back(hole);
    const auto hole_text = [&](const SurfaceHole& hole) {
        return "a hole of " + count_of(hole.edges, "edge", "edges") + " around " + position_text(hole.position) + ", " +
               in_spacings(hole.perimeter) + " around, ";
    };
    said_of_many(said, filled, &SurfaceHole::perimeter, "holes filled", [&](const SurfaceHole& hole) {
        return hole_text(hole) + "filled with " + count_of(hole.triangles, "triangle", "triangles");
    });
    const std::string what = by == RepairedBy::wrap ? "wrapped" : "left open";
    said_of_many(said, left, &SurfaceHole::perimeter, "holes " + what,
                 [&](const SurfaceHole& hole) { return hole_text(hole) + what; });
    if (by == RepairedBy::vote)
        said.push_back("the winding number says what is inside; it leaves " + number_text(100 * doubt) +
                       " % of the places in doubt");
    if (by == RepairedBy::wrap)
        said.push_back("another surface wrapped around it, " + in_spacings(wrap_offset) +
                       " outside of it and across what is narrower than " + in_spacings(wrap_alpha));
    if (self_intersections > 0)
        said.push_back("it meets itself in " + count_of(self_intersections, "pair", "pairs") +
                       " of triangles, the first at " + position_text(*first_self_intersection) +
                       ": what lies inside any part of it counts as inside");
    return said;
}

}  // namespace dmp::geometry
