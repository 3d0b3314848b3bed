// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// A shell of a drawn surface under a load, against the beam of the same E I.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::plate_tests {
namespace {

constexpr double length = 2e-2, width = 1e-2, thickness = 1e-3, youngs_modulus = 1e6, load = 2e-5, spacing = 5e-4;

/// Keeps what the first and the last frame say.
class Sag : public FrameSink {
  public:
    void write(const Frame& frame) override {
        const FrameGroup& nodes = required_group(frame, "solid");
        if (frame.time == 0) {
            double moments = 0, moment_at_root = 0;
            for (std::size_t k = 0; k < nodes.size(); ++k) {
                const double x = nodes.position[3 * k];
                moments += x * x * (3 * length - x) / 6;
                moment_at_root += x;
            }
            const double bending_stiffness = youngs_modulus * width * std::pow(thickness, 3) / 12;
            const double of_each = load / static_cast<double>(nodes.size());
            expected = of_each * moments / bending_stiffness;
            // Half of D is the dihedrals', and the clamped edge has none: over half a row of triangles from it the
            // shell bends twice as easily.
            const double row = std::sqrt(std::numbers::sqrt3 / 2) * spacing;
            by_the_clamp = of_each * moment_at_root * length * row / 2 / bending_stiffness;
            return;
        }
        double sum = 0;
        std::size_t count = 0;
        for (std::size_t k = 0; k < nodes.size(); ++k)
            if (nodes.position[3 * k] > length - 1e-5) {
                sum -= nodes.position[3 * k + 2];
                ++count;
            }
        found = sum / static_cast<double>(count);  // both layers: half a thickness above and below
    }
    double expected = 0, by_the_clamp = 0, found = 0;
};

TEST(Plate, SagsAsABeamDoes) {
    Sag sag;
    const RunSummary run = run_case("verification/plate", {}, 0.3, &sag);
    Record record("plate", "20 nodes across", run);
    record.percent("deflection of its free end", sag.found / sag.expected - 1, 0.06);
    record.percent("the same, half a row at the clamp bent by the layers alone",
                   sag.found / (sag.expected + sag.by_the_clamp) - 1, 0.02);
    EXPECT_EQ(run.lost, 0U);
}

}  // namespace
}  // namespace dmp::tests::plate_tests
