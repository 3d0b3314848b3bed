// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "solver/sweeps/pair_sweeps.hpp"

namespace dmp::solver {

/// The sweeps as compiled for one vector unit and one kernel, each pair in a file of its own; only to be called on a
/// processor that has the unit. Unit `generic` is what the compiler takes for granted, on processors that are no x86.
template <VectorUnit unit, KernelKind kernel>
std::unique_ptr<PairSweeps> compiled_sweeps(const PairSettings& settings, int dimension);

}  // namespace dmp::solver
