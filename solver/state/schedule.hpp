// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "solver/state/archive.hpp"
#include "solver/state/loaded_groups.hpp"

namespace dmp::solver {

/// The times k * every, k = 0, 1, ..., without drift.
class Schedule {
  public:
    explicit Schedule(double every) : every_(every) {}
    [[nodiscard]] double next() const { return static_cast<double>(count_) * every_; }
    /// Returns true if `time` has reached the next of them (within rounding), and then moves on to the one after it.
    bool due(double time) {
        if (time < next() - 1e-9 * every_) return false;
        ++count_;
        return true;
    }
    /// Leaves out the times up to this one that are not done.
    void skip_until(double time) {
        count_ = std::max(count_, static_cast<std::int64_t>(std::floor(time / every_ + 1e-9)) + 1);
    }
    void archive(Archive& file, const std::string& name) { file(name, count_); }
    /// The same of a schedule that a run may go on with another interval; all that was due at `time` has been done.
    /// Throws InputError for a time that no run has, and a count that is not of that time.
    void archive(Archive& file, const std::string& name, double time) {
        double every = every_;
        file(name + "_every", every);
        archive(file, name);
        if (!file.loading()) return;
        constexpr double most = 1e15;
        if (!(time >= 0 && time < most * every_)) throw unlike_any_run("a time before 0 or beyond any schedule");
        if (every != every_) count_ = static_cast<std::int64_t>(std::floor(time / every_ + 1e-9)) + 1;
        const double left = next() - time;
        if (!(left > -1e-6 * every_ && left < (1 + 1e-6) * every_))
            throw unlike_any_run("frames or measures that are not due next");
    }

  private:
    double every_;
    std::int64_t count_ = 0;
};

}  // namespace dmp::solver
