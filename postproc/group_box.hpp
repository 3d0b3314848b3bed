// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "base/vec.hpp"
#include "postproc/uses.hpp"
#include "solver/results/frame.hpp"

namespace dmp::postproc {

[[nodiscard]] Vec position_of(const FrameGroup& group, std::size_t particle);
[[nodiscard]] bool is_finite(const Vec& position);

/// The field of that name, or nullptr.
[[nodiscard]] const FrameField* find_field(const FrameGroup& group, const std::string& name);

/// A box around nothing, which include() makes grow.
[[nodiscard]] Box empty_box();
[[nodiscard]] bool is_empty(const Box& box);
/// In the axes x and y, or in all three (`dimension` 2 or 3).
[[nodiscard]] bool contains(const Box& box, const Vec& position, int dimension);
void include(Box& box, const Vec& position);
/// Grows the box around the group's particles, spheres with their radius; with a limit, only around those inside it.
/// Particles that are nowhere do not count.
void include(Box& box, const std::optional<FrameGroup>& group, const Box* limit = nullptr);

}  // namespace dmp::postproc
