// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/sphere_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace dmp::solver {

namespace {

constexpr int most_classes = 12;  ///< 4000:1; what is smaller joins the last but is found all the same

}  // namespace

SphereSearch::SphereSearch(const SphereRows& rows, double gap, std::span<const float> skins)
    : rows_(rows), gap_(gap), skins_(skins), class_of_(rows.total()) {
    const auto motion = rows.motion();
    double largest = 0;
    for (std::size_t i = 0; i < rows.total(); ++i) largest = std::max(largest, motion[i].radius() + skins[i]);
    std::array<std::vector<std::int32_t>, most_classes> members;
    for (std::size_t i = 0; i < rows.total(); ++i) {
        const int below = std::min(most_classes - 1, std::ilogb(largest / (motion[i].radius() + skins[i])));
        members[static_cast<std::size_t>(below)].push_back(static_cast<std::int32_t>(i));
    }
    for (std::size_t below = most_classes; below-- > 0;) {
        if (members[below].empty()) continue;
        for (const std::int32_t i : members[below]) class_of_[i] = static_cast<std::uint8_t>(grids_.size());
        grids_.emplace_back().fill(rows, skins, members[below], gap);
    }
}

void SphereSearch::Grid::fill(const SphereRows& rows, std::span<const float> skins,
                              const std::vector<std::int32_t>& members, double gap) {
    const auto motion = rows.motion();
    std::array<double, 3> high{};
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (const std::int32_t i : members) {
        largest_radius = std::max(largest_radius, motion[i].radius() + skins[i]);
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], motion[i].position.c[axis]);
            high[axis] = std::max(high[axis], motion[i].position.c[axis]);
        }
    }
    cell = 2 * largest_radius + gap;
    // A lone stray sphere must not make a grid of billions of empty cells.
    const auto cells_at = [&](double size) {
        double all = 1;
        for (int axis = 0; axis < 3; ++axis) all *= std::floor((high[axis] - low[axis]) / size) + 1;
        return all;
    };
    while (cells_at(cell) > 4.0 * static_cast<double>(members.size()) + 64) cell *= 1.5;
    inverse_cell = 1 / cell;
    for (int axis = 0; axis < 3; ++axis)
        cells[axis] = static_cast<std::int64_t>(std::floor((high[axis] - low[axis]) * inverse_cell)) + 1;

    start.assign(static_cast<std::size_t>(cells[0] * cells[1] * cells[2]) + 1, 0);
    std::vector<std::int32_t> cell_of(members.size());
    for (std::size_t k = 0; k < members.size(); ++k) {
        const double* x = motion[members[k]].position.c;
        cell_of[k] = static_cast<std::int32_t>(number_of(at(0, x[0]), at(1, x[1]), at(2, x[2])));
        ++start[static_cast<std::size_t>(cell_of[k]) + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<std::int32_t> next(start.begin(), start.end() - 1);
    row.resize(members.size());
    for (auto& values : position) values.resize(members.size());
    for (std::size_t k = 0; k < members.size(); ++k) {
        const auto entry = static_cast<std::size_t>(next[cell_of[k]]++);
        row[entry] = members[k];
        for (std::size_t c = 0; c < 3; ++c) position[c][entry] = motion[members[k]].position.c[c];
        position[3][entry] = motion[members[k]].radius() + skins[members[k]];
    }
}

std::int64_t SphereSearch::Grid::at(int axis, double x) const {
    const double index = (x - low[axis]) * inverse_cell;
    return static_cast<std::int64_t>(std::clamp(index, 0.0, static_cast<double>(cells[axis] - 1)));
}

SphereSearch::Grid::Cell SphereSearch::Grid::cell_at(const double* x, double shift) const {
    return {at(0, x[0] + shift), at(1, x[1] + shift), at(2, x[2] + shift)};
}

std::size_t SphereSearch::Grid::find_near(std::int32_t begin, std::int32_t end, const SphereMotion& sphere,
                                          double around, std::vector<std::int32_t>& scratch) const {
    const double x = sphere.position.c[0], y = sphere.position.c[1], z = sphere.position.c[2];
    if (scratch.size() < static_cast<std::size_t>(end - begin)) scratch.resize(static_cast<std::size_t>(end - begin));
    std::size_t count = 0;
    for (std::int32_t k = begin; k < end; ++k) {
        const double dx = position[0][k] - x, dy = position[1][k] - y, dz = position[2][k] - z,
                     touch = position[3][k] + around;
        scratch[count] = k;  // without a branch, which would be guessed wrong
        count += dx * dx + dy * dy + dz * dz < touch * touch ? 1 : 0;
    }
    return count;
}

template <class Keep>
void SphereSearch::Grid::for_each_near(const SphereMotion& sphere, double around, std::vector<std::int32_t>& scratch,
                                       const Keep& keep) const {
    const double reach = around + largest_radius;
    const Cell first = cell_at(sphere.position.c, -reach), last = cell_at(sphere.position.c, reach);
    for (std::int64_t z = first[2]; z <= last[2]; ++z)
        for (std::int64_t y = first[1]; y <= last[1]; ++y) {
            const std::size_t count = find_near(start[number_of(first[0], y, z)], start[number_of(last[0], y, z) + 1],
                                                sphere, around, scratch);
            for (std::size_t n = 0; n < count; ++n) keep(row[scratch[n]]);
        }
}

template <class Keep>
void SphereSearch::Grid::for_each_near_behind(std::int32_t member, const SphereMotion& sphere, double around,
                                              std::vector<std::int32_t>& scratch, const Keep& keep) const {
    const double reach = around + largest_radius;
    const Cell own = cell_at(sphere.position.c, 0), first = cell_at(sphere.position.c, -reach),
               last = cell_at(sphere.position.c, reach);
    // Of its own cell the later ones; then the cells that come later.
    const std::int32_t own_end = start[number_of(own[0], own[1], own[2]) + 1];
    const std::size_t in_line = find_near(start[number_of(own[0], own[1], own[2])],
                                          start[number_of(last[0], own[1], own[2]) + 1], sphere, around, scratch);
    for (std::size_t n = 0; n < in_line; ++n)
        if (scratch[n] >= own_end || row[scratch[n]] > member) keep(row[scratch[n]]);
    for (std::int64_t z = own[2]; z <= last[2]; ++z)
        for (std::int64_t y = z == own[2] ? own[1] + 1 : first[1]; y <= last[1]; ++y) {
            const std::size_t count = find_near(start[number_of(first[0], y, z)], start[number_of(last[0], y, z) + 1],
                                                sphere, around, scratch);
            for (std::size_t n = 0; n < count; ++n) keep(row[scratch[n]]);
        }
}

void SphereSearch::append_near(std::int32_t begin, std::int32_t end, std::vector<NearSpheres>& found) const {
    const auto owned = static_cast<std::int32_t>(rows_.owned());
    std::vector<std::int32_t> scratch(256);
    for (std::int32_t i = begin; i < end; ++i) {
        const SphereMotion& sphere = rows_.motion()[i];
        const std::size_t own = class_of_[i];
        const double around = sphere.radius() + skins_[i] + gap_;
        const auto keep = [&](std::int32_t j) {
            if ((i < owned || j < owned) && !(sphere.fixed() && rows_.motion()[j].fixed())) found.push_back({i, j});
        };
        grids_[own].for_each_near_behind(i, sphere, around, scratch, keep);
        for (std::size_t larger = own + 1; larger < grids_.size(); ++larger)
            grids_[larger].for_each_near(sphere, around, scratch, keep);
    }
}

}  // namespace dmp::solver
