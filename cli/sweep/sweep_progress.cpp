// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep_progress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "cli/text.hpp"

namespace dmp::cli {

double seconds_left(double mean, const std::vector<double>& running, std::size_t waiting, int jobs) {
    if (!(mean > 0)) return std::numeric_limits<double>::infinity();
    double work = mean * static_cast<double>(waiting);
    for (const double done : running) work += std::max(mean - done, 0.0);
    const std::size_t at_a_time = std::min(static_cast<std::size_t>(jobs), waiting + running.size());
    return work / static_cast<double>(std::max<std::size_t>(at_a_time, 1));
}

std::string progress_text(const SweepCounts& counts, double seconds_left) {
    const std::size_t ended = counts.done + counts.failed;
    std::string text =
        fmt::format("{:3} %  {} of {} done, {} running", counts.runs == 0 ? 100 : 100 * ended / counts.runs,
                    count_text(counts.done), count_text(counts.runs), count_text(counts.running));
    if (counts.failed > 0) text += ", " + count_text(counts.failed) + " failed";
    // None are left, by this estimate, where all that run have taken longer than the others.
    if (std::isfinite(seconds_left) && seconds_left > 0) text += "  " + duration_text(seconds_left) + " left";
    return text;
}

bool LineEvery::is_due(double wall) {
    if (wall < next_) return false;
    next_ = seconds * (std::floor(wall / seconds) + 1);
    return true;
}

}  // namespace dmp::cli
