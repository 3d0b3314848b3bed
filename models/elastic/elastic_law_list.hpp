// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/registry.hpp"

namespace dmp::models {

struct SaintVenantKirchhoff;
struct NeoHookean;

/// The laws of elastic solids made of cells (part.elastic_law). What they compute is in
/// models/elastic/elastic_laws.hpp.
using ElasticLaws = Registry<SaintVenantKirchhoff, NeoHookean>;
using ElasticLaw = Choice<ElasticLaws>;

}  // namespace dmp::models
