// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/elastic/elastic_law_list.hpp"
#include "models/elastic/neo_hookean.hpp"
#include "models/elastic/saint_venant_kirchhoff.hpp"

namespace dmp::models {

/// Returns use(law), compiled for every law of elastic solids. A law has `facts`, is made from LameConstants, and has
/// for C = F^T F in D dimensions `energy<D>(c)` per volume at rest [J/m^3], `stress<D>(c)`, the second Piola-Kirchhoff
/// stress S [Pa], in 2-D `stress_across(c)`, and `tangent<D>(c)`, the positive part of dS/dE [Pa]. For small strains
/// all are Hooke's law, whose moduli bending within a cell has (ElasticCell).
template <class Use>
auto with_elastic_law(ElasticLaw choice, const LameConstants& constants, const Use& use) {
    return choice.visit([&]<class Law>() { return use(Law{constants}); });
}

}  // namespace dmp::models
