// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/registry.hpp"

namespace dmp::models {

struct HertzContact;
struct JkrContact;
struct RescaledHistory;
struct PlainHistory;
struct NoRolling;
struct ConstantRolling;
struct RollingSpring;
struct NoAdhesion;
struct BradleyAdhesion;
struct DmtAdhesion;

/// The parts of a contact: one law of each registry (contact_pair.normal, .tangential, .rolling, .adhesion). What they
/// compute is in models/dem/contact_laws.hpp.
using NormalLaws = Registry<HertzContact, JkrContact>;
using TangentialLaws = Registry<RescaledHistory, PlainHistory>;
using RollingLaws = Registry<NoRolling, ConstantRolling, RollingSpring>;
using AdhesionLaws = Registry<NoAdhesion, BradleyAdhesion, DmtAdhesion>;

using NormalLaw = Choice<NormalLaws>;
using TangentialLaw = Choice<TangentialLaws>;
using RollingLaw = Choice<RollingLaws>;
using AdhesionLaw = Choice<AdhesionLaws>;

}  // namespace dmp::models
