// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/particle_plan.hpp"

#include <algorithm>

namespace dmp::report {

namespace {

std::size_t ratio_up(std::size_t a, std::size_t b) { return (a + b - 1) / std::max<std::size_t>(b, 1); }

}  // namespace

ParticlePlan plan_particles(const ParticleBytes& all, std::size_t frames_of_run, std::size_t most_frames,
                            std::size_t bytes) {
    const std::size_t most = std::min({frames_of_run, most_frames, most_frames_shown});
    const std::size_t enough = std::min(most, enough_frames_shown);
    const std::size_t frame = all.thinned_frame + all.solid_frame;
    const std::size_t fitting = all.once >= bytes ? 0 : frame == 0 ? most : (bytes - all.once) / frame;
    if (fitting >= enough) return {std::min(fitting, most), 1, 1};
    ParticlePlan plan{enough, 1, 1};
    // A third of the bytes goes to the solids, whole if they need no more.
    plan.every_solid = std::max<std::size_t>(1, ratio_up(enough * all.solid_frame, bytes / 3));
    const std::size_t left = bytes - ratio_up(enough * all.solid_frame, plan.every_solid);
    plan.every = std::max<std::size_t>(1, ratio_up(enough * all.thinned_frame + all.once, left));
    return plan;
}

std::vector<std::size_t> evenly_spaced(std::size_t frames, std::size_t frames_of_run) {
    std::vector<std::size_t> numbers;
    frames = std::min(frames, frames_of_run);
    for (std::size_t k = 0; k < frames; ++k)
        numbers.push_back(frames == 1 ? frames_of_run - 1
                                      : (k * (frames_of_run - 1) + (frames - 1) / 2) / (frames - 1));
    return numbers;
}

}  // namespace dmp::report
