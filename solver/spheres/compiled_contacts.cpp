// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// The loops over contacts of spheres for one vector unit, DMP_VECTOR_UNIT its word; see sweeps/compiled_sweeps.cpp for
// what may not be in here.
#include "solver/spheres/contact_kernel.hpp"
#include "solver/spheres/contact_models.hpp"

namespace dmp::solver {

namespace {

template <class L, VectorUnit unit, std::size_t... number>
ContactSweep sweep_of(std::size_t wanted, std::index_sequence<number...>) {
    ContactSweep found = nullptr;
    ((number == wanted ? void(found = &ContactKernel<L, contact_model(number)>::run) : void()), ...);
    return found;
}

}  // namespace

template <>
ContactSweep compiled_contact_sweep<VectorUnit::DMP_VECTOR_UNIT>(const ContactModel& model) {
    return sweep_of<Lanes, VectorUnit::DMP_VECTOR_UNIT>(number_of(model), std::make_index_sequence<contact_models>{});
}

}  // namespace dmp::solver
