// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "scene/measure_columns.hpp"
#include "scene/measure_subject.hpp"
#include "scene/scene.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// How a class that takes measures finds the values of one kind of them. `Moment`: what they are taken from.
template <class Taker, class Moment>
struct MeasureRow {
    MeasureKind kind;
    /// One for each of scene::measure_columns; all ranks together.
    std::vector<double> (*values)(const Taker&, const Measure&, const Moment&);
};

/// The row of a kind. A class has one for each kind of its subjects (scene::has_row_for_each); the scene's checks
/// refuse others, so that one without a row throws std::logic_error.
template <class Rows>
constexpr const auto& row_of(const Rows& rows, MeasureKind kind) {
    const auto found = std::ranges::find_if(rows, [&](const auto& row) { return row.kind == kind; });
    if (found == rows.end()) unlisted_value(kind);
    return *found;
}

}  // namespace dmp::solver
