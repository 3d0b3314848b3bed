// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run_files.hpp"

namespace dmp::report {

/// The section of the particles, which particles.js fills.
[[nodiscard]] std::string particle_section(const RunFiles& run);

/// Bytes that particles may take in the page of this run, before they are put in base64: what its pictures, plots and
/// scripts leave of `most_page_bytes`, at most `most_particle_bytes`, and some in any case.
[[nodiscard]] std::size_t bytes_for_particles(const RunFiles& run);

inline constexpr std::size_t most_page_bytes = 4'900'000, most_particle_bytes = 2'250'000,
                             least_particle_bytes = 450'000;

}  // namespace dmp::report
