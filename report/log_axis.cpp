// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/log_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace dmp::report {

namespace {

/// Which ticks stay where there is little room: those of the smallest rank.
struct RankedTick {
    LogTick tick;
    int rank;
};

constexpr std::array<std::pair<int, int>, 3> digits_and_ranks{{{1, 0}, {2, 2}, {5, 1}}};
constexpr int ranks = 3;

/// digit * 10^power with a unit ("": none): in full where that is short.
std::string number_with_unit(int digit, int power, const char* unit) {
    const std::string after = *unit == '\0' ? "" : std::string(" ") + unit;
    if (power >= -2 && power <= 3) return fmt::format("{:g}{}", digit * std::pow(10.0, power), after);
    return fmt::format("{}e{}{}", digit, power, after);
}

std::string below_ten_seconds(int digit, int power) {
    struct Unit {
        int power;
        const char* name;
    };
    for (const Unit unit : {Unit{0, "s"}, Unit{-3, "ms"}, Unit{-6, "us"}, Unit{-9, "ns"}})
        if (power >= unit.power) return number_with_unit(digit, power - unit.power, unit.name);
    return number_with_unit(digit, power, "s");
}

std::vector<RankedTick> ranked_times(double low, double high) {
    constexpr double minute = 60, hour = 3600, day = 86400;
    std::vector<RankedTick> all;
    for (int power = static_cast<int>(std::floor(low)); power < 1; ++power)
        for (const auto& [digit, rank] : digits_and_ranks)
            all.push_back({{power + std::log10(digit), below_ten_seconds(digit, power)}, rank});
    struct Time {
        int count;
        double unit;
        const char* name;
        int rank;
    };
    for (const Time& time : {Time{10, 1, "s", 0}, Time{20, 1, "s", 2}, Time{30, 1, "s", 1}, Time{1, minute, "min", 0},
                             Time{2, minute, "min", 2}, Time{5, minute, "min", 1}, Time{10, minute, "min", 0},
                             Time{20, minute, "min", 2}, Time{30, minute, "min", 1}, Time{1, hour, "h", 0},
                             Time{2, hour, "h", 2}, Time{5, hour, "h", 1}, Time{10, hour, "h", 0}})
        all.push_back({{std::log10(time.count * time.unit), fmt::format("{} {}", time.count, time.name)}, time.rank});
    for (int power = 0; power + std::log10(day) <= high; ++power)
        for (const auto& [digit, rank] : digits_and_ranks)
            all.push_back({{power + std::log10(digit * day), number_with_unit(digit, power, "d")}, rank});
    return all;
}

/// `shift`: powers of ten from the unit to one.
std::vector<RankedTick> ranked_numbers(double low, double high, int shift, const char* unit) {
    std::vector<RankedTick> all;
    for (int power = static_cast<int>(std::floor(low)); power <= high; ++power)
        for (const auto& [digit, rank] : digits_and_ranks)
            all.push_back({{power + std::log10(digit), number_with_unit(digit, power + shift, unit)}, rank});
    return all;
}

/// Those on the axis, of as many ranks as have room there; where not even the first one has, some of it.
std::vector<LogTick> with_room(const std::vector<RankedTick>& all, const LogAxis& axis, double apart) {
    const double begin = std::min(axis.from(), axis.to()), end = std::max(axis.from(), axis.to());
    std::vector<LogTick> chosen;
    for (int most = ranks - 1; most >= 0; --most) {
        chosen.clear();
        bool fits = true;
        for (const auto& [tick, rank] : all) {
            const double at = axis.at_log10(tick.log10);
            if (rank > most || at < begin - 1e-6 || at > end + 1e-6) continue;
            if (!chosen.empty() && std::abs(at - axis.at_log10(chosen.back().log10)) < apart) {
                fits = false;
                if (most == 0) continue;
            }
            chosen.push_back(tick);
        }
        if (fits) break;
    }
    return chosen;
}

}  // namespace

LogAxis::LogAxis(const std::vector<double>& values, double from, double to) : low_(0), high_(0), from_(from), to_(to) {
    constexpr double beyond = 0.12, part_beyond = 0.05;
    if (!values.empty()) {
        const auto [smallest, largest] = std::ranges::minmax(values);
        low_ = std::log10(smallest);
        high_ = std::log10(largest);
    }
    const double span = high_ - low_;
    const double more = std::max({beyond, part_beyond * span, (std::log10(6.0) - span) / 2});
    low_ -= more;
    high_ += more;
}

double LogAxis::at(double value) const { return at_log10(std::log10(value)); }

double LogAxis::at_log10(double log10) const { return from_ + (log10 - low_) / (high_ - low_) * (to_ - from_); }

std::vector<LogTick> LogAxis::times(double apart) const { return with_room(ranked_times(low_, high_), *this, apart); }

std::vector<LogTick> LogAxis::percents(double apart) const {
    return with_room(ranked_numbers(low_, high_, 2, "%"), *this, apart);
}

std::vector<LogTick> LogAxis::numbers(double apart) const {
    return with_room(ranked_numbers(low_, high_, 0, ""), *this, apart);
}

}  // namespace dmp::report
