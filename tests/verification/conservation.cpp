// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What a closed system must keep: mass and momentum to round-off, energy to the order of the time integration.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::conservation_tests {
namespace {

TEST(Conservation, OfMassAndMomentumInAPeriodicFlow) {
    const RunSummary run =
        run_case("verification/taylor_green", {"particles.spacing=0.02 m", "particles.disorder=0.2"}, 1);
    const double drift =
        std::hypot(run.end.momentum[0] - run.start.momentum[0], run.end.momentum[1] - run.start.momentum[1]);
    Record record("taylor_green", "50 x 50, conservation", run);
    record.at_most("change of the mass, over the mass", (run.end.mass - run.start.mass) / run.start.mass, 0);
    record.at_most("change of the momentum in 1 s, over mass times U", drift / run.start.mass, 1e-13);
}

/// Adds to the kinetic energy what is stored in the fluid: per mass, the integral of p / rho^2 of Tait's equation.
class TotalEnergy : public FrameSink {
  public:
    explicit TotalEnergy(double sound_speed) : sound_speed_(sound_speed) {}
    void write(const Frame& frame) override {
        const FrameGroup& fluid = required_group(frame, "fluid");
        const std::vector<float>& velocity = required_field(fluid, "velocity").values;
        const std::vector<float>& pressure = required_field(fluid, "pressure").values;
        const double stiffness = sound_speed_ * sound_speed_ / 7;  // rho0 = 1
        double sum = 0;
        for (std::size_t k = 0; k < fluid.size(); ++k) {
            const double density = std::pow(1 + pressure[k] / stiffness, 1.0 / 7);
            const double stored = stiffness * (std::pow(density, 6) / 6 + 1 / density - 7.0 / 6);
            sum += 0.5 * (std::pow(velocity[3 * k], 2) + std::pow(velocity[3 * k + 1], 2)) + stored;
        }
        values.push_back(sum / static_cast<double>(fluid.size()));
    }
    std::vector<double> values;  ///< of each frame, per mass [J/kg]

  private:
    double sound_speed_;
};

/// Change of the energy of the vortices without viscosity, diffusion and shifting, which alone may take some away.
std::pair<RunSummary, double> energy_change(const std::string& step_factor) {
    TotalEnergy energy(10);
    const RunSummary run =
        run_case("verification/taylor_green",
                 {"numerics.scheme=plain", "particles.spacing=0.02 m", "part.water.viscosity=0 Pa*s",
                  "numerics.shifting=0", "numerics.density_diffusion=0", "numerics.step_factor=" + step_factor,
                  "flow.initial_pressure=0", "output.every=0.1 s", "output.measure_every=0.1 s"},
                 0.1, &energy);
    return {run, energy.values.back() / energy.values.front() - 1};
}

TEST(Conservation, OfEnergyToTheOrderOfTheIntegrator) {
    const double coarse = std::abs(energy_change("0.4").second);
    const auto [run, change] = energy_change("0.2");
    Record record("taylor_green", "50 x 50, no viscosity, diffusion or shifting", run);
    // Pressures are of the middle of a step and density rates of positions half a step old
    // (solver/time/fluid_step.hpp), which is first order.
    record.at_least("order at which the change of energy falls with the step", std::log2(coarse / std::abs(change)),
                    0.9);
    record.at_most("change of the energy in 0.1 s, step factor 0.2", change, 0.005);
}

}  // namespace
}  // namespace dmp::tests::conservation_tests
