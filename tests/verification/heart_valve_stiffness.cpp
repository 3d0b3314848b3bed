// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The coarse form of cases/heart_valve/stiffness.toml: one beat of soft, intermediate and hard leaflets at 1 mm.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::heart_valve_stiffness_tests {
namespace {

constexpr double half_width = 12.5e-3;        // of the vessel [m]
constexpr double root_to_tip = 12.0727e-3;    // along the vessel, of straight leaflets [m]
constexpr double beat = 1, end = 1.2 * beat;  // backflow goes on into the next beat [s]

struct Beat {
    RunSummary run;
    double widest_gap = 0;  ///< [m]
    double upstream = 0;    ///< how far both tips are upstream of their roots at once, most [m]; negative: downstream
    double asymmetry = 0;   ///< largest |y + y| of the two tips in the forward flow, over the half width
};

/// `stiffness`: EI [N m^2]; `gradient`: amplitude of the drive [Pa/m].
Beat beat_of(double stiffness, double axial_stiffness, double gradient) {
    Beat found;
    found.run =
        run_case("heart_valve/stiffness_scene.toml",
                 {set_to("particles.spacing", 1e-3, "m"), set_to("part.leaflets.bending_stiffness", stiffness, "N*m^2"),
                  set_to("part.leaflets.axial_stiffness", axial_stiffness, "N"),
                  "flow.pressure_gradient=[\"" + std::to_string(-gradient) + " Pa/m * sin(2*pi*t / 1 s)\", 0]"},
                 end);
    const MeasureSeries& series = found.run.measures;
    const auto gap = column(series, "tip_gap"), upper = column(series, "upper_tip_x"),
               lower = column(series, "lower_tip_x");
    const auto upper_y = column(series, "upper_tip_y"), lower_y = column(series, "lower_tip_y");
    found.widest_gap = largest(gap);
    found.upstream = -2 * root_to_tip;
    for (std::size_t k = 0; k < series.time.size(); ++k) {
        if (series.time[k] > 0.5 * beat)
            found.upstream = std::max(found.upstream, -std::max(upper[k], lower[k]) - root_to_tip);
        if (series.time[k] < 0.5 * beat)
            found.asymmetry = std::max(found.asymmetry, std::abs(upper_y[k] + lower_y[k]) / half_width);
    }
    return found;
}

TEST(LeafletsOfHeartValve, AreTurnedInsideOutOrHalfOpenByStiffness) {
    const Beat soft = beat_of(9.8e-6, 310, 2850), intermediate = beat_of(4.4e-5, 1400, 2800),
               hard = beat_of(3.0e-4, 9600, 3000);
    Record record("heart_valve", "published stiffnesses, 1 mm", intermediate.run);
    record.at_least("widest gap, soft less intermediate leaflets", 1e3 * (soft.widest_gap - intermediate.widest_gap),
                    0.5, "mm");
    record.at_least("widest gap, intermediate less hard leaflets", 1e3 * (intermediate.widest_gap - hard.widest_gap), 4,
                    "mm");
    record.at_most("widest gap of hard leaflets, of 25 mm", 1e3 * hard.widest_gap, 15, "mm");
    record.at_least("soft: both tips upstream of their roots", 1e3 * soft.upstream, 3, "mm");
    record.at_least("hard: both tips downstream of them", -1e3 * hard.upstream, 1, "mm");
    record.at_least("hard: tips off symmetry while it opens, of the half width", 100 * hard.asymmetry, 10, "%");
}

}  // namespace
}  // namespace dmp::tests::heart_valve_stiffness_tests
