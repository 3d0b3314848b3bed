// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "scene/read_scene.hpp"
#include "scene/start_from_state.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::scene_start_from_state_tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Scene of_case(const std::string& name, const std::vector<std::string>& overrides = {}) {
    return read_scene(DMP_SOURCE_DIR "/cases/" + name, overrides);
}

std::vector<std::string> fixed_keys(const std::string& name, const std::vector<std::string>& overrides) {
    std::vector<std::string> keys;
    for (const FixedValue& one : fixed_in_start(resolved_scene(of_case(name)), of_case(name, overrides)))
        keys.push_back(one.difference.key);
    return keys;
}

TEST(StartFromState, MayChangeWhatDrivesWhatResistsAndWhatIsWritten) {
    EXPECT_THAT(
        fixed_keys("vein_valve",
                   {"title=another", "flow.pressure_gradient=[\"-1 Pa/m\", 0]", "part.blood.viscosity=\"4 mPa*s\"",
                    "part.leaflets.bending_stiffness=\"2e-6 N*m^2\"", "part.leaflets.bond_damping=0.1",
                    "numerics.step_factor=0.4", "numerics.viscous_step_factor=0.4",
                    "numerics.viscosity_stepping=implicit", "numerics.sound_speed=\"4 m/s\"", "run.duration=\"9 s\"",
                    "output.every=\"1 ms\"", "output.average_from=\"1 s\"", "measure.tip_gap.name=gap"}),
        IsEmpty());
}

TEST(StartFromState, MayNotChangeParticlesNorWhatTheStateMeans) {
    EXPECT_THAT(
        fixed_keys("vein_valve", {"geometry.parameters.leaflet_length=\"16 mm\"", "particles.spacing=\"0.3 mm\"",
                                  "part.blood.density=\"1000 kg/m^3\"", "part.leaflets.mass_per_length=\"0.5 kg/m\"",
                                  "numerics.support=2.9", "numerics.background_pressure=\"1 Pa\"",
                                  "flow.initial_velocity=[\"1 mm/s\", 0]"}),
        ElementsAre("geometry.parameters", "particles.spacing", "flow.initial_velocity", "numerics.support",
                    "numerics.background_pressure", "part.blood.density", "part.leaflets.mass_per_length"));
}

TEST(StartFromState, MayChangeHowLiquidTurnsSolidAndWhenBondsBreak) {
    const Scene before = of_case("heart_valve/breakup.toml");
    EXPECT_THAT(
        fixed_in_start(resolved_scene(before),
                       of_case("heart_valve/breakup.toml",
                               {"solidify.clot.probability=0.1", "solidify.clot.until=\"0.9 s\"",
                                "solidify.clot.seed=7", "solidify.clot.reach=\"1 mm\"", "solidify.clot.most_bonds=2",
                                "solidify.clot.stress_above=\"1 Pa\"", "break.tear.force_above=\"1 N\""})),
        IsEmpty());
    for (const char* key : {"from=\"0.3 s\"", "interval=\"1 ms\"", "spreads=false", "bond_damping=0.1"})
        EXPECT_EQ(fixed_in_start(resolved_scene(before),
                                 of_case("heart_valve/breakup.toml", {"solidify.clot." + std::string(key)}))
                      .size(),
                  1U)
            << key;
}

/// What a state has to hold, and what seeds are, follows from whether they are given.
TEST(StartFromState, MayChangeConditionsOfResidenceWhereThereWereSome) {
    const std::vector<std::string> given{"solidify.clot.residence_above=\"1 s\""};
    const Scene without = of_case("clotting"), with = of_case("clotting", given),
                longer = of_case("clotting", {"solidify.clot.residence_above=\"2 s\""});
    EXPECT_THAT(fixed_in_start(resolved_scene(with), longer), IsEmpty());
    EXPECT_EQ(fixed_in_start(resolved_scene(with), without).size(), 1U);
    EXPECT_EQ(fixed_in_start(resolved_scene(without), with).size(), 1U);
}

TEST(StartFromState, MayNotChangeSpringsThatAreInTheState) {
    const auto fixed = fixed_in_start(resolved_scene(of_case("clotting")),
                                      of_case("clotting", {"solidify.clot.bond_stiffness=\"1 N/m\""}));
    ASSERT_EQ(fixed.size(), 1U);
    EXPECT_THAT(fixed.front().difference.key, HasSubstr("bond_stiffness"));
}

TEST(StartFromState, MayNotSetStillPartsInMotion) {
    Scene still = of_case("verification/taylor_couette"), moving = still;
    moving.parts[2].velocity.value[0] = Expression("0.001", "1 mm/s");
    EXPECT_EQ(fixed_in_start(resolved_scene(still), moving).size(), 1U);
    EXPECT_EQ(fixed_in_start(resolved_scene(moving), still).size(), 1U);
    Scene faster = moving;
    faster.parts[2].velocity.value[0] = Expression("0.002", "2 mm/s");
    EXPECT_THAT(fixed_in_start(resolved_scene(moving), faster), IsEmpty());
    faster.parts[2].velocity.value[0] = Expression("3.14159", "pi m/s", "pi m/s");
    EXPECT_THAT(fixed_in_start(resolved_scene(moving), faster), IsEmpty());
    faster.parts[2].velocity.value[0] = Expression("0", "0 m/s", "0 m/s");
    EXPECT_THAT(fixed_in_start(resolved_scene(still), faster), IsEmpty());
}

TEST(StartFromState, SaysWhy) {
    const Scene before = of_case("vein_valve"), now = of_case("vein_valve", {"particles.spacing=\"0.3 mm\""});
    EXPECT_EQ(fixed_text(fixed_in_start(resolved_scene(before), now)),
              "\n  particles.spacing: was \"2e-04 m\", is \"3e-04 m\": the particles would be others");
}

}  // namespace
}  // namespace dmp::tests::scene_start_from_state_tests
