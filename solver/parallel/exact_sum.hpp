// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
namespace dmp {
class ExactSum {
  public:
    void add(double x) { s_ += x; }
    void add(const ExactSum& b) { s_ += b.s_; }
    [[nodiscard]] double value() const { return static_cast<double>(s_); }

  private:
    long double s_ = 0;
};
}  // namespace dmp
