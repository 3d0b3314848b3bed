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

/// An empty box, to be extended by include().
[[nodiscard]] Box empty_box();
[[nodiscard]] bool is_empty(const Box& box);
/// Tests the axes x and y, or all three (`dimension` 2 or 3).
[[nodiscard]] bool contains(const Box& box, const Vec& position, int dimension);
void include(Box& box, const Vec& position);
/// Extends the box to the group's particles, including the radius of spheres; with a limit, only to those inside it.
/// Particles without a finite position are ignored.
void include(Box& box, const std::optional<FrameGroup>& group, const Box* limit = nullptr);

}  // namespace dmp::postproc
