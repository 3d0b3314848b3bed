// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parallel/resources.hpp"

#include <algorithm>
#include <string>

#include "base/errors.hpp"
#include "solver/parallel/built_vector_units.hpp"

namespace dmp::solver {

std::vector<VectorUnit> available_vector_units() {
    std::vector<VectorUnit> units;
#if defined(__x86_64__)
    const bool avx2 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
    if (!avx2)
        throw ResourceError("this processor has no AVX2 and FMA instructions, which dmp is built with",
                            "use a processor of 2013 or later (Intel Haswell, AMD Excavator)");
    const bool avx512 = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
                        __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
                        __builtin_cpu_supports("avx512cd") != 0;
    if (built_for_avx2) units.push_back(VectorUnit::avx2);
    if (built_for_avx512 && avx512) units.push_back(VectorUnit::avx512);
    if (units.empty())
        throw ResourceError("this processor has no AVX-512 instructions, for which alone dmp was built",
                            "build dmp on this machine, or with -DDMP_PORTABLE=ON for all processors");
#else
    units.push_back(VectorUnit::generic);
#endif
    return units;
}

VectorUnit chosen_vector_unit(VectorUnit asked) {
    const std::vector<VectorUnit> units = available_vector_units();
    if (asked == VectorUnit::widest) return units.back();
    if (std::find(units.begin(), units.end(), asked) == units.end())
        throw ResourceError(
            "this processor has no " + std::string(to_string(asked)) + " instructions, or dmp was built without them",
            "leave the vector unit out: dmp then uses the widest one available; -DDMP_PORTABLE=ON builds "
            "for all of them");
    return asked;
}

}  // namespace dmp::solver
