// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/dem/contact_laws.hpp"

namespace dmp::models {

/// Largest attraction of two bodies of this effective radius [N]: the pull-off force of the model's adhesive law, 0 if
/// it has none.
inline double largest_attraction(const ContactModel& model, double radius, const ContactConstants<>& pair) {
    return visit_adhesive_law(model.normal, model.adhesion, 0.0,
                              [&]<class Law>() -> double { return Law::pull_off(radius, pair); });
}

}  // namespace dmp::models
