// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "solver/sweeps/pair_sweeps.hpp"

namespace dmp::solver {

/// Kernels that have loops of their own, and those of all others (AnyKernel): a copy for each kernel took most of the
/// time of a build.
enum class KernelLoops { wendland_c2, any };

/// The sweeps compiled for one vector unit and some kernels, each combination in its own file. Call only on a processor
/// that has the unit. The unit `generic` is the compiler's default, for processors other than x86.
template <VectorUnit unit, KernelLoops loops>
std::unique_ptr<PairSweeps> compiled_sweeps(const PairSettings& settings, int dimension);

}  // namespace dmp::solver
