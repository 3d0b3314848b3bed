// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/shown_particles.hpp"

namespace dmp::report {

/// JSON that particles.js draws; no "<" in it. Lengths in m, times in s, arrays of numbers in base64, low bytes first:
///
///     {"flat", "low": [x, y, z], "high": [], "time": [], "sequential": colours, "diverging": colours, "nan": colour,
///      "groups": [{"name", "every", "radius", "largest", "triangles": 32 bits,
///                  "fields": [{"name", "unit", "low", "high", "diverging"}],
///                  "at": [{"place": 16 bits, "radius": 16 bits, "values": [8 bits]}]}]}
///
/// A place has two axes where the particles are flat, else three, from low to high; a radius goes from 0 to "largest".
/// A value is the number of its colour; colours are red, green, blue, 8 bits each. Groups are in the order in which
/// those of a flat scene cover each other.
[[nodiscard]] std::string particle_data(const ShownParticles& particles);

}  // namespace dmp::report
