// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/stopwatch.hpp"

#include <algorithm>

#include <sys/resource.h>

namespace dmp::mesher {

void Stopwatch::lap(const std::string& stage) {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    const std::clock_t processor = std::clock();
    const double processor_seconds = static_cast<double>(processor - last_processor_) / CLOCKS_PER_SEC;
    last_processor_ = processor;
    auto found = std::ranges::find(cost_.stages, stage, &MeshReport::Stage::name);
    if (found == cost_.stages.end()) found = cost_.stages.insert(found, {stage, 0, 0});
    found->seconds += seconds;
    found->processor_seconds += processor_seconds;
    rusage usage{};
    if (getrusage(RUSAGE_SELF, &usage) == 0) cost_.peak_bytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

MeshReport::Stage MeshReport::Cost::of(const std::string& stage) const {
    const auto found = std::ranges::find(stages, stage, &Stage::name);
    return found == stages.end() ? Stage{stage, 0, 0} : *found;
}

}  // namespace dmp::mesher
