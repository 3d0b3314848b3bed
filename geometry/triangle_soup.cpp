// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle_soup.hpp"

#include <Eigen/Geometry>
#include <bit>
#include <cstdint>
#include <utility>

#include "base/random_number.hpp"
#include "geometry/split_polygon.hpp"

namespace dmp::geometry {

std::size_t SoupBuilder::Hash::operator()(const std::array<double, 3>& position) const {
    std::uint64_t hash = 0;
    for (const double x : position) hash = mixed_bits(hash ^ std::bit_cast<std::uint64_t>(x));
    return hash;
}

SoupBuilder::SoupBuilder() { begin_group(""); }

int SoupBuilder::corner(const Vec& position) {
    const std::array<double, 3> key{position[0] + 0.0, position[1] + 0.0, position[2] + 0.0};  // -0 is 0
    const auto [found, is_new] = corners_.try_emplace(key, static_cast<int>(soup_.surface.corners.size()));
    if (is_new) soup_.surface.corners.emplace_back(key[0], key[1], key[2]);
    return found->second;
}

void SoupBuilder::begin_group(const std::string& name) {
    const auto [found, is_new] = groups_.try_emplace(name, static_cast<int>(soup_.names.size()));
    if (is_new) soup_.names.push_back(name);
    group_ = found->second;
}

void SoupBuilder::add_triangle(int a, int b, int c) {
    const auto at = [&](int k) -> const Vec& { return soup_.surface.corners[static_cast<std::size_t>(k)]; };
    if (!((at(b) - at(a)).cross(at(c) - at(a)).norm() > 0)) {
        ++soup_.surface.left_out;
        return;
    }
    soup_.surface.triangles.push_back({a, b, c});
    soup_.group.push_back(group_);
}

bool SoupBuilder::add_polygon(std::span<const int> corners) {
    if (corners.size() == 3) {
        add_triangle(corners[0], corners[1], corners[2]);
        return true;
    }
    if (corners.size() > most_polygon_corners) return false;
    std::vector<Vec> positions;
    positions.reserve(corners.size());
    for (const int k : corners) positions.push_back(soup_.surface.corners[static_cast<std::size_t>(k)]);
    for (const auto& [a, b, c] : split_polygon(positions)) add_triangle(corners[a], corners[b], corners[c]);
    return true;
}

TriangleSoup SoupBuilder::finish() {
    std::vector<int> number(soup_.names.size(), -1);
    std::vector<std::string> names;
    for (int& group : soup_.group) {
        int& renumbered = number[static_cast<std::size_t>(group)];
        if (renumbered < 0) {
            renumbered = static_cast<int>(names.size());
            names.push_back(soup_.names[static_cast<std::size_t>(group)]);
        }
        group = renumbered;
    }
    soup_.names = std::move(names);
    return std::move(soup_);
}

}  // namespace dmp::geometry
