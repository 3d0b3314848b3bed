// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/hdf5_file.hpp"
#include "particles/particle_set.hpp"

namespace dmp::particles {

/// The cells of elastic solids in a file of a particle set; nothing where there are none.
void write_cells(Hdf5Writer& to, const ParticleSet& set);
void read_cells(const Hdf5Reader& from, ParticleSet& set);

/// What makes the cells of a set ones that nobody can use, or "".
std::string problem_with_cells(const ParticleSet& set);

}  // namespace dmp::particles
