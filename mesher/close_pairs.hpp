// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"
#include "particles/periodic_images.hpp"

namespace dmp::mesher {

/// For each particle the others near it, periodic images and mirror images too, listed once for several looks while
/// particles move a little.
class ClosePairs {
  public:
    /// Lists what is within `reach` [m] of the particles that `left_out` is 0 for. Wraps no positions.
    void find(const ParticleSet& set, const std::vector<std::uint8_t>& left_out, double reach, int threads);
    /// Takes the particles' new places, and moves the images along.
    void follow(const ParticleSet& set);

    /// Calls visit(j, x_i - x_j, its square) for what is listed for particle i.
    template <int D, class Visit>
    void for_each_near(std::size_t i, const Visit& visit) const {
        for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
            const auto j = static_cast<std::size_t>(listed_[k]);
            std::array<double, D> separation;
            double square = 0;
            for (std::size_t axis = 0; axis < D; ++axis) {
                separation[axis] = points_[axis][i] - points_[axis][j];
                square += separation[axis] * separation[axis];
            }
            visit(j < owned_ ? j : static_cast<std::size_t>(images_[j - owned_].source), separation, square);
        }
    }
    [[nodiscard]] std::size_t bytes() const;

  private:
    /// A particle seen again: sign times its place plus offset, along each axis.
    struct Image {
        std::int32_t source;
        std::array<double, 3> sign, offset;
    };
    void add_images(const ParticleSet& set, int axis, double reach);

    std::size_t owned_ = 0;
    Coordinates points_;  ///< of particles, then of images
    std::vector<Image> images_;
    std::vector<std::size_t> first_;  ///< by particle, and one more
    std::vector<std::int32_t> listed_;
};

}  // namespace dmp::mesher
