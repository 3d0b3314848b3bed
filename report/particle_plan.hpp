// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace dmp::report {

/// What a page would hold of a run's particles.
struct ParticleBytes {
    std::size_t thinned_frame = 0;  ///< of each frame, what may be thinned out: liquid, moving walls, spheres [bytes]
    std::size_t solid_frame = 0;    ///< of each frame, the solids: thin ones fall apart when thinned out [bytes]
    std::size_t once = 0;           ///< walls at rest [bytes]
};

struct ParticlePlan {
    std::size_t frames = 0;       ///< how many to show
    std::size_t every = 1;        ///< every n-th particle of what may be thinned out, walls at rest included
    std::size_t every_solid = 1;  ///< of the solids
};

/// Frames that are shown at most, and those for which rather particles are thinned out than fewer frames shown.
inline constexpr std::size_t most_frames_shown = 200, enough_frames_shown = 30;

/// As many frames and particles as `bytes` hold: first fewer frames, then fewer particles, the solids last. Of
/// `frames_of_run` frames at most `most_frames` are read.
[[nodiscard]] ParticlePlan plan_particles(const ParticleBytes& all, std::size_t frames_of_run, std::size_t most_frames,
                                          std::size_t bytes);

/// So many of `frames_of_run` frames, evenly spaced, with the first and the last.
[[nodiscard]] std::vector<std::size_t> evenly_spaced(std::size_t frames, std::size_t frames_of_run);

}  // namespace dmp::report
