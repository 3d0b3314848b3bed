// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

namespace dmp::models {

/// A time window, used once or repeated every period.
struct ScheduleWindow {
    double from = 0;                                         ///< [s]
    double until = std::numeric_limits<double>::infinity();  ///< [s]
    double period = 0;                                       ///< [s]; 0: once

    [[nodiscard]] bool acts(double t) const { return t >= from && t < end(cycle_of(t)); }
    /// The next time after t at which the window starts or ends; infinity if there is none.
    [[nodiscard]] double next_change(double t) const {
        if (t < from) return from;
        const double cycle = cycle_of(t);
        if (t < end(cycle)) return end(cycle);
        return period > 0 ? start(cycle + 1) : std::numeric_limits<double>::infinity();
    }

  private:
    [[nodiscard]] double start(double cycle) const { return from + cycle * period; }
    [[nodiscard]] double end(double cycle) const { return start(cycle) + (until - from); }
    /// The number of the cycle that contains t, counted from 0; t >= `from`.
    [[nodiscard]] double cycle_of(double t) const {
        if (period == 0) return 0;
        double cycle = std::floor((t - from) / period);
        while (start(cycle + 1) <= t) ++cycle;  // the quotient is rounded
        while (start(cycle) > t) --cycle;
        return cycle;
    }
};

}  // namespace dmp::models
