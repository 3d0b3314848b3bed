// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "base/enum_names.hpp"
#include "solver/parallel/ranks.hpp"

namespace dmp::solver {

/// The processor's vector instructions that the loops over pairs use. Results do not depend on it.
enum class VectorUnit { widest, avx2, avx512, generic };

/// Those that this processor has, narrowest first. Throws ResourceError when there are none.
std::vector<VectorUnit> available_vector_units();
/// `asked`, or the widest there is. Throws ResourceError when the processor lacks it.
VectorUnit chosen_vector_unit(VectorUnit asked);

/// What a run may use. Results do not depend on it.
struct Resources {
    // NOLINTNEXTLINE(google-explicit-constructor): most only say how many threads
    Resources(int threads_of_a_rank = 0) : threads(threads_of_a_rank) {}

    int threads;  ///< of each rank; 0: all the machine has
    VectorUnit vector_unit = VectorUnit::widest;
    Ranks ranks = Ranks::alone();
};

}  // namespace dmp::solver

namespace dmp {

template <>
inline constexpr auto enum_names<solver::VectorUnit> = std::to_array<std::string_view>({"widest", "avx2", "avx512",
                                                                                        "generic"});

}  // namespace dmp
