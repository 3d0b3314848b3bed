// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/resolution.hpp"

#include <array>
#include <limits>

#include "base/length_text.hpp"
#include "base/number_text.hpp"
#include "particles/cell_grid.hpp"

namespace dmp::solver {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Particles across from which on Poiseuille flow is within 5 %, and those for 1 %: its error is 1 / n^2.
constexpr double fewest_across = 4.5, good_across = 10;
/// Cosine of the largest angle between two surfaces that face each other, and between a surface's normal and the way
/// to a particle in front of it.
constexpr double facing = 0.8;

/// Where the first rows of rigid particles have their surfaces.
struct Surfaces {
    std::vector<Vec> point, normal;
};

Surfaces surfaces_of(const ParticleSet& set) {
    Surfaces surfaces;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::rigid || set.wall_distance[i] > set.spacing) continue;
        if (set.wall_normal[i].isZero()) continue;
        surfaces.point.push_back(set.position[i] + set.wall_distance[i] * set.wall_normal[i]);
        surfaces.normal.push_back(set.wall_normal[i]);
    }
    return surfaces;
}

/// Looks from a place at the surfaces in front of which it lies.
class Sight {
  public:
    Sight(const ParticleSet& set, double reach) : surfaces_(surfaces_of(set)), reach_(reach) {
        Coordinates points;
        for (int axis = 0; axis < 3; ++axis)
            for (const Vec& point : surfaces_.point) points[axis].push_back(point[axis]);
        grid_ = CellGrid(points, surfaces_.point.size(), set.dimension, reach);
    }

    /// Between the nearest surface and the nearest that faces it; infinite if there are none within reach.
    [[nodiscard]] double width_at(const Vec& x) const {
        double to_nearest = infinity;
        Vec normal = Vec::Zero();
        for_each_in_front(x, [&](double distance, const Vec& its_normal) {
            if (distance >= to_nearest) return;
            to_nearest = distance;
            normal = its_normal;
        });
        double to_opposite = infinity;
        for_each_in_front(x, [&](double distance, const Vec& its_normal) {
            if (its_normal.dot(normal) < -facing) to_opposite = std::min(to_opposite, distance);
        });
        return to_nearest + to_opposite;
    }

  private:
    template <class Visit>
    void for_each_in_front(const Vec& x, const Visit& visit) const {
        grid_.for_each_near({x[0], x[1], x[2]}, reach_, [&](int k) {
            const Vec away = x - surfaces_.point[static_cast<std::size_t>(k)];
            const Vec& normal = surfaces_.normal[static_cast<std::size_t>(k)];
            const double distance = away.norm();
            if (distance < reach_ && away.dot(normal) > facing * distance) visit(distance, normal);
        });
    }

    Surfaces surfaces_;
    double reach_;
    CellGrid grid_;
};

}  // namespace

std::optional<NarrowGap> narrowest_gap(const ParticleSet& set, double width) {
    const Sight sight(set, width);
    NarrowGap gap{width, Vec::Zero(), 0};
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::fluid) continue;
        const double here = sight.width_at(set.position[i]);
        if (here >= width) continue;
        ++gap.particles;
        if (here < gap.width) gap = {here, set.position[i], gap.particles};
    }
    return gap.particles > 0 ? std::optional(gap) : std::nullopt;
}

std::vector<Warning> resolution_warnings(const Scene& scene, const ParticleSet& set) {
    const auto gap = narrowest_gap(set, fewest_across * set.spacing);
    if (!gap) return {};
    const double across = gap->width / set.spacing;
    return {{"particles.spacing", scene.particles.spacing.location,
             "leaves " + number_text(across, 2) + " particles across the narrowest gap between walls, at " +
                 position_text(gap->place, set.dimension) + ": flow through it is about " +
                 number_text(100 / (across * across), 2) + " % too strong",
             "take " + length_text(gap->width / good_across) + " or less: ten across, 1 %"}};
}

}  // namespace dmp::solver
