// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "solver/sweeps/pair_sweeps.hpp"

namespace dmp {

/// The sweeps as compiled for one vector unit each; only to be called on a processor that has it.
std::unique_ptr<PairSweeps> sweeps_for_avx512(const PairSettings& settings, int dimension);
std::unique_ptr<PairSweeps> sweeps_for_avx2(const PairSettings& settings, int dimension);
/// On processors that are no x86: for whatever unit the compiler takes for granted.
std::unique_ptr<PairSweeps> sweeps_for_this_processor(const PairSettings& settings, int dimension);

}  // namespace dmp
