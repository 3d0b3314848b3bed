// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "particles/particle_set.hpp"

namespace dmp::particles {

/// Writes all of a particle set to one sealed HDF5 file, whole or not at all; docs/files.md names the datasets.
/// `made_from`: lines that say what the particles were made from, kept with them as they are. Throws ResourceError when
/// the file cannot be written, std::invalid_argument for a set that could not be read back.
void write_particles(const std::filesystem::path& file, const ParticleSet& particles,
                     std::span<const std::string> made_from = {});

/// A particle set as it lies in a file, with what the file says it was made from.
struct StoredParticles {
    ParticleSet particles;
    std::vector<std::string> made_from;  ///< none: it does not say
};

/// The particle set back, bit for bit. Throws InputError, with the file's name, when the file is none of particles or
/// damaged (check_seal), and when what it holds is none: arrays of different lengths, a part, bond or hinge that names
/// what is not there, a number that is not finite.
StoredParticles read_particle_file(const std::filesystem::path& file);
/// The same without what they were made from.
ParticleSet read_particles(const std::filesystem::path& file);

}  // namespace dmp::particles
