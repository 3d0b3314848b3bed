// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The artery with a stent: the profile in front of it, after a whole period of the box behind it.
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::stent_tests {
namespace {

constexpr double radius = 1.5e-3, first_strut = 16e-3;
constexpr double from_x = first_strut - 4e-3, to_x = first_strut - radius;
constexpr int rings = 10;

/// Velocity along the artery by distance from the axis, and apart for the halves nearer to the y and to the z axis.
/// Means over all frames from a time on.
class Profile : public FrameSink {
  public:
    explicit Profile(double from) : from_(from) {}
    void write(const Frame& frame) override {
        if (frame.time < from_) return;
        const FrameGroup& blood = required_group(frame, "fluid");
        const std::vector<float>& velocity = required_field(blood, "velocity").values;
        for (std::size_t k = 0; k < blood.size(); ++k) {
            const double x = blood.position[3 * k], y = blood.position[3 * k + 1], z = blood.position[3 * k + 2];
            if (x < from_x || x > to_x) continue;
            const double r = std::hypot(y, z) / radius, parabola = 1 - r * r;
            const auto ring = static_cast<std::size_t>(std::min<int>(rings - 1, static_cast<int>(rings * r)));
            Sums& sums = of_.at(std::abs(y) > std::abs(z) ? 0 : 1).at(ring);
            sums.count += 1;
            sums.velocity += velocity[3 * k];
            sums.parabola += parabola;
            fit_ += velocity[3 * k] * parabola;
            norm_ += parabola * parabola;
        }
    }
    /// Of the parabola that fits best.
    [[nodiscard]] double on_the_axis() const { return fit_ / norm_; }
    /// The largest difference of a ring from that parabola, over its height.
    [[nodiscard]] double error() const {
        double largest = 0;
        for (std::size_t ring = 0; ring < rings; ++ring)
            largest = std::max(largest, std::abs(off(of_[0].at(ring) + of_[1].at(ring))));
        return largest;
    }
    /// The largest difference between the two halves of a ring, over the same.
    [[nodiscard]] double asymmetry() const {
        double largest = 0;
        for (std::size_t ring = 0; ring < rings; ++ring)
            largest = std::max(largest, std::abs(off(of_[0].at(ring)) - off(of_[1].at(ring))));
        return largest;
    }

  private:
    struct Sums {
        double count = 0, velocity = 0, parabola = 0;
        friend Sums operator+(const Sums& a, const Sums& b) {
            return {a.count + b.count, a.velocity + b.velocity, a.parabola + b.parabola};
        }
    };
    [[nodiscard]] double off(const Sums& sums) const {
        return (sums.velocity / on_the_axis() - sums.parabola) / sums.count;
    }
    double from_, fit_ = 0, norm_ = 0;
    std::array<std::array<Sums, rings>, 2> of_{};
};

TEST(Stent, ItsProfileIsParabolicAgainInFrontOfIt) {
    constexpr double until = 0.3;
    Profile profile(until - 0.05);
    const RunSummary run = run_case("stent", {}, until, &profile);
    Record record("stent", "a quarter, 20 across", run);
    record.percent("profile in front of it, largest difference of a ring from a parabola", profile.error(), 0.02);
    record.percent("the same beside the y and the z axis, largest difference of a ring", profile.asymmetry(), 0.01);
    record.at_least("speed on the axis in front of it", profile.on_the_axis(), 0.2, "m/s");
    EXPECT_LT(std::abs(run.momentum_residual), 1e-12);
    EXPECT_EQ(run.end.mass, run.start.mass);
    EXPECT_EQ(run.lost, 0U);
}

}  // namespace
}  // namespace dmp::tests::stent_tests
