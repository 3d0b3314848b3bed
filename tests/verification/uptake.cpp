// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Diffusion with first-order uptake in a slab against Thiele's closed form (1939), and how it gets there.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::uptake_tests {
namespace {

constexpr double half = 1e-4, length = 8e-5, diffusivity = 2e-9, supplied = 0.2;

/// Of the steady state, over the concentration of the faces; xi = y / L.
double steady(double xi, double phi) { return std::cosh(phi * xi) / std::cosh(phi); }

/// From an even start, at tau = D t / L^2: what is left of it above the steady state has decayed in each of its terms.
double on_its_way(double xi, double phi, double tau) {
    double c = steady(xi, phi);
    for (int n = 0; n < 100; ++n) {
        const double a = (n + 0.5) * std::numbers::pi, rate = phi * phi + a * a;
        c += 2 * std::sin(a) * phi * phi / (a * rate) * std::cos(a * xi) * std::exp(-rate * tau);
    }
    return c;
}

/// Largest difference of a frame's concentrations from c(xi), over the concentration of the faces.
template <class Exact>
double largest_error(const Frame& frame, const Exact& exact) {
    const FrameGroup& fluid = required_group(frame, "fluid");
    const std::vector<float>& found = required_field(fluid, "concentration").values;
    double largest = 0;
    for (std::size_t k = 0; k < fluid.size(); ++k)
        largest = std::max(largest, std::abs(found[k] / supplied - exact(fluid.position[3 * k + 1] / half)));
    return largest;
}

struct Slab {
    std::string name;
    double phi;
    std::vector<std::string> settings;
    double profile, effectiveness, start;  ///< bounds of the errors
};

class Thiele : public testing::TestWithParam<Slab> {};

TEST_P(Thiele, InASlab) {
    const Slab& slab = GetParam();
    const double phi = slab.phi, rate = phi * phi * diffusivity / (half * half);
    std::vector<std::string> overrides = slab.settings;
    overrides.push_back("species.oxygen.uptake=" + quantity(rate, "1/s"));
    LastFrame early, last;
    const double tau = 0.1;
    (void)run_case("verification/uptake", overrides, tau * half * half / diffusivity, &early);
    const RunSummary run = run_case("verification/uptake", overrides, 20, &last);
    Record record("uptake", slab.name, run);
    record.at_most("concentration at D t / L^2 = 0.1, largest error, over that of the faces",
                   largest_error(early.frame, [=](double xi) { return on_its_way(xi, phi, tau); }), slab.start);
    record.at_most("steady concentration, largest error, over that of the faces",
                   largest_error(last.frame, [=](double xi) { return steady(xi, phi); }), slab.profile);
    const double effectiveness = column(run.measures, "uptake").back() / (rate * supplied * 2 * half * length);
    record.percent("effectiveness, tanh(phi) / phi", effectiveness * phi / std::tanh(phi) - 1, slab.effectiveness);
    record.at_most("amount that came from nowhere, over what was taken up", run.species.at(0).residual(), 1e-13);
}

const std::string fine = "particles.spacing=5 um";
const std::vector<std::string> implicitly{"numerics.species_stepping=implicit", "numerics.viscosity_stepping=implicit"};

INSTANTIATE_TEST_SUITE_P(Species, Thiele,
                         testing::Values(Slab{"Thiele modulus 0.5, 20 across", 0.5, {}, 0.001, 0.001, 0.002},
                                         Slab{"Thiele modulus 2, 20 across", 2, {}, 0.0075, 0.009, 0.0075},
                                         Slab{"Thiele modulus 5, 20 across", 5, {}, 0.033, 0.041, 0.033},
                                         Slab{"Thiele modulus 5, 40 across", 5, {fine}, 0.011, 0.013, 0.011},
                                         Slab{"Thiele modulus 2, 20 across, implicit", 2, implicitly, 0.0075, 0.009,
                                              0.02}));

TEST(Uptake, OfAnEvenConcentration) {
    LastFrame last;
    const RunSummary run = run_case("verification/uptake", {"species.oxygen.wall_concentration={}"}, 5, &last);
    Record record("uptake", "faces closed", run);
    record.at_most("concentration after 5 s over exp(-k t), less 1",
                   largest_error(last.frame, [](double) { return std::exp(-0.8 * 5); }) / std::exp(-0.8 * 5), 1e-6);
    record.at_most("amount that came from nowhere, over the amount", run.species.at(0).residual(), 0);
}

}  // namespace
}  // namespace dmp::tests::uptake_tests
