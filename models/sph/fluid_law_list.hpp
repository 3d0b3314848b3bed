// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/registry.hpp"

namespace dmp::models {

struct MorrisViscosity;
struct MonaghanViscosity;
struct ApproachingMonaghanViscosity;
struct ClearyViscosity;
struct NewtonianViscosity;

/// The viscous laws (numerics.viscous_law). What they compute, and what a law must have, is in
/// models/sph/viscous_laws.hpp.
using ViscousLaws =
    Registry<MorrisViscosity, MonaghanViscosity, ApproachingMonaghanViscosity, ClearyViscosity, NewtonianViscosity>;
using ViscousLaw = Choice<ViscousLaws>;

struct TaitEquation;
struct LinearEquation;

/// The equations of state (numerics.equation_of_state): models/sph/liquid_state.hpp.
using EquationsOfState = Registry<TaitEquation, LinearEquation>;
using EquationOfState = Choice<EquationsOfState>;

}  // namespace dmp::models
