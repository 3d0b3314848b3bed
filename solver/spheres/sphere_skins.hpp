// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/parallel/ranks.hpp"
#include "solver/spheres/sphere_rows.hpp"

namespace dmp {

/// How far each sphere may go before a list of neighbours misses pairs: in proportion to how fast it is among the
/// others. One skin for all would be worn out by the one that flies off.
class SphereSkins {
  public:
    /// Skins of `mean` on average [m] in the frame [m/s]; none wider than `most`. All ranks take part.
    void make(const SphereRows& rows, const std::array<double, 3>& frame, double mean, double most, const Ranks& ranks,
              int threads);
    /// Narrows each to that share of another list's.
    void keep_within(double share, const SphereSkins& other);

    [[nodiscard]] double mean() const { return mean_; }
    [[nodiscard]] double least() const;
    /// Of all ranks.
    [[nodiscard]] double most() const { return most_; }
    /// By row, copies included [m].
    [[nodiscard]] std::span<const float> by_row() const { return skin_; }
    /// 1 / skin^2 by row [1/m^2]: how much of a skin a way takes.
    [[nodiscard]] std::span<const float> inverse_squares() const { return inverse_square_; }
    [[nodiscard]] std::size_t bytes() const { return (skin_.capacity() + inverse_square_.capacity()) * sizeof(float); }

  private:
    void find_inverse_squares();

    double mean_ = 0, most_ = 0;
    std::vector<float> skin_, inverse_square_;
};

}  // namespace dmp
