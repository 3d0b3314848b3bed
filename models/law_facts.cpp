// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// The descriptions of all laws from which scenes choose.
#include "models/dem/contact_laws.hpp"
#include "models/elastic/elastic_laws.hpp"
#include "models/sph/liquid_state.hpp"
#include "models/sph/viscous_laws.hpp"

namespace dmp::models {

template <class... Laws>
const std::array<LawFacts, Registry<Laws...>::size>& Registry<Laws...>::facts() {
    static constexpr std::array<LawFacts, size> all{Laws::facts...};
    return all;
}

// clang-format off
template const std::array<LawFacts, NormalLaws::size>& NormalLaws::facts();
template const std::array<LawFacts, TangentialLaws::size>& TangentialLaws::facts();
template const std::array<LawFacts, RollingLaws::size>& RollingLaws::facts();
template const std::array<LawFacts, AdhesionLaws::size>& AdhesionLaws::facts();
template const std::array<LawFacts, ViscousLaws::size>& ViscousLaws::facts();
template const std::array<LawFacts, EquationsOfState::size>& EquationsOfState::facts();
template const std::array<LawFacts, ElasticLaws::size>& ElasticLaws::facts();
// clang-format on

}  // namespace dmp::models
