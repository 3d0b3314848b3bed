// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "base/enum_names.hpp"
#include "solver/parallel/ranks.hpp"

namespace dmp::solver {

/// Vector instructions used by the loops over pairs. Results do not depend on the choice.
enum class VectorUnit { widest, avx2, avx512, generic };

/// The vector units of this processor, narrowest first. Throws ResourceError if there are none.
std::vector<VectorUnit> available_vector_units();
/// Returns `asked`, or the widest available. Throws ResourceError if the processor does not have it.
VectorUnit chosen_vector_unit(VectorUnit asked);

/// Computing resources of a run. Results do not depend on them.
struct Resources {
    // NOLINTNEXTLINE(google-explicit-constructor): most callers give the number of threads only
    Resources(int threads_of_a_rank = 0) : threads(threads_of_a_rank) {}

    int threads;  ///< per rank; 0: all of the machine
    VectorUnit vector_unit = VectorUnit::widest;
    Ranks ranks = Ranks::alone();
};

}  // namespace dmp::solver

namespace dmp {

template <>
inline constexpr auto enum_names<solver::VectorUnit> = std::to_array<std::string_view>({"widest", "avx2", "avx512",
                                                                                        "generic"});

}  // namespace dmp
