// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace dmp::solver {

/// Wall time by stage of the step. What a stage inside another takes is not counted for the other too.
class StageTimer {
  public:
    template <class Work>
    auto timed(const char* stage, Work&& work) {
        const Lap lap(seconds_[stage], innermost_);
        return work();
    }
    [[nodiscard]] const std::map<std::string, double>& seconds() const { return seconds_; }

  private:
    using Clock = std::chrono::steady_clock;
    struct Lap {
        Lap(double& total_seconds, Lap*& innermost) : total(total_seconds), current(&innermost), around(innermost) {
            *current = this;
        }
        ~Lap() {
            const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
            total += seconds - inside;
            if (around != nullptr) around->inside += seconds;
            *current = around;
        }
        Lap(const Lap&) = delete;
        Lap& operator=(const Lap&) = delete;
        double& total;
        Lap** current;  ///< where the innermost stage is noted
        Lap* around;
        double inside = 0;  ///< seconds of other stages within this one
        Clock::time_point start = Clock::now();
    };
    std::map<std::string, double> seconds_;
    Lap* innermost_ = nullptr;
};

}  // namespace dmp::solver
