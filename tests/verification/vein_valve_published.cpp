// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The coarse form of cases/vein_valve/published.toml: long leaflets, three velocities and three stiffnesses at 0.56 mm.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::vein_valve_published_tests {
namespace {

constexpr double period = 4;  // of the drive [s]

/// What the second cycle shows.
struct Cycle {
    RunSummary run;
    double total_stress = 0;  ///< largest von Mises stress in the sinuses [Pa]
    double displacement = 0;  ///< of the leaflets, mean over them and the cycle [m]
    double net_volume = 0;    ///< through the inlet [m^3 per m of depth]
};

/// `velocity`: published peak of the inlet [m/s]; `gradient`: amplitude of the drive [Pa/m]; `stiffness`: EI [N m^2].
Cycle second_cycle(double velocity, double gradient, double stiffness) {
    Cycle cycle;
    cycle.run = run_case(
        "vein_valve/published_scene.toml",
        {set_to("particles.spacing", 0.56e-3, "m"), set_to("part.leaflets.bending_stiffness", stiffness, "N*m^2"),
         "flow.pressure_gradient=[\"" + std::to_string(-gradient) + " Pa/m * sin(2*pi*t / 4 s)\", 0]",
         set_to("flow.largest_speed", 1.43 * velocity, "m/s"), set_to("numerics.sound_speed", 42.9 * velocity, "m/s")},
        2 * period);
    const auto of_cycle = [&](const std::string& name) {
        return between(cycle.run.measures, name, period, 2 * period);
    };
    cycle.total_stress = std::max(largest(of_cycle("upper_total_high")), largest(of_cycle("lower_total_high")));
    cycle.displacement = mean(of_cycle("leaflet_displacement_mean"));
    cycle.net_volume = period * mean(of_cycle("inlet_flux"));
    return cycle;
}

TEST(PublishedVeinValve, StressRisesWithVelocityAndStifferLeafletsMoveLess) {
    const std::vector<Cycle> by_velocity{second_cycle(0.03, 32.2, 3e-6), second_cycle(0.07, 74.8, 3e-6),
                                         second_cycle(0.13, 138.6, 3e-6)};
    const Cycle soft = second_cycle(0.07, 74.8, 1.4e-6), stiff = second_cycle(0.07, 74.8, 1.1e-5);

    Record record("vein_valve", "published, long leaflets, 0.56 mm", by_velocity[1].run);
    const auto stress = [&](std::size_t k) { return by_velocity[k].total_stress; };
    record.at_least("total stress in the sinus, 0.07 over 0.03 m/s", stress(1) / stress(0), 1.5);
    record.at_least("the same, 0.13 over 0.07 m/s", stress(2) / stress(1), 1.5);
    record.at_least("mean displacement of the leaflets, k_a = 0.002 over 0.05 J",
                    soft.displacement / stiff.displacement, 1.2);
    double least = std::min(soft.net_volume, stiff.net_volume);
    for (const Cycle& cycle : by_velocity) least = std::min(least, cycle.net_volume);
    record.at_least("least net volume of a cycle", 1e4 * least, 1, "cm^2");
}

}  // namespace
}  // namespace dmp::tests::vein_valve_published_tests
