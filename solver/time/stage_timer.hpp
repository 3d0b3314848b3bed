// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace dmp {

/// Wall time by stage of the step.
class StageTimer {
  public:
    template <class Work>
    auto timed(const char* stage, Work&& work) {
        const Lap lap(seconds_[stage]);
        return work();
    }
    [[nodiscard]] const std::map<std::string, double>& seconds() const { return seconds_; }

  private:
    using Clock = std::chrono::steady_clock;
    struct Lap {
        explicit Lap(double& total_seconds) : total(total_seconds) {}
        ~Lap() { total += std::chrono::duration<double>(Clock::now() - start).count(); }
        Lap(const Lap&) = delete;
        Lap& operator=(const Lap&) = delete;
        double& total;
        Clock::time_point start = Clock::now();
    };
    std::map<std::string, double> seconds_;
};

}  // namespace dmp
