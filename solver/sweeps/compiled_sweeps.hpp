// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "solver/sweeps/pair_sweeps.hpp"

namespace dmp::solver {

/// The sweeps compiled for one vector unit and one kernel, each combination in its own file. Call only on a processor
/// that has the unit. The unit `generic` is the compiler's default, for processors other than x86.
template <VectorUnit unit, KernelKind kernel>
std::unique_ptr<PairSweeps> compiled_sweeps(const PairSettings& settings, int dimension);

}  // namespace dmp::solver
