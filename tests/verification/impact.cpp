// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// A ball that hits a plane, or another one, against closed forms.
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "models/dem/contact_steps.hpp"
#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::impact_tests {
namespace {

constexpr double pi = std::numbers::pi;

struct Ball {
    double radius, density, youngs_modulus, poisson_ratio;
    [[nodiscard]] double mass() const { return density * 4 / 3 * pi * std::pow(radius, 3); }
};

/// What is seen of an impact.
struct Seen {
    double overlap = 0, force = 0;  ///< the largest [m], [N]
    double duration = 0;            ///< [s]
    std::array<double, 3> velocity{}, spin{};
    RunSummary run;
};

/// How deep the ball is in what it hits, step by step.
class Overlaps : public FrameSink {
  public:
    explicit Overlaps(double gap) : gap_(gap) {}
    void write(const Frame& frame) override {
        const FrameGroup& spheres = required_group(frame, "spheres");
        // Two balls approach each other at the same speed.
        of_time.emplace_back(frame.time, -static_cast<double>(spheres.size()) * spheres.position[2] - gap_);
    }
    std::vector<std::pair<double, double>> of_time;

  private:
    double gap_;
};

/// An impact of the case: on the plane, or of two balls head on.
struct Impact {
    Ball ball;
    double speed;  ///< of the ball [m/s]
    double degrees = 0;
    int balls = 1;
    double steps = 200;   ///< in the duration of the elastic impact
    double begins = 0.5;  ///< part of a step after which they touch
    double lasts = 1;     ///< duration, in that of the elastic impact
    std::vector<std::string> more{};

    // Hertz (1882), Johnson (Contact Mechanics, 1985): of one ball on a rigid plane R* = R, of two alike R/2.
    [[nodiscard]] double radius() const { return ball.radius / balls; }
    [[nodiscard]] double mass() const { return ball.mass() / balls; }
    [[nodiscard]] double stiffness() const {
        return 4.0 / 3 * ball.youngs_modulus / (1 - ball.poisson_ratio * ball.poisson_ratio) / balls;
    }
    [[nodiscard]] double approach() const { return balls * speed * std::cos(degrees * pi / 180); }
    [[nodiscard]] double overlap() const {
        return std::pow(1.25 * mass() * approach() * approach() / (stiffness() * std::sqrt(radius())), 0.4);
    }
    [[nodiscard]] double force() const { return stiffness() * std::sqrt(radius()) * std::pow(overlap(), 1.5); }
    [[nodiscard]] double duration() const { return 0.8 * std::beta(0.4, 0.5) * overlap() / approach(); }

    [[nodiscard]] Seen run() const;
};

Seen Impact::run() const {
    const double dt = duration() / steps, gap = begins * dt * approach(), angle = degrees * pi / 180;
    std::vector<std::string> overrides{set_to("numerics.contact_step", dt, "s"), set_to("output.every", dt, "s"),
                                       set_to("output.measure_every", dt, "s")};
    for (const std::string part : {"part.ball.", "part.partner."}) {
        overrides.push_back(set_to(part + "radius", ball.radius, "m"));
        overrides.push_back(set_to(part + "density", ball.density, "kg/m^3"));
        overrides.push_back(set_to(part + "youngs_modulus", ball.youngs_modulus, "Pa"));
        overrides.push_back(set_to(part + "poisson_ratio", ball.poisson_ratio));
    }
    overrides.push_back(
        set_to("part.ball.initial_velocity", {speed * std::sin(angle), 0, -speed * std::cos(angle)}, "m/s"));
    overrides.push_back(set_to("part.partner.initial_velocity", {0, 0, speed}, "m/s"));
    overrides.push_back("part.partner.centres=[[0, 0, \"" + quantity(-2 * ball.radius - gap, "m") + "\"]]");
    for (const std::string plane : {"plane", "damper"})
        overrides.push_back(set_to("part." + plane + ".point", {0, 0, -ball.radius - gap}, "m"));
    if (balls == 2) {
        overrides.emplace_back("part.partner.enabled=true");
        overrides.emplace_back("part.plane.enabled=false");
    }
    overrides.insert(overrides.end(), more.begin(), more.end());

    Overlaps overlaps(gap);
    Seen seen;
    seen.run = run_case("verification/impact", overrides, (1.2 * lasts * steps + 20) * dt, &overlaps, 1);
    double parted = 0;
    for (std::size_t k = 1; k < overlaps.of_time.size(); ++k) {
        const auto [before, deep] = overlaps.of_time[k - 1];
        const auto [now, next] = overlaps.of_time[k];
        seen.overlap = std::max(seen.overlap, next);
        if (deep > 0 && next <= 0) parted = before + (now - before) * deep / (deep - next);
    }
    EXPECT_LT(overlaps.of_time.back().second, 0) << "it is still there";
    seen.duration = parted - begins * dt;
    const MeasureSeries& measures = seen.run.measures;
    const std::vector<double> down = column(measures, "velocity_z");
    for (std::size_t k = 1; k < down.size(); ++k)
        seen.force = std::max(seen.force, ball.mass() * (down[k] - down[k - 1]) / dt);
    seen.velocity = {column(measures, "velocity_x").back(), column(measures, "velocity_y").back(), down.back()};
    seen.spin = {column(measures, "spin_x").back(), column(measures, "spin_y").back(),
                 column(measures, "spin_z").back()};
    return seen;
}

constexpr Ball aluminium_oxide{2.5e-3, 4000, 3.8e11, 0.23};

std::vector<std::string> with(double restitution, double friction = 0) {
    return {set_to("contact_pair.touch.restitution", restitution), set_to("contact_pair.touch.friction", friction)};
}

// ---- Chung & Ooi, Granul. Matter 13 (2011) 643

void expect_hertz(const std::string& setting, const Impact& impact) {
    const Seen seen = impact.run();
    Record record("impact", setting, seen.run);
    record.percent("largest overlap", seen.overlap / impact.overlap() - 1, 0.001);
    record.percent("largest force", seen.force / impact.force() - 1, 0.001);
    record.percent("duration", seen.duration / impact.duration() - 1, 0.001);
    record.percent("speed of the rebound", seen.velocity[2] / impact.speed - 1, 0.001);
}

TEST(Impact, OfTwoBallsHeadOn) {
    expect_hertz("test 1: two balls of glass", {{0.01, 2800, 4.8e10, 0.20}, 10, 0, 2, 200, 0.5, 1, with(1, 0.35)});
    expect_hertz("test 1: two balls of limestone", {{0.01, 2500, 2.0e10, 0.25}, 10, 0, 2, 200, 0.5, 1, with(1, 0.35)});
}

TEST(Impact, OnAPlane) {
    const auto elastic = [](const Ball& ball, double speed) { return Impact{ball, speed, 0, 1, 200, 0.5, 1, with(1)}; };
    expect_hertz("test 2: aluminium alloy on a plane", elastic({0.1, 2699, 7.0e10, 0.30}, 0.2));
    expect_hertz("test 2: magnesium alloy on a plane", elastic({0.1, 1800, 4.0e10, 0.35}, 0.2));
    expect_hertz("test 3: aluminium oxide on a plane", elastic(aluminium_oxide, 3.9));
    expect_hertz("test 3: cast iron on a plane", elastic({2.5e-3, 7000, 1.0e11, 0.25}, 3.9));
}

// While the surfaces slide all along, for tan(angle) > 7/2 mu (1 + e),
//   v_t' / v_t = 1 - mu (1 + e) v_n / v_t,   omega' = 5/2 mu (1 + e) v_n / R
TEST(Impact, ObliqueOnAPlane) {
    constexpr double friction = 0.092, restitution = 0.98;
    for (const auto& [name, ball] :
         {std::pair{"aluminium oxide", aluminium_oxide}, {"aluminium alloy", Ball{2.5e-3, 2700, 7.0e10, 0.33}}}) {
        double normal = 0, tangential = 0, spin = 0;
        Seen last;
        for (const double degrees : {35.0, 40.0, 50.0, 60.0, 70.0, 80.0, 85.0}) {
            const Impact impact{ball, 3.9, degrees, 1, 200, 0.5, 1.1, with(restitution, friction)};
            last = impact.run();
            const double across = impact.speed * std::sin(degrees * pi / 180);
            const double slowed = friction * (1 + restitution) * impact.approach();
            const auto worse = [](double& worst, double figure) { worst = std::max(worst, std::abs(figure)); };
            worse(normal, last.velocity[2] / (restitution * impact.approach()) - 1);
            worse(tangential, last.velocity[0] / (across - slowed) - 1);
            worse(spin, last.spin[1] / (2.5 * slowed / ball.radius) - 1);
        }
        Record record("impact", std::string("test 4: ") + name + ", 35 to 85 degrees", last.run);
        record.percent("normal velocity, largest error", normal, 0.005);
        record.percent("tangential velocity, largest error", tangential, 0.005);
        record.percent("spin, largest error", spin, 0.005);
    }
}

// The same below that, for aluminium oxide: the curve of the paper, as other codes' tests have digitised it.
TEST(Impact, SteepOnAPlane) {
    constexpr std::array<std::pair<double, double>, 6> curve{
        {{5, 0.948}, {10, 0.687}, {15, 0.624}, {20, 0.616}, {25, 0.634}, {30, 0.684}}};
    double nearly_normal = 0, steep = 0;
    Seen last;
    for (const auto& [degrees, kept] : curve) {
        const Impact impact{aluminium_oxide, 3.9, degrees, 1, 200, 0.5, 1.1, with(0.98, 0.092)};
        last = impact.run();
        double& worst = degrees < 12 ? nearly_normal : steep;
        worst = std::max(worst, std::abs(last.velocity[0] / (3.9 * std::sin(degrees * pi / 180)) - kept));
    }
    Record record("impact", "test 4: aluminium oxide, 5 to 30 degrees", last.run);
    record.at_most("tangential velocity kept, from the curve, 5 and 10 degrees", nearly_normal, 0.03);
    record.at_most("the same, 15 to 30 degrees", steep, 0.01);
}

// With the default number of steps at the speed of the impact, against many: errors over that speed.
TEST(Impact, ObliqueWithTheDefaultSteps) {
    double speed = 0, spin = 0, angle = 0;
    Seen last;
    for (const double restitution : {0.98, 0.5})
        for (const double friction : {0.0, 0.3, 1.0})
            for (const double degrees : {15.0, 45.0, 60.0, 75.0, 85.0}) {
                const double longer = std::pow(std::cos(degrees * pi / 180), -0.2);
                Impact impact{aluminium_oxide, 3.9, degrees, 1, 600, 0.5, 1.5, with(restitution, friction)};
                const auto total = [](const Seen& of) { return std::hypot(of.velocity[0], of.velocity[2]); };
                const auto leaves = [](const Seen& of) { return std::atan2(of.velocity[0], of.velocity[2]); };
                const Seen exact = impact.run();
                impact.steps = StepsPerContact::standard * longer;
                for (const double begin : {0.1, 0.5, 0.9}) {
                    impact.begins = begin;
                    last = impact.run();
                    const auto worse = [](double& worst, double figure) { worst = std::max(worst, std::abs(figure)); };
                    worse(speed, (total(last) - total(exact)) / impact.speed);
                    worse(spin, (last.spin[1] - exact.spin[1]) * impact.ball.radius / impact.speed);
                    worse(angle, (leaves(last) - leaves(exact)) / (pi / 2));
                }
            }
    Record record("impact", "15 to 85 degrees, friction 0 to 1, restitution 0.98 and 0.5, 30 steps a contact",
                  last.run);
    record.percent("speed, largest error over that of the impact", speed, 0.01);
    record.percent("speed of the surface by the spin, the same", spin, 0.01);
    record.percent("angle, largest error over a right angle", angle, 0.01);
}

// ---- restitution

constexpr std::array<double, 10> restitutions{0.98, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1};
constexpr std::array<double, 5> begins{0.1, 0.3, 0.5, 0.7, 0.9};

TEST(Impact, ReboundsWithTheRestitutionAsked) {
    for (const bool pulls : {true, false}) {
        double fine = 0, standard = 0, mean = 0;
        Seen last;
        for (const double restitution : restitutions) {
            double sum = 0;
            for (const double begin : begins) {
                Impact impact{aluminium_oxide, 3.9, 0, 1, 200, begin, 3, with(restitution)};
                impact.more.push_back(std::string("contact_pair.touch.dashpot_may_pull=") + (pulls ? "true" : "false"));
                last = impact.run();
                fine = std::max(fine, std::abs(last.velocity[2] / impact.speed / restitution - 1));
                impact.steps = 20;
                const double found = impact.run().velocity[2] / impact.speed;
                standard = std::max(standard, std::abs(found - restitution));
                sum += found / begins.size();
            }
            mean = std::max(mean, std::abs(sum - restitution));
        }
        Record record("impact", std::string("restitution 0.1 to 0.98, dashpot ") + (pulls ? "may pull" : "is cut off"),
                      last.run);
        record.percent("restitution, largest error, 200 steps a contact", fine, 0.005);
        record.at_most("restitution, largest difference, 20 steps a contact", standard, 0.0013);
        record.at_most("the same, of the mean over where in a step it begins", mean, 0.0005);
    }
}

// F = sqrt(R d) (k d - m g d') until d = 0, or cut off at 0, integrated with Runge & Kutta's method; in units of length
// d_s = (m v^2 / (k sqrt R))^0.4 and of time d_s / v, with G = g sqrt(R) d_s^1.5 / v.
void expect_table(const std::string& setting) {
    struct Row {
        double damping, restitution, duration, overlap, cut_off;
    };
    constexpr std::array<Row, 8> table{{{0, 1.00000, 3.21807, 1.09336, 1.00000},
                                        {0.01, 0.98854, 3.22180, 1.08835, 0.98855},
                                        {0.05, 0.94426, 3.23715, 1.06883, 0.94440},
                                        {0.1, 0.89215, 3.25729, 1.04560, 0.89286},
                                        {0.2, 0.79755, 3.30078, 1.00262, 0.80097},
                                        {0.5, 0.57382, 3.45835, 0.89588, 0.59525},
                                        {1, 0.33116, 3.82845, 0.76748, 0.39393},
                                        {2, 0.09533, 5.24527, 0.60767, 0.21165}}};
    double restitution = 0, duration = 0, overlap = 0, cut_off = 0;
    Seen last;
    for (const Row& row : table) {
        Impact impact{.ball = aluminium_oxide, .speed = 3.9};
        const double unit = impact.overlap() / std::pow(1.25, 0.4);
        impact.lasts = row.duration / table[0].duration;
        impact.more = {
            "part.plane.enabled=false", "part.damper.enabled=true",
            set_to("contact_pair.damped.normal_damping",
                   row.damping * impact.speed / (std::sqrt(impact.radius()) * std::pow(unit, 1.5)), "1/m/s")};
        last = impact.run();
        const auto worse = [](double& worst, double figure) { worst = std::max(worst, std::abs(figure)); };
        worse(restitution, last.velocity[2] / impact.speed / row.restitution - 1);
        worse(duration, last.duration * impact.speed / unit / row.duration - 1);
        worse(overlap, last.overlap / unit / row.overlap - 1);
        impact.more.emplace_back("contact_pair.damped.dashpot_may_pull=false");
        impact.lasts = 3;
        worse(cut_off, impact.run().velocity[2] / impact.speed / row.cut_off - 1);
    }
    Record record("impact", setting, last.run);
    record.percent("restitution, largest error", restitution, 0.001);
    record.percent("duration, largest error", duration, 0.001);
    record.percent("largest overlap, largest error", overlap, 0.001);
    record.percent("restitution where the dashpot is cut off, largest error", cut_off, 0.001);
}

TEST(Impact, DampedByCoefficients) { expect_table("damped, G up to 2, 200 steps"); }

}  // namespace
}  // namespace dmp::tests::impact_tests
