// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// A hanging chain that breaks under its weight: once, where it is pulled most, and with the energy of one bond.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::chain_tests {
namespace {

constexpr int links = 10;
constexpr double spacing = 1e-3, mass = 1000 * spacing * spacing, stiffness = 10, limit = 1e-3;
constexpr double weight_at_end = 0.12, ramp = 10;

/// Elastic and kinetic energy of the chain, and the stretch of its first bond, frame by frame.
class Chain : public FrameSink {
  public:
    void write(const Frame& frame) override {
        const FrameGroup* solid = nullptr;
        for (const FrameGroup& group : frame.groups)
            if (group.name == "solid") solid = &group;
        if (solid == nullptr || solid->size() < links) return;
        std::vector<double> heights;
        for (std::size_t k = 0; k < solid->size(); ++k) heights.push_back(solid->position[3 * k + 1]);
        std::sort(heights.rbegin(), heights.rend());
        Seen now{frame.time, -heights.front() - spacing / 2, 0};
        for (const float force : bond_field(*solid, "force").values) now.stored += force * force / (4 * stiffness);
        seen.push_back(now);
    }
    struct Seen {
        double time, stretch;  ///< of the bond that holds it to the ceiling [m]
        double stored;         ///< in the others [J]
    };
    std::vector<Seen> seen;

  private:
    static const FrameField& bond_field(const FrameGroup& group, const std::string& name) {
        for (const FrameField& field : group.bond_fields)
            if (field.name == name) return field;
        throw std::invalid_argument("the bonds have no field " + name);
    }
};

TEST(Chain, BreaksOnceUnderItsWeight) {
    // n m g = F at the ceiling; the bond has then F^2 / (4 k_b), link j below it (n - j)^2 / n^2 of that.
    const double breaks = ramp * std::sqrt(limit / (links * mass) / weight_at_end);
    const double of_one_bond = limit * limit / (4 * stiffness);
    double others = 0;
    for (int j = 1; j < links; ++j) others += of_one_bond * std::pow(1 - static_cast<double>(j) / links, 2);
    Chain chain;
    const RunSummary run =
        run_case("verification/chain", {"output.every=1 ms", "output.measure_every=1 ms"}, breaks + 0.2, &chain, 1);
    const auto broken = column(run.measures, "chain_bonds_broken");
    const auto first = std::find(broken.begin(), broken.end(), 1) - broken.begin();
    ASSERT_LT(first, static_cast<std::ptrdiff_t>(broken.size())) << "it never breaks";
    const double time = run.measures.time[static_cast<std::size_t>(first)];
    const auto after = std::find_if(chain.seen.begin(), chain.seen.end(),
                                    [&](const Chain::Seen& frame) { return frame.time > time - 1e-6; });
    ASSERT_NE(after, chain.seen.begin());
    const Chain::Seen& before = *(after - 1);

    Record record("chain", "pulled by its weight", run);
    record.at_most("bonds broken, less one", broken.back() - 1, 0);
    record.at_most("bonds made, less one a link", static_cast<double>(run.aggregates.at(0).bonds_made) - links, 0);
    record.percent("weight at which it breaks, over its strength", std::pow(time / breaks, 2) - 1, 0.002);
    record.percent("energy in the bond that breaks, over F^2 / (4 k_b)",
                   stiffness * before.stretch * before.stretch / of_one_bond - 1, 0.005);
    record.percent("energy in the others", before.stored / others - 1, 0.005);
    // It falls freely: momentum is what weight and ceiling have given.
    record.at_most("momentum that came from nowhere, over all impulses", run.momentum_residual, 1e-12);
}

TEST(Chain, DoesNotBreakWhenPushed) {
    const RunSummary run =
        run_case("verification/chain", {"flow.acceleration=[0, \"0.36 m/s^2 * (t / 10 s)^2\"]"}, 10, nullptr, 1);
    Record record("chain", "pushed with three times its strength", run);
    record.at_most("bonds broken", static_cast<double>(run.aggregates.at(0).bonds_broken), 0);
}

/// Keeps the height of the one node that there is, from the time on at which it is pulled.
class Height : public FrameSink {
  public:
    void write(const Frame& frame) override {
        for (const FrameGroup& group : frame.groups)
            if (group.name == "solid" && group.size() == 1) of_time.emplace_back(frame.time, group.position[1]);
    }
    std::vector<std::pair<double, double>> of_time;
};

// One link, a mass on a bond of omega = sqrt(2 k_b / m), stepped explicitly with x = omega dt: its period is x / (2
// asin(x / 2)) of what it should be (leapfrog), and its swings stay as large as they were.
TEST(Chain, OfOneLinkSwingsWithThePeriodOfItsSteps) {
    const double omega = std::sqrt(2 * stiffness / mass);
    double worst = 0, grown = 0;
    RunSummary last;
    for (const double x : {0.05, 0.1, 0.2, 0.5, 1.0}) {
        const double dt = x / omega, pulled = 20 * dt, until = pulled + 2000 * dt;
        Height height;
        last = run_case(
            "verification/chain",
            {"geometry.parameters={ width = \"1 mm\", length = \"1 mm\" }", "numerics.spring_stepping=subcycled",
             "numerics.spring_step_factor=1", set_to("numerics.sound_speed", 0.2e-3 / dt, "m/s"),
             "solidify.chain.bond_damping=0", "solidify.chain.interval=1000 s",
             "flow.acceleration=[0, \"t > " + quantity(pulled, "s") + " ? -0.05 m/s^2 : 0\"]",
             set_to("output.every", dt, "s"), set_to("output.measure_every", dt, "s")},
            until, &height, 1);
        const double theta = 2 * std::asin(x / 2);
        // Of a sine, three values in a row give its middle; it begins where the pull does.
        const auto at = [&](std::size_t k) { return height.of_time[k].second; };
        const std::size_t first = height.of_time.size() - 1000;
        double middle = 0;
        for (std::size_t k = first; k + 1 < height.of_time.size(); ++k)
            middle += (at(k - 1) + at(k + 1) - 2 * std::cos(theta) * at(k)) / (2 - 2 * std::cos(theta)) / 999;
        std::vector<double> crossings;
        double early = 0, late = 0;
        for (std::size_t k = first; k < height.of_time.size(); ++k) {
            const double before = at(k - 1) - middle, now = at(k) - middle;
            // Where a sine through both values crosses, and how high it is.
            if (before < 0 && now >= 0)
                crossings.push_back(height.of_time[k - 1].first +
                                    dt / theta * std::atan2(-before * std::sin(theta), now - before * std::cos(theta)));
            const double high = std::hypot(before, (now - before * std::cos(theta)) / std::sin(theta));
            if (k == first) early = high;
            late = high;
        }
        ASSERT_GE(crossings.size(), 5U);
        const double period = (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
        worst = std::max(worst, std::abs(period * omega / (2 * std::numbers::pi) / (x / theta) - 1));
        grown = std::max(grown, std::abs(late / early - 1));
    }
    Record record("chain", "one link, explicit steps of 0.05 to 1 over omega", last);
    record.percent("period over that of the leapfrog, largest error", worst, 1e-4);
    record.percent("change of its swings in a thousand steps", grown, 1e-3);
}

}  // namespace
}  // namespace dmp::tests::chain_tests
