// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/choices.hpp"

namespace dmp::scene {

/// The words a scene uses for the values of an enumeration, in the order they are listed to the user.
template <class Enumeration>
using Words = std::vector<std::pair<Enumeration, std::string>>;

/// Specialised for each enumeration of choices.hpp.
template <class Enumeration>
const Words<Enumeration>& words_of();

template <>
const Words<Quality>& words_of();
template <>
const Words<PartKind>& words_of();
template <>
const Words<ContactLawKind>& words_of();
template <>
const Words<AdhesionKind>& words_of();
template <>
const Words<RollingKind>& words_of();
template <>
const Words<ForceAmount>& words_of();
template <>
const Words<ShapeKind>& words_of();
template <>
const Words<PushedSide>& words_of();
template <>
const Words<Arrangement>& words_of();
template <>
const Words<RepairKind>& words_of();
template <>
const Words<FillKind>& words_of();
template <>
const Words<KernelKind>& words_of();
template <>
const Words<WallModel>& words_of();
template <>
const Words<EquationOfState>& words_of();
template <>
const Words<DensityModel>& words_of();
template <>
const Words<ViscousLaw>& words_of();
template <>
const Words<ViscosityMean>& words_of();
template <>
const Words<SpringStepping>& words_of();
template <>
const Words<ViscosityStepping>& words_of();
template <>
const Words<SpeciesStepping>& words_of();
template <>
const Words<SpeciesUnit>& words_of();
template <>
const Words<Axis>& words_of();
template <>
const Words<MeasureKind>& words_of();
template <>
const Words<SolidifyRule>& words_of();
template <>
const Words<SeedActivity>& words_of();
template <>
const Words<BondTo>& words_of();
template <>
const Words<FluidField>& words_of();
template <>
const Words<SolidField>& words_of();

}  // namespace dmp::scene
