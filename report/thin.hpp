// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace dmp::report {

/// Values over time [s]; what is not finite is missing.
struct Curve {
    std::vector<double> time, value;
};

/// At most `most` points of a curve (at least 5) that show what all of them would: the first and the last point, and of
/// equal runs of the others the smallest and the largest value and the first missing one, in their order. A curve with
/// no more points than that comes back as it is. Throws std::invalid_argument if the sizes differ or `most` is below 5.
[[nodiscard]] Curve thinned(const Curve& curve, std::size_t most);

}  // namespace dmp::report
