// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// The loops over contacts of spheres for one vector unit, DMP_VECTOR_UNIT its word; see sweeps/compiled_sweeps.cpp for
// what may not be in here.
#include "models/dem/contact_laws.hpp"
#include "solver/spheres/contact_kernel.hpp"

namespace dmp::solver {

namespace {

template <class L, VectorUnit unit, std::size_t... number>
ContactSweep sweep_of(std::size_t wanted, std::index_sequence<number...>) {
    ContactSweep found = nullptr;
    const auto take = [&]<std::size_t n>() {
        if constexpr (contact_model(n).is_consistent())
            if (n == wanted) found = &ContactKernel<L, contact_model(n)>::run;
    };
    (take.template operator()<number>(), ...);
    return found;
}

}  // namespace

template <>
ContactSweep compiled_contact_sweep<VectorUnit::DMP_VECTOR_UNIT>(const ContactModel& model) {
    return sweep_of<Lanes, VectorUnit::DMP_VECTOR_UNIT>(number_of(model), std::make_index_sequence<contact_models>{});
}

}  // namespace dmp::solver
