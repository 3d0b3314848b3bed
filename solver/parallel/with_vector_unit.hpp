// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

#include "solver/parallel/built_vector_units.hpp"
#include "solver/parallel/resources.hpp"

namespace dmp::solver {

/// Returns then.template operator()<unit>() for the vector unit asked for, which is one that this build has loops for.
/// Throws ResourceError as chosen_vector_unit does.
template <class Then>
decltype(auto) with_vector_unit(VectorUnit asked, const Then& then) {
    switch (chosen_vector_unit(asked)) {
        case VectorUnit::avx512:
            if constexpr (built_for_avx512) return then.template operator()<VectorUnit::avx512>();
            break;
        case VectorUnit::avx2:
            if constexpr (built_for_avx2) return then.template operator()<VectorUnit::avx2>();
            break;
        case VectorUnit::generic:
            if constexpr (built_for_generic) return then.template operator()<VectorUnit::generic>();
            break;
        case VectorUnit::widest:
            break;
    }
    throw std::logic_error("a vector unit was chosen that this build has no loops for");
}

}  // namespace dmp::solver
