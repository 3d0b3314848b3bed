// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace dmp {

using WallClock = std::chrono::steady_clock;

/// Wall time since start [s].
inline double seconds_since(WallClock::time_point start) {
    return std::chrono::duration<double>(WallClock::now() - start).count();
}

}  // namespace dmp
