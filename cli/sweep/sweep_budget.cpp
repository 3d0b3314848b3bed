// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep_budget.hpp"

#include <algorithm>
#include <utility>

#include "cli/output_folder.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "cli/sweep/sweep_table.hpp"

namespace dmp::cli {

SweepBudget::SweepBudget(std::optional<double> seconds, std::vector<double> costs, const study::Points& points,
                         std::filesystem::path folder, int jobs, int threads)
    : seconds_(seconds), costs_(std::move(costs)), points_(points), folder_(std::move(folder)), threads_(threads) {
    for (const auto& [run, time] : run_times(folder_ / sweep_timing_name))
        spent_ += time.wall_s / std::min<double>(jobs, static_cast<double>(points.size()));
}

double SweepBudget::left() const { return *seconds_ - spent_ - seconds_since(start_); }

bool SweepBudget::may_start(std::size_t index) const {
    if (!seconds_) return true;
    if (left() <= 0) return false;
    const auto time = expected({index});
    if (!time) return true;
    // One that goes on from its checkpoint has that behind it.
    const auto times = run_times(folder_ / sweep_timing_name);
    const auto before = times.find(points_.at(index).name);
    const double done = before == times.end() ? 0 : before->second.processor_s;
    return std::max(0.0, *time - done) / threads_ <= left();
}

WallClock::time_point SweepBudget::end() const {
    constexpr double for_ever = 1e9;  // [s]; a clock's ticks are counted in 64 bits
    if (!seconds_ || *seconds_ > for_ever) return WallClock::time_point::max();
    return start_ + std::chrono::duration_cast<WallClock::duration>(std::chrono::duration<double>(*seconds_ - spent_));
}

std::optional<double> SweepBudget::expected(const std::vector<std::size_t>& runs) const {
    const auto times = run_times(folder_ / sweep_timing_name);
    // The most expensive one that has ended is nearest to those that are to come.
    std::optional<double> of_unit_cost;
    double largest = 0;
    for (std::size_t index = 0; index < costs_.size(); ++index) {
        if (costs_[index] < largest) continue;
        const std::string name = points_.at(index).name;
        const auto time = times.find(name);
        if (time == times.end() || contents_of(run_folder(folder_, name)).kind != FolderContents::Kind::finished)
            continue;
        of_unit_cost = time->second.processor_s / costs_[index];
        largest = costs_[index];
    }
    if (!of_unit_cost) return {};
    double sum = 0;
    for (const std::size_t index : runs) sum += *of_unit_cost * costs_[index];
    return sum;
}

}  // namespace dmp::cli
