// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/weld_corners.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "geometry/surface_edges.hpp"

namespace dmp::geometry {

namespace {

/// By corner: the one that it becomes.
std::vector<int> representatives(const std::vector<Vec>& corners, double distance) {
    // A direction askew to all that is drawn on purpose: few corners lie at the same place along it.
    const Vec along = Vec(0.5477225575, 0.6172133998, 0.5648352817).normalized();
    std::vector<std::pair<double, int>> order(corners.size());
    for (std::size_t k = 0; k < corners.size(); ++k) order[k] = {along.dot(corners[k]), static_cast<int>(k)};
    std::ranges::sort(order);
    double largest = 0;
    for (const Vec& corner : corners) largest = std::max(largest, corner.cwiseAbs().maxCoeff());
    const double reach = distance + 1e-15 * largest;  // sums along the direction are rounded
    std::vector<int> becomes(corners.size(), -1);
    for (std::size_t k = 0; k < order.size(); ++k) {
        const int here = order[k].second;
        if (becomes[static_cast<std::size_t>(here)] >= 0) continue;
        becomes[static_cast<std::size_t>(here)] = here;
        const Vec& position = corners[static_cast<std::size_t>(here)];
        for (std::size_t n = k + 1; n < order.size() && order[n].first - order[k].first <= reach; ++n) {
            int& other = becomes[static_cast<std::size_t>(order[n].second)];
            if (other < 0 && (corners[static_cast<std::size_t>(order[n].second)] - position).norm() <= distance)
                other = here;
        }
    }
    return becomes;
}

std::array<int, 3> sorted(std::array<int, 3> corners) {
    std::ranges::sort(corners);
    return corners;
}

/// Whether a triangle turns through its corners from the lowest to the next higher one.
bool turns_up(const std::array<int, 3>& corners) {
    const auto lowest = static_cast<std::size_t>(std::ranges::min_element(corners) - corners.begin());
    return corners.at((lowest + 1) % 3) < corners.at((lowest + 2) % 3);
}

/// Marks those of `cancelled` without which edges of the kept surface would be open.
void take_back(const TriangleSurface& surface, const std::vector<int>& cancelled, std::vector<char>& kept) {
    TriangleSurface all;
    all.corners = surface.corners;
    std::vector<int> number;
    for (std::size_t t = 0; t < kept.size(); ++t)
        if (kept[t] != 0) number.push_back(static_cast<int>(t));
    number.insert(number.end(), cancelled.begin(), cancelled.end());
    for (const int t : number) all.triangles.push_back(surface.triangles[static_cast<std::size_t>(t)]);
    const auto first_cancelled = static_cast<int>(number.size() - cancelled.size());

    std::vector<std::vector<std::size_t>> edges_at(cancelled.size());  // of a triangle: its edges
    std::vector<std::vector<int>> cancelled_at;                        // of an edge
    std::vector<int> sides_at;
    const std::vector<SurfaceEdge> edges = edges_of(all);
    for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
        std::vector<int> here;
        for (const SurfaceEdge& side : sides)
            if (side.triangle >= first_cancelled) here.push_back(side.triangle - first_cancelled);
        if (here.empty()) return;
        for (const int triangle : here) edges_at[static_cast<std::size_t>(triangle)].push_back(cancelled_at.size());
        sides_at.push_back(static_cast<int>(sides.size() - here.size()));
        cancelled_at.push_back(std::move(here));
    });
    std::vector<std::size_t> open;
    for (std::size_t edge = 0; edge < sides_at.size(); ++edge)
        if (sides_at[edge] % 2 != 0) open.push_back(edge);
    std::vector<char> back(cancelled.size(), 0);
    while (!open.empty()) {
        const std::size_t edge = open.back();
        open.pop_back();
        if (sides_at[edge] % 2 == 0) continue;
        for (const int triangle : cancelled_at[edge]) {
            if (back[static_cast<std::size_t>(triangle)] != 0) continue;
            back[static_cast<std::size_t>(triangle)] = 1;
            kept[static_cast<std::size_t>(cancelled[static_cast<std::size_t>(triangle)])] = 1;
            for (const std::size_t other : edges_at[static_cast<std::size_t>(triangle)]) {
                ++sides_at[other];
                open.push_back(other);
            }
            break;
        }
    }
}

}  // namespace

std::size_t weld_corners(TriangleSurface& surface, double distance) {
    const std::vector<int> becomes = representatives(surface.corners, distance);
    std::vector<char> used(surface.corners.size(), 0);
    for (auto& triangle : surface.triangles)
        for (int& corner : triangle) {
            corner = becomes[static_cast<std::size_t>(corner)];
            used[static_cast<std::size_t>(corner)] = 1;
        }
    std::vector<int> number(surface.corners.size(), -1);
    std::size_t left = 0;
    for (std::size_t k = 0; k < surface.corners.size(); ++k) {
        if (used[k] == 0) continue;
        number[k] = static_cast<int>(left);
        surface.corners[left++] = surface.corners[k];
    }
    const std::size_t gone = surface.corners.size() - left;
    surface.corners.resize(left);
    for (auto& triangle : surface.triangles)
        for (int& corner : triangle) corner = number[static_cast<std::size_t>(corner)];
    return gone;
}

DroppedTriangles drop_useless_triangles(TriangleSurface& surface) {
    DroppedTriangles dropped;
    std::erase_if(surface.triangles, [&](const std::array<int, 3>& triangle) {
        const auto& [a, b, c] = triangle;
        const Vec& corner = surface.corners[static_cast<std::size_t>(a)];
        const double area = (surface.corners[static_cast<std::size_t>(b)] - corner)
                                .cross(surface.corners[static_cast<std::size_t>(c)] - corner)
                                .norm();
        if (area > 0) return false;
        ++dropped.without_area;
        return true;
    });

    std::vector<std::pair<std::array<int, 3>, int>> order;  // by corners: the triangles that have them
    order.reserve(surface.triangles.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        order.emplace_back(sorted(surface.triangles[t]), static_cast<int>(t));
    std::ranges::sort(order);
    std::vector<char> kept(surface.triangles.size(), 1);
    std::vector<int> cancelled;
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        int up = 0;
        for (; end < order.size() && order[end].first == order[begin].first; ++end) {
            const auto t = static_cast<std::size_t>(order[end].second);
            kept[t] = 0;
            up += turns_up(surface.triangles[t]) ? 1 : -1;
        }
        if (up == 0) cancelled.push_back(order[begin].second);
        for (std::size_t k = begin; k < end && up != 0; ++k) {
            const auto t = static_cast<std::size_t>(order[k].second);
            if (turns_up(surface.triangles[t]) != (up > 0)) continue;
            kept[t] = 1;
            break;
        }
    }
    if (!cancelled.empty()) {
        take_back(surface, cancelled, kept);
        for (const int t : cancelled)
            if (kept[static_cast<std::size_t>(t)] == 0) dropped.inner_walls += 2;
    }
    std::size_t t = 0;
    const std::size_t before = surface.triangles.size();
    std::erase_if(surface.triangles, [&](const auto&) { return kept[t++] == 0; });
    dropped.duplicates = before - surface.triangles.size() - dropped.inner_walls;
    return dropped;
}

}  // namespace dmp::geometry
