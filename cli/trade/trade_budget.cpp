// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trade/trade_budget.hpp"

#include <algorithm>
#include <utility>

#include "cli/output_folder.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "cli/sweep/sweep_table.hpp"

namespace dmp::cli {

TradeBudget::TradeBudget(std::optional<double> seconds, const study::TradeSettings& settings,
                         const study::Points& points, std::filesystem::path folder, int jobs, int threads)
    : seconds_(seconds), settings_(settings), points_(points), folder_(std::move(folder)), threads_(threads) {
    for (const auto& [run, time] : run_times(folder_ / sweep_timing_name))
        spent_ += time.wall_s / std::min<double>(jobs, static_cast<double>(points.size()));
}

double TradeBudget::left() const { return *seconds_ - spent_ - seconds_since(start_); }

bool TradeBudget::may_start(std::size_t index) const {
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

WallClock::time_point TradeBudget::end() const {
    constexpr double for_ever = 1e9;  // [s]; a clock's ticks are counted in 64 bits
    if (!seconds_ || *seconds_ > for_ever) return WallClock::time_point::max();
    return start_ + std::chrono::duration_cast<WallClock::duration>(std::chrono::duration<double>(*seconds_ - spent_));
}

std::optional<double> TradeBudget::expected(const std::vector<std::size_t>& settings) const {
    const auto times = run_times(folder_ / sweep_timing_name);
    // The most expensive one that has ended is nearest to those that are to come.
    std::optional<double> of_unit_cost;
    for (std::size_t index = 0; index < settings_.settings.size(); ++index) {
        const std::string name = points_.at(index).name;
        const auto time = times.find(name);
        if (time != times.end() && contents_of(run_folder(folder_, name)).kind == FolderContents::Kind::finished)
            of_unit_cost = time->second.processor_s / settings_.settings[index].cost;
    }
    if (!of_unit_cost) return {};
    double sum = 0;
    for (const std::size_t index : settings) sum += *of_unit_cost * settings_.settings[index].cost;
    return sum;
}

}  // namespace dmp::cli
