// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "solver/state/archive.hpp"

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
    void archive(Archive& file, const std::string& name) { file(name, count_); }

  private:
    double every_;
    std::int64_t count_ = 0;
};

}  // namespace dmp::solver
