// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "bench/start.hpp"

namespace dmp::bench {

/// The start for other programs: a line of JSON (dimension, spacing, box, periodic, liquid, kernel, support in m), then
/// one line a particle, "fixed x y z", in SI with all digits.
std::string particle_text(const Channel& channel, const ParticleSet& set);

}  // namespace dmp::bench
