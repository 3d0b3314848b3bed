// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/shown_particles.hpp"

namespace dmp::report {

/// Leaves out particles without a finite place, and those so far from all others that these could not be told from each
/// other: along an axis, farther outside what holds all but a thousandth on each side than that is wide. A note says
/// how many. Of surfaces nothing is left out.
void leave_out_far(ShownParticles& particles);

}  // namespace dmp::report
