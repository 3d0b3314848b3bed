// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/elastic/body_parts.hpp"

namespace dmp::solver {

/// The faces that pairs of cells share: all nodes of it. `corners`: of a cell.
std::vector<BodyParts::Face> faces_between(std::span<const BodyParts::Cell> cells, int corners);

struct CutSolid {
    std::vector<BodyParts> pieces;
    std::vector<int> broken;  ///< origins of the faces that broke
};

/// A body of cells without the faces between these pairs of cells, given by the ids of their particles. Of the cells
/// around a node those that still hang together by faces at that node keep one; the others get copies of it, each with
/// the mass and drag of its own cells: mass and momentum of the whole stay what they are, and so does the energy, as
/// nothing has moved. Cells that no faces connect any more are in different pieces. Pairs without a face between them
/// are left out.
CutSolid cut_faces(const BodyParts& body, std::span<const std::array<int, 2>> between, int dimension);

}  // namespace dmp::solver
