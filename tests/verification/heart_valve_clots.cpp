// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// cases/heart_valve/calcification.toml and breakup.toml: a deposit that stops a leaflet, and a clot that breaks in two.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::heart_valve_clots_tests {
namespace {

/// Highest minus lowest place of a tip in a beat of 1 s [m].
double opening(const RunSummary& run, const std::string& tip, int beat) {
    const auto y = between(run.measures, tip + "_y", beat - 1, beat);
    return largest(y) - smallest(y);
}

TEST(CalcifiedHeartValve, OpensNoMore) {
    const RunSummary run = run_case("heart_valve/calcification.toml", {}, 3);
    Record record("heart_valve", "calcification, 1 mm", run);
    record.at_least("opening of the lower leaflet in the first beat", 1e3 * opening(run, "lower_tip", 1), 9, "mm");
    record.percent("in the third, of that in the first", opening(run, "lower_tip", 3) / opening(run, "lower_tip", 1),
                   0.2);
    record.at_least("the other leaflet's, the same", 100 * opening(run, "upper_tip", 3) / opening(run, "upper_tip", 1),
                    50, "%");
    EXPECT_EQ(run.lost, 0U);
}

/// Bonds of all solids in the first and in the last frame.
class Bonds : public FrameSink {
  public:
    void write(const Frame& frame) override {
        const auto solid = std::ranges::find(frame.groups, "solid", &FrameGroup::name);
        if (solid == frame.groups.end()) return;
        last = static_cast<double>(solid->bonds());
        if (first < 0) first = last;
    }
    double first = -1, last = -1;
};

TEST(ClotInHeartValve, BreaksInTwo) {
    Bonds bonds;
    const RunSummary run = run_case("heart_valve/breakup.toml", {}, 0.5, &bonds, 1);
    Record record("heart_valve", "clot that breaks, 1 mm", run);
    record.at_most("pieces of the clot, off two", column(run.measures, "clot_pieces").back() - 2, 0);
    const double largest_piece = column(run.measures, "clot_largest").back();
    record.at_least("particles in the smaller one", column(run.measures, "clot_particles").back() - largest_piece, 5);
    const auto made = column(run.measures, "clot_bonds_made"), broken = column(run.measures, "clot_bonds_broken");
    record.at_least("bonds that broke", broken.back(), 1);
    const double there =
        made.back() - broken.back() - (made.front() - broken.front());  // the first are made at the start
    record.at_most("bonds made, less those broken and those that are there", there - (bonds.last - bonds.first), 0);
}

}  // namespace
}  // namespace dmp::tests::heart_valve_clots_tests
