// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/touching_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "particles/cell_grid.hpp"

namespace dmp::particles {

namespace {

/// Spheres whose radii differ by less than a factor of two, those of other periods behind the others.
struct SizeClass {
    std::vector<int> ids;
    Coordinates points;
    double largest = 0;  ///< radius [m]
    CellGrid grid;

    void add(int id, const std::array<double, 3>& point, double radius) {
        ids.push_back(id);
        for (std::size_t axis = 0; axis < 3; ++axis) points.at(axis).push_back(point.at(axis));
        largest = std::max(largest, radius);
    }
};

struct Classes {
    std::vector<SizeClass> classes;  ///< the largest first
    std::vector<std::size_t> of;     ///< by particle
    Coordinates points;              ///< of all particles, within the periods

    [[nodiscard]] std::array<double, 3> point(std::size_t i) const {
        return {points[0][i], points[1][i], points[2][i]};
    }
};

Classes size_classes(const ParticleSet& set) {
    Classes all;
    for (auto& axis : all.points) axis.resize(set.size());
    std::vector<int> spheres;
    double largest = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto along = static_cast<Eigen::Index>(axis);
            const double x = set.position[i][along];
            all.points.at(axis)[i] = set.periodic.at(axis) ? wrapped(x, set.box.low[along], set.box.high[along]) : x;
        }
        if (set.kind(i) == PartKind::spheres) largest = std::max(largest, set.radius[i]);
    }
    all.of.resize(set.size());
    const auto add = [&](std::size_t i, const std::array<double, 3>& point) {
        if (set.kind(i) != PartKind::spheres) return;
        const auto number = static_cast<std::size_t>(std::log2(largest / set.radius[i]));
        if (all.classes.size() <= number) all.classes.resize(number + 1);
        all.of[i] = number;
        all.classes[number].add(static_cast<int>(i), point, set.radius[i]);
    };
    for (std::size_t i = 0; i < set.size(); ++i) add(i, all.point(i));
    for (const PeriodicImage& image : periodic_images(all.points, set.size(), set.box, set.periodic, 2 * largest)) {
        std::array<double, 3> point = all.point(static_cast<std::size_t>(image.source));
        for (std::size_t axis = 0; axis < 3; ++axis) point.at(axis) += image.shift.at(axis);
        add(static_cast<std::size_t>(image.source), point);
    }
    for (SizeClass& each : all.classes)
        if (!each.ids.empty()) each.grid = CellGrid(each.points, each.ids.size(), 3, 2 * each.largest);
    return all;
}

}  // namespace

std::vector<TouchingSpheres> touching_spheres(const ParticleSet& set) {
    std::vector<TouchingSpheres> pairs;
    if (set.count(PartKind::spheres) == 0) return pairs;
    const Classes all = size_classes(set);
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::spheres) continue;
        const std::array<double, 3> centre = all.point(i);
        const int own = static_cast<int>(i);
        for (std::size_t number = all.of[i]; number < all.classes.size(); ++number) {
            const SizeClass& other = all.classes[number];
            if (other.ids.empty()) continue;
            other.grid.for_each_near(centre, set.radius[i] + other.largest, [&](int k) {
                const int id = other.ids[static_cast<std::size_t>(k)];
                if (number == all.of[i] && id < own) return;  // found from the other one
                double square = 0;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double apart = other.points.at(axis)[static_cast<std::size_t>(k)] - centre.at(axis);
                    square += apart * apart;
                }
                if (id == own && square == 0) return;
                const double overlap = set.radius[i] + set.radius[static_cast<std::size_t>(id)] - std::sqrt(square);
                if (overlap >= 0) pairs.push_back({std::min(own, id), std::max(own, id), overlap});
            });
        }
    }
    std::ranges::sort(pairs, {}, [](const TouchingSpheres& pair) { return std::tuple(pair.a, pair.b, pair.overlap); });
    return pairs;
}

}  // namespace dmp::particles
