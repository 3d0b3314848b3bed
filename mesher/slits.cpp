// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/slits.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "geometry/exact_predicates.hpp"
#include "geometry/inside_test.hpp"
#include "geometry/segments.hpp"

namespace dmp::mesher {

namespace {

/// Points along a side of a box; and how much of the box a piece must have to count.
constexpr std::size_t points_of_a_side = 10;
constexpr double least_piece = 0.1;

using Segments = std::vector<std::pair<Vec, Vec>>;

Segments near_box(const Segments& outline, const Vec& low, const Vec& high) {
    Segments near;
    std::ranges::copy_if(outline, std::back_inserter(near), [&](const auto& segment) {
        const auto& [a, b] = segment;
        for (int axis = 0; axis < 2; ++axis)
            if (std::max(a[axis], b[axis]) < low[axis] || std::min(a[axis], b[axis]) > high[axis]) return false;
        return true;
    });
    return near;
}

/// Whether points of the area in a box are in two pieces: neighbours belong together unless the outline passes between
/// them.
bool has_two_pieces(const InsideTest& area, const Segments& outline, const Vec& low, const Vec& step) {
    constexpr std::size_t side = points_of_a_side;
    std::vector<Vec> points;
    std::vector<bool> inside;
    for (std::size_t n = 0; n < side * side; ++n) {
        const Vec within(static_cast<double>(n % side) + 0.5, static_cast<double>(n / side) + 0.5, 0);
        points.emplace_back(low + within.cwiseProduct(step) / side);
        inside.push_back(area.side_of(points.back()) == Side::inside);
    }
    DisjointSets together(points.size());
    const auto join = [&](std::size_t a, std::size_t b) {
        const bool is_cut = std::ranges::any_of(outline, [&](const auto& segment) {
            return segments_cross(points[a], points[b], segment.first, segment.second);
        });
        if (inside[a] && inside[b] && !is_cut) together.join(a, b);
    };
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (n % side + 1 < side) join(n, n + 1);
        if (n + side < points.size()) join(n, n + side);
    }
    std::vector<std::size_t> count(points.size(), 0);
    for (std::size_t n = 0; n < points.size(); ++n)
        if (inside[n]) ++count[together.find(n)];
    return std::ranges::count_if(count, [](std::size_t of_piece) {
               return static_cast<double>(of_piece) >= least_piece * side * side;
           }) > 1;
}

}  // namespace

std::optional<Vec> closed_slit(const Region& area, const BoxLattice& boxes, const SolidCells& cells) {
    const InsideTest inside(area);
    Segments outline;
    for_each_segment(area, [&](const Vec& a, const Vec& b) { outline.emplace_back(a, b); });
    for (std::size_t n = 0; n < cells.cells.size(); ++n) {
        constexpr double whole = 1e-9;
        if (std::abs(cells.fillings[n].volume / boxes.volume() - 1) < whole) continue;
        const Vec low = cells.nodes[static_cast<std::size_t>(cells.cells[n].node[0])].position;
        const Vec high = low + boxes.step;
        if (has_two_pieces(inside, near_box(outline, low, high), low, boxes.step)) return 0.5 * (low + high);
    }
    return std::nullopt;
}

}  // namespace dmp::mesher
