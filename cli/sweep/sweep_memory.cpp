// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep_memory.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace dmp::cli {

SweepMemory::SweepMemory(const study::Study& study, double program)
    : dimension_(*study.scene.dimension), program_(program) {
    const std::vector<study::VariedKey> keys = study.keys();
    const auto spacing =
        std::ranges::find(keys, "particles.spacing", [](const study::VariedKey& each) { return *each.key; });
    if (spacing != keys.end()) spacing_ = static_cast<std::size_t>(spacing - keys.begin());
}

double SweepMemory::particle_volume(const study::Point& run) const {
    if (!spacing_ || !run.values[*spacing_].quantity) return 1;
    return std::pow(run.values[*spacing_].quantity->si, dimension_);
}

void SweepMemory::take_trial(const study::Point& run, double bytes) {
    largest_trial_ = std::max(largest_trial_, std::max(bytes - program_, 1.0) * particle_volume(run));
}

void SweepMemory::take_end(const study::Point& run, double bytes) {
    largest_end_ = std::max(largest_end_, std::max(bytes - program_, 1.0) * particle_volume(run));
}

double SweepMemory::expected(const study::Point& run) const {
    const double known = largest_end_ > 0 ? largest_end_ : largest_trial_;
    return known > 0 ? program_ + known / particle_volume(run) : 0;
}

bool SweepMemory::fits(double expected, double free, const std::vector<Running>& running) {
    if (running.empty()) return true;
    for (const Running& each : running) free -= std::max(each.expected - each.now, 0.0);
    return expected <= free;
}

}  // namespace dmp::cli
