// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace dmp::report {

/// A number at an axis: its decimal logarithm, which holds for numbers that a double does not, and what stands there.
struct LogTick {
    double log10 = 0;
    std::string text;
};

/// A logarithmic axis in a picture.
class LogAxis {
  public:
    /// From the smallest to the largest of `values`, which are above 0 and finite, with some room beyond both, and at
    /// least a factor of six in all. `from`, `to`: its ends in the picture [px]. Without values: about 1.
    LogAxis(const std::vector<double>& values, double from, double to);

    /// Where a value is [px].
    [[nodiscard]] double at(double value) const;
    [[nodiscard]] double at_log10(double log10) const;
    [[nodiscard]] double from() const { return from_; }
    [[nodiscard]] double to() const { return to_; }

    /// Times [s], round in the unit that suits them ("500 ms", "10 s", "5 min", "1 h"), at least `apart` [px] from
    /// each other.
    [[nodiscard]] std::vector<LogTick> times(double apart) const;
    /// Parts of one as "1 %", "2 %", "5 %", likewise.
    [[nodiscard]] std::vector<LogTick> percents(double apart) const;
    /// Plain numbers, "0.5", "1", "20", likewise.
    [[nodiscard]] std::vector<LogTick> numbers(double apart) const;

  private:
    double low_, high_;  ///< logarithms
    double from_, to_;
};

}  // namespace dmp::report
