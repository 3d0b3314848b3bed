// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "solver/results/frame.hpp"

namespace dmp::solver {

/// The frames that a run has left, to be read back one by one.
class FrameSource {
  public:
    virtual ~FrameSource() = default;
    /// Of each frame, ascending [s].
    [[nodiscard]] virtual const std::vector<double>& times() const = 0;
    /// A frame by its number, without the walls at rest. Throws InputError where a file of it is missing or damaged.
    [[nodiscard]] virtual Frame read(std::size_t frame) const = 0;
    /// The walls at rest, where there are some. Throws InputError where their file is damaged.
    [[nodiscard]] virtual std::optional<FrameGroup> walls() const = 0;
};

}  // namespace dmp::solver
