// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace dmp::solver {

/// The largest of many squares; infinite if one is NaN. Computed in separate lanes, so that the compiler can
/// vectorise: it may not itself reorder comparisons, because their order matters for NaN.
class LargestSquare {
  public:
    static constexpr std::ptrdiff_t lanes = 8, at_a_time = 4 * lanes;
    using Squares = std::array<double, at_a_time>;

    void update(const Squares& squares) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        for (std::ptrdiff_t k = 0; k < at_a_time; k += lanes)
            for (std::ptrdiff_t lane = 0; lane < lanes; ++lane) {
                const double square = squares[k + lane];
                largest_[lane] = square <= largest_[lane] ? largest_[lane] : square < infinity ? square : infinity;
            }
    }
    [[nodiscard]] double value() const { return *std::max_element(largest_.begin(), largest_.end()); }

  private:
    std::array<double, lanes> largest_{};
};

}  // namespace dmp::solver
