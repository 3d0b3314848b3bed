// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/parallel/ranks.hpp"
#include "solver/spheres/sphere_rows.hpp"

namespace dmp::solver {

/// How far each sphere may go before a list of neighbours misses pairs: in proportion to how fast it is among the
/// others. One skin for all would be worn out by the one that flies off.
class SphereSkins {
  public:
    /// Skins that would be `mean` on average [m], in a frame [m/s], if none were cut short at `most` [m]. All ranks
    /// take part, and agree on the skins of spheres that they share.
    void make(const SphereRows& rows, const std::array<double, 3>& frame, double mean, double most, const Ranks& ranks,
              int threads);
    /// The same, cut short at that share of another list's skins.
    void make_within(double share, const SphereSkins& other, const SphereRows& rows, const std::array<double, 3>& frame,
                     double mean, const Ranks& ranks, int threads);

    /// As asked for [m].
    [[nodiscard]] double mean() const { return mean_; }
    /// Of this rank's spheres and copies [m].
    [[nodiscard]] double least() const { return least_; }
    [[nodiscard]] double largest() const { return largest_; }
    /// By row, copies included [m].
    [[nodiscard]] std::span<const float> by_row() const { return skin_; }
    /// 1 / skin^2 by row [1/m^2]: how much of a skin a way takes.
    [[nodiscard]] std::span<const float> inverse_squares() const { return inverse_square_; }
    [[nodiscard]] std::size_t bytes() const { return (skin_.capacity() + inverse_square_.capacity()) * sizeof(float); }

  private:
    template <class Limit>
    void make(const SphereRows& rows, const std::array<double, 3>& frame, double mean, const Ranks& ranks, int threads,
              const Limit& limit);

    double mean_ = 0, least_ = 0, largest_ = 0;
    std::vector<float> skin_, inverse_square_;
};

}  // namespace dmp::solver
