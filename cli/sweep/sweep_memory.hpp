// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "cli/uses.hpp"
#include "study/points.hpp"
#include "study/study.hpp"

namespace dmp::cli {

/// What runs of a study are expected to take of the memory. A trial says what the first one takes, and runs that have
/// ended what they did take; where particles.spacing varies, others take as much more as they have more particles.
class SweepMemory {
  public:
    /// `program`: of a process that has not made any particles [bytes].
    SweepMemory(const study::Study& study, double program);

    /// Of a trial of a run, which may take less than a whole one: it draws no pictures.
    void take_trial(const study::Point& run, double bytes);
    /// What a run has taken that has got to its end.
    void take_end(const study::Point& run, double bytes);
    /// [bytes]; 0: not known.
    [[nodiscard]] double expected(const study::Point& run) const;

    /// A run that runs [bytes].
    struct Running {
        double expected = 0, now = 0;
    };
    /// Whether there is room for one more run beside those that run, which may still grow. `free`: what is not in use
    /// now [bytes]. A run on its own is always started.
    [[nodiscard]] static bool fits(double expected, double free, const std::vector<Running>& running);

  private:
    /// Volume of a particle [m^d], where it varies; else 1.
    [[nodiscard]] double particle_volume(const study::Point& run) const;

    std::optional<std::size_t> spacing_;  ///< index of the key particles.spacing
    int dimension_;
    double program_;
    double largest_trial_ = 0, largest_end_ = 0;  ///< memory besides the program's times volume of a particle
};

}  // namespace dmp::cli
