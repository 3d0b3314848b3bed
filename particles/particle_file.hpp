// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "particles/particle_set.hpp"

namespace dmp {

/// Writes all of a particle set to one sealed HDF5 file, whole or not at all; docs/files.md names the datasets.
/// Throws ResourceError when the file cannot be written, std::invalid_argument for a set that could not be read back.
void write_particles(const std::filesystem::path& file, const ParticleSet& particles);

/// The particle set back, bit for bit. Throws InputError, with the file's name, when the file is none of particles or
/// damaged (check_seal), and when what it holds is none: arrays of different lengths, a part, bond or hinge that names
/// what is not there, a number that is not finite.
ParticleSet read_particles(const std::filesystem::path& file);

}  // namespace dmp
