// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// A shell of a drawn surface under a load, against the beam of the same E I.
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::plate_tests {
namespace {

constexpr double length = 2e-2, width = 1e-2, thickness = 1e-3, youngs_modulus = 1e6, load = 2e-5;

/// Keeps what the first and the last frame say.
class Sag : public FrameSink {
  public:
    void write(const Frame& frame) override {
        const FrameGroup& nodes = required_group(frame, "solid");
        if (frame.time == 0) {
            double moments = 0;
            for (std::size_t k = 0; k < nodes.size(); ++k) {
                const double x = nodes.position[3 * k];
                moments += x * x * (3 * length - x) / 6;
            }
            const double bending_stiffness = youngs_modulus * width * std::pow(thickness, 3) / 12;
            const double of_each = load / static_cast<double>(nodes.size());
            expected = of_each * moments / bending_stiffness;
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
    double expected = 0, found = 0;
};

TEST(Plate, SagsAsABeamDoes) {
    for (const auto& [across, spacing] : {std::pair{"10 nodes across", "1 mm"}, {"20 nodes across", "0.5 mm"}}) {
        Sag sag;
        const RunSummary run =
            run_case("verification/plate", {"particles.spacing=\"" + std::string(spacing) + "\""}, 0.3, &sag);
        Record record("plate", across, run);
        record.percent("deflection of its free end", sag.found / sag.expected - 1, 0.01);
        EXPECT_EQ(run.lost, 0U);
    }
}

}  // namespace
}  // namespace dmp::tests::plate_tests
