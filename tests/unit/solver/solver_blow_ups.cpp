// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Runs that go wrong on purpose must be found out soon, and say what went wrong.
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "small_scenes.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_blow_ups_tests {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

constexpr long steps_allowed = 100;  // between the first bad particle and the end
constexpr double spacing = 0.5e-3, half_width = 4e-3;

/// The vein valve, coarse.
SceneAndParticles small_valve(std::vector<std::string> overrides) {
    overrides.insert(overrides.begin(), {"particles.spacing=0.5 mm", "output.measure_every=1 s",
                                         "output.fields=[\"velocity\", \"density\"]"});
    return case_of("vein_valve", overrides);
}

/// One moving particle of a frame.
struct Seen {
    std::string group;
    double x = 0, y = 0, speed = 0, density = 0;  ///< density: relative; 1 for solids
};

/// Looks at every step for itself, and keeps the first in which it sees a bad particle, and the last there was.
class Witness : public FrameSink {
  public:
    using Criterion = std::function<bool(const Seen&)>;
    explicit Witness(Criterion is_bad) : is_bad_(std::move(is_bad)) {}

    void write(const Frame& frame) override {
        last = frame.step;
        for (const FrameGroup& group : frame.groups) {
            if (group.name == "walls" || first_bad) continue;
            const FrameField& velocity = *field_of(group, "velocity");
            const FrameField* density = field_of(group, "density");
            for (std::size_t i = 0; i < group.size() && !first_bad; ++i) {
                const double speed = std::hypot(velocity.values[3 * i], velocity.values[3 * i + 1]);
                if (is_bad_({group.name, group.position[3 * i], group.position[3 * i + 1], speed,
                             density != nullptr ? density->values[i] / 1056.0 : 1.0}))
                    first_bad = frame.step;
            }
        }
    }
    std::optional<long> first_bad;
    long last = 0;

  private:
    Criterion is_bad_;
};

struct Ending {
    std::optional<long> first_bad;  ///< step, by the witness
    long step = 0;                  ///< of the end
    std::string problem, what_to_do;
};

/// Runs it with a frame every step or two, until it ends by itself or at `until`.
Ending ending_of(SceneAndParticles made, double until, const Witness::Criterion& also_bad = {}) {
    Simulation trial(made.scene, made.particles, 1);
    const Plan plan = trial.plan();
    made.scene.output.every = plan.dt;
    const double top = made.particles.box.high[1], bottom = made.particles.box.low[1];
    Witness witness([&](const Seen& seen) {
        return !(std::isfinite(seen.x) && std::isfinite(seen.y)) || !(seen.speed < plan.sound_speed) || seen.y > top ||
               seen.y < bottom || !(seen.density > 0.5 && seen.density < 1.5) || (also_bad && also_bad(seen));
    });
    RunOptions options;
    options.sink = &witness;
    options.until = until;
    Ending ending;
    try {
        Simulation simulation(made.scene, made.particles, 1);
        ending.step = simulation.run(options).steps;
    } catch (const DivergenceError& error) {
        ending.problem = error.problem();
        ending.what_to_do = error.what_to_do();
        ending.step = witness.last;
    }
    ending.first_bad = witness.first_bad;
    testing::Test::RecordProperty("first_bad_step", static_cast<int>(ending.first_bad.value_or(-1)));
    testing::Test::RecordProperty("last_step", static_cast<int>(ending.step));
    return ending;
}

void expect_found_in_time(const Ending& ending, const std::string& first_cause) {
    ASSERT_TRUE(ending.first_bad) << "nothing went wrong: " << ending.problem;
    EXPECT_LE(ending.step - *ending.first_bad, steps_allowed);
    EXPECT_THAT(ending.problem, ContainsRegex("particle [0-9]+ of '(blood|leaflets)' at \\(.* m, .* m\\) .*speed "));
    EXPECT_THAT(ending.what_to_do, ContainsRegex("^likely causes?: " + first_cause));
}

TEST(BlowUps, step_forced_to_twenty_times_its_size) {
    // Nothing else may hold the step back, and the scene's own bounds are passed by.
    SceneAndParticles made = small_valve(
        {"numerics.scheme=plain", "numerics.shifting=0", "numerics.density_diffusion=0", "contact.range=0"});
    const double usual = Simulation(made.scene, made.particles, 1).plan().dt;
    made.scene.numerics.step_factor = 20 * made.scene.numerics.step_factor;
    ASSERT_NEAR(Simulation(made.scene, made.particles, 1).plan().dt / usual, 20, 1e-6);
    expect_found_in_time(ending_of(made, 0.5), "numerics.step_factor = 6 is too large");
}

TEST(BlowUps, springs_ten_thousand_times_stiffer_with_the_step_of_the_soft_ones) {
    const std::vector<std::string> stiffer{"part.leaflets.bending_stiffness=3e-2 N*m^2",
                                           "part.leaflets.axial_stiffness=1e6 N"};
    SceneAndParticles made = small_valve(stiffer);
    made.scene.numerics.spring_stepping = SpringStepping::subcycled;
    made.scene.numerics.spring_step_factor =
        100 * made.scene.numerics.spring_step_factor;  // of a limit 100 times shorter
    expect_found_in_time(ending_of(made, 0.5), "numerics.spring_step_factor = 50 leaves the springs too large a step");
}

TEST(BlowUps, springs_ten_thousand_times_stiffer_with_the_implicit_step_are_no_harm) {
    SceneAndParticles made =
        small_valve({"part.leaflets.bending_stiffness=3e-2 N*m^2", "part.leaflets.axial_stiffness=1e6 N"});
    const Ending ending = ending_of(made, 0.02);
    EXPECT_EQ(ending.problem, "");
    EXPECT_FALSE(ending.first_bad);
}

/// The wall particles of the lower wall between these places are left out.
void cut_hole(ParticleSet& set, double from, double to) {
    ParticleSet kept;
    static_cast<ParticleSpace&>(kept) = set;
    std::vector<int> number(set.size(), -1);
    for (std::size_t i = 0; i < set.size(); ++i) {
        const Vec& x = set.position[i];
        if (set.kind(i) == PartKind::rigid && x[1] < 0 && x[0] > from && x[0] < to) continue;
        number[i] = static_cast<int>(kept.size());
        kept.position.push_back(x);
        kept.volume.push_back(set.volume[i]);
        kept.mass.push_back(set.mass[i]);
        kept.part.push_back(set.part[i]);
        kept.body.push_back(set.body[i]);
        kept.fixed.push_back(set.fixed[i]);
        kept.seated.push_back(set.seated[i]);
        kept.wall_normal.push_back(set.wall_normal[i]);
        kept.wall_distance.push_back(set.wall_distance[i]);
    }
    for (const Bond& bond : set.bonds)
        kept.bonds.push_back({number[bond.a], number[bond.b], bond.rest_length, bond.stiffness});
    for (const Hinge& hinge : set.hinges)
        kept.hinges.push_back(
            {number[hinge.a], number[hinge.centre], number[hinge.b], hinge.rest_angle, hinge.stiffness});
    set = std::move(kept);
}

TEST(BlowUps, wall_with_a_hole) {
    for (const double width : {3 * spacing, 8 * spacing, 24 * spacing}) {
        SceneAndParticles made = small_valve({"numerics.scheme=plain"});
        const double from = -35e-3, to = from + width;
        cut_hole(made.particles, from, to);
        const Ending ending = ending_of(made, 0.5, [&](const Seen& seen) {
            return seen.group == "fluid" && seen.y < -half_width - spacing && seen.x > from - spacing &&
                   seen.x < to + spacing;
        });
        expect_found_in_time(ending, "a wall there has a hole");
        EXPECT_THAT(ending.problem, AllOf(HasSubstr("of 'blood'"), HasSubstr("has left the domain")));
    }
}

TEST(BlowUps, step_forced_to_three_times_its_size_breaks_more_slowly) {
    const SceneAndParticles made =
        small_valve({"numerics.scheme=plain", "numerics.shifting=0", "contact.range=0", "numerics.step_factor=1"});
    expect_found_in_time(ending_of(made, 0.5), "numerics.step_factor = 1 is too large");
}

TEST(BlowUps, springs_with_a_step_a_little_too_long) {
    // One spring step in each of the fluid's, 1.38 times the largest stable one.
    SceneAndParticles made = small_valve({"numerics.spring_stepping=subcycled", "numerics.step_factor=0.21"});
    made.scene.numerics.spring_step_factor = 1.4;
    expect_found_in_time(ending_of(made, 0.5), "numerics.spring_step_factor = 1.4 leaves the springs too large a step");
}

TEST(BlowUps, speeds_a_thousand_times_those_expected) {
    SceneAndParticles made = small_valve({"flow.largest_speed=0.0001 m/s", "numerics.sound_speed=auto",
                                          "flow.pressure_gradient=[\"-77.09 Pa/m * cos(2*pi*t / 4 s)\", 0]"});
    // The pressure that the leaflets hold back gives a speed of sound that is high enough.
    const Ending of_auto = ending_of(made, 0.5);
    EXPECT_EQ(of_auto.problem, "");
    EXPECT_FALSE(of_auto.first_bad);
    made.scene.flow.largest_pressure = 1e-4;  // rho c0^2 Ma^2
    expect_found_in_time(ending_of(made, 2), "flow.largest_speed = 0.0001 m/s is below what the drive produces");
}

/// What a run that diverges says.
std::string words_of(const std::string& name, const std::vector<std::string>& overrides) {
    const auto [scene, particles] = case_of(name, overrides);
    try {
        Simulation(scene, particles, 1).run({});
    } catch (const DivergenceError& error) {
        return error.what_to_do();
    }
    return "nothing went wrong";
}

TEST(BlowUps, settings_far_from_their_defaults_are_named) {
    EXPECT_THAT(words_of("verification/poiseuille", {"particles.spacing=\"0.1 mm\"", "contact.range=7"}),
                HasSubstr("contact.range = 7 spacings makes particles push that do not touch; the default is 0.7"));
    EXPECT_THAT(words_of("verification/taylor_green", {"particles.spacing=\"0.04 m\"", "numerics.shifting=2e-4"}),
                testing::StartsWith("likely cause: numerics.shifting = 0.0002 is far from the usual 0.2"));
}

TEST(BlowUps, a_drive_a_thousand_times_as_strong) {
    SceneAndParticles made = small_valve({"flow.pressure_gradient=[\"-77090 Pa/m * cos(2*pi*t / 4 s)\", 0]"});
    expect_found_in_time(ending_of(made, 0.5), "numerics.sound_speed = 3 m/s is not ten times the speed");
}

}  // namespace
}  // namespace dmp::tests::solver_blow_ups_tests
