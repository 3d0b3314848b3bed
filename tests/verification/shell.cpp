// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Diffusion from an elastic disc, at whose surface the concentration is held, to a circle around it (Crank 1975,
// section 5.2.1).
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::shell_tests {
namespace {

constexpr double inner = 5e-3, outer = 15e-3, diffusivity = 6e-6, held = 1e-3;

/// Largest difference of a frame's concentrations from c1 ln(r / b) / ln(a / b), over c1.
double largest_error(const Frame& frame) {
    const FrameGroup& fluid = required_group(frame, "fluid");
    const std::vector<float>& found = required_field(fluid, "concentration").values;
    double largest = 0;
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double r = std::hypot(fluid.position[3 * k], fluid.position[3 * k + 1]);
        largest = std::max(largest, std::abs(found[k] / held - std::log(r / outer) / std::log(inner / outer)));
    }
    return largest;
}

struct Shell {
    std::string name;
    std::vector<std::string> settings;
    double profile, flux;  ///< bounds of the errors
};

class Disc : public testing::TestWithParam<Shell> {};

TEST_P(Disc, InAShell) {
    const Shell& shell = GetParam();
    LastFrame last;
    const RunSummary run = run_case("verification/shell", shell.settings, 16, &last);
    const double flux = 2 * std::numbers::pi * diffusivity * held / std::log(outer / inner);
    Record record("shell", shell.name, run);
    record.at_most("concentration, largest error, over that of the disc", largest_error(last.frame), shell.profile);
    record.percent("flux out of the disc", -column(run.measures, "into_rod").back() / flux - 1, shell.flux);
    record.percent("flux into the tube", column(run.measures, "into_tube").back() / flux - 1, shell.flux);
    record.at_most("amount that came from nowhere, over the amount", run.species.at(0).residual(), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Species, Disc,
                         testing::Values(Shell{"disc 10 across", {"particles.spacing=1 mm"}, 0.032, 0.021},
                                         Shell{"disc 20 across", {}, 0.022, 0.01}));

}  // namespace
}  // namespace dmp::tests::shell_tests
