// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/dem/contact_constants.hpp"
#include "models/registry.hpp"

namespace dmp::models {

/// Surfaces that do not attract each other.
struct NoAdhesion {
    static constexpr LawFacts facts{"none", "", "none"};
    static constexpr bool adhesive = false, has_range = false;

    static double reach(double /*radius*/, const ContactConstants<>& /*pair*/) { return 0; }
    static double stiffness(double /*radius*/, const ContactConstants<>& /*pair*/) { return 0; }
};

}  // namespace dmp::models
