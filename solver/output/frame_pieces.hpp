// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "solver/results/frame.hpp"

namespace dmp::solver {

/// Brings a group's particles into the order of their ids; the bonds stay in theirs and keep their ends.
void sort_by_id(FrameGroup& group);

/// Adds the particles and bonds of another piece of the same frame behind those that are there. Returns what makes it
/// none, or "": another time, other parts, groups with other fields.
[[nodiscard]] std::string add_piece(Frame& frame, Frame&& piece);

/// Puts a frame that all pieces were added to in order. Returns what is wrong with it, or "": a particle that is in two
/// pieces.
[[nodiscard]] std::string finish_pieces(Frame& frame);

}  // namespace dmp::solver
