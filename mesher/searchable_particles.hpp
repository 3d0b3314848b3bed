// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "mesher/uses.hpp"
#include "particles/cell_grid.hpp"
#include "particles/particle_set.hpp"

namespace dmp::mesher {

/// A particle set with its periodic images and those at planes of symmetry, sorted for neighbour search.
class SearchableParticles {
  public:
    /// Images come within `reach`; cells of the grid have the edge `cell`, which suits searches about that far.
    SearchableParticles(const ParticleSet& set, double reach, double cell) : owned_(set.size()) {
        for (int axis = 0; axis < set.dimension; ++axis)
            for (const Vec& point : set.position)
                points_[axis].push_back(set.periodic[axis] ? wrapped(point[axis], set.box.low[axis], set.box.high[axis])
                                                           : point[axis]);
        points_[2].resize(set.dimension == 2 ? 0 : set.size());
        images_ = periodic_images(points_, set.size(), set.box, set.periodic, reach);
        for (int axis = 0; axis < set.dimension; ++axis)
            for (const PeriodicImage& image : images_)
                points_[axis].push_back(points_[axis][image.source] + image.shift[axis]);
        for (int axis = 0; axis < set.dimension; ++axis) mirror(set, axis, reach);
        grid_ = CellGrid(points_, points_[0].size(), set.dimension, cell);
        reach_ = reach;
        dimension_ = set.dimension == 3 ? 3 : 2;
    }
    SearchableParticles(const ParticleSet& set, double reach) : SearchableParticles(set, reach, reach) {}

    /// Calls visit(j, x_i - x_j) for every other particle j (or image of one) nearer than the reach.
    template <class Visit>
    void for_each_neighbour(std::size_t i, Visit&& visit) const {
        const std::array<double, 3> here{points_[0][i], points_[1][i], dimension_ == 3 ? points_[2][i] : 0.0};
        grid_.for_each_near(here, reach_, [&](int k) {
            const auto index = static_cast<std::size_t>(k);
            const Vec separation(here[0] - points_[0][index], here[1] - points_[1][index],
                                 dimension_ == 3 ? here[2] - points_[2][index] : 0.0);
            if (separation.squaredNorm() >= reach_ * reach_ || index == i) return;
            visit(index < owned_ ? index : static_cast<std::size_t>(images_[index - owned_].source), separation);
        });
    }

    /// Calls visit(j, squared distance, place) for every particle j (or image of one, at its place) nearer to the point
    /// than `radius`, which is at most the reach.
    template <class Visit>
    void for_each_near(const Vec& point, double radius, Visit&& visit) const {
        grid_.for_each_near({point[0], point[1], point[2]}, radius, [&](int k) {
            const auto index = static_cast<std::size_t>(k);
            const Vec position(points_[0][index], points_[1][index], dimension_ == 3 ? points_[2][index] : 0.0);
            const double square = (point - position).squaredNorm();
            if (square >= radius * radius) return;
            visit(index < owned_ ? index : static_cast<std::size_t>(images_[index - owned_].source), square, position);
        });
    }

  private:
    /// Adds the images that lie within the reach of the planes across an axis.
    void mirror(const ParticleSet& set, int axis, double reach) {
        for (const int side : {0, 1}) {
            if (!set.mirrored[axis][side]) continue;
            const double plane = (side == 0 ? set.box.low : set.box.high)[axis];
            for (std::size_t k = 0, count = points_[0].size(); k < count; ++k) {
                if (std::abs(points_[axis][k] - plane) > reach) continue;
                for (int a = 0; a < set.dimension; ++a)
                    points_[a].push_back(a == axis ? 2 * plane - points_[a][k] : points_[a][k]);
                images_.push_back({k < owned_ ? static_cast<int>(k) : images_[k - owned_].source, {}});
            }
        }
    }

    std::size_t owned_;
    Coordinates points_;
    std::vector<PeriodicImage> images_;
    CellGrid grid_;
    double reach_ = 0;
    int dimension_ = 2;
};

}  // namespace dmp::mesher
