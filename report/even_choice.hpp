// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "report/uses.hpp"
#include "solver/results/frame.hpp"

namespace dmp::report {

/// Every n-th particle, evenly spread, the same ones in all frames: those that a frame is the first to have are put in
/// the order of their place along a Morton curve (Morton, 1966), and every n-th of them is chosen for good.
class EvenChoice {
  public:
    /// `every` is at least 1.
    explicit EvenChoice(std::size_t every);

    /// Which particles of a frame's group to show: indices, ascending.
    [[nodiscard]] std::vector<std::size_t> of(const FrameGroup& group);

  private:
    std::size_t every_;
    std::size_t met_ = 0;                          ///< particles so far
    std::vector<std::int64_t> chosen_, left_out_;  ///< ids, sorted
};

}  // namespace dmp::report
