// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <optional>

#include <gmock/gmock.h>

#include "solver/run/warnings.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/small_scenes.hpp"

namespace dmp::tests::solver_warnings_tests {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const SourceLocation here{"scene.toml", 7, 9};

template <class T>
void give(Value<T>& value, T what) {
    value = {std::move(what), here};
}

Part part(const std::string& name, PartKind kind) {
    Part made;
    made.name = {name, {"scene.toml", 3, 8}};
    made.kind = kind;
    made.density = 1000.0;
    made.viscosity = 1e-3;
    return made;
}

/// Water in a pipe with a flap, which nothing is wrong with.
Scene pipe() {
    Scene scene;
    scene.parts = {part("water", PartKind::fluid), part("wall", PartKind::rigid), part("flap", PartKind::elastic)};
    scene.flow.acceleration[0] = Expression("1", "1");
    scene.run.duration = 4.0;
    scene.output.every = 1.0;
    scene.output.fields = {FluidField::velocity};
    return scene;
}

void without(Scene& scene, PartKind kind) {
    std::erase_if(scene.parts, [&](const Part& each) { return *each.kind == kind; });
}

/// Solids alone, with a contact that needs no liquid.
void without_fluid(Scene& scene) {
    without(scene, PartKind::fluid);
    scene.contact.strength = 1e-6;
}

std::vector<std::string> texts(const Scene& scene, std::size_t bodies = 1) {
    std::vector<std::string> all;
    for (const Warning& warning : warnings_of(scene, bodies)) all.push_back(warning.text());
    return all;
}

TEST(Warnings, are_not_given_without_reason) { EXPECT_THAT(texts(pipe(), 2), IsEmpty()); }

struct Oddity {
    const char* name;
    std::function<void(Scene&)> make;
    const char* key;  ///< and its place, where it has one
    const char* problem;
};

void PrintTo(const Oddity& oddity, std::ostream* out) { *out << oddity.name; }

class EachWarning : public ::testing::TestWithParam<Oddity> {};

TEST_P(EachWarning, names_key_and_place) {
    Scene scene = pipe();
    GetParam().make(scene);
    EXPECT_THAT(texts(scene), ElementsAre(AllOf(HasSubstr(GetParam().key), HasSubstr(GetParam().problem))));
}

std::string name_of(const ::testing::TestParamInfo<Oddity>& oddity) { return oddity.param.name; }

INSTANTIATE_TEST_SUITE_P(
    Warnings, EachWarning,
    ::testing::Values(
        Oddity{"drag_of_nothing", [](Scene& s) { give(s.parts[2].drag, 0.0); }, "scene.toml:7:9: part.flap.drag",
               "has no effect: it is 0"},
        Oddity{"mass_damping_of_nothing", [](Scene& s) { give(s.parts[2].mass_damping, 0.0); },
               "scene.toml:7:9: part.flap.mass_damping", "has no effect: it is 0"},
        Oddity{"a_steady_state_of_no_spheres", [](Scene& s) { give(s.run.until_steady, 1.0); },
               "scene.toml:7:9: run.until_steady", "has no effect: it ends runs of spheres only"},
        Oddity{"contact_of_nothing",
               [](Scene& s) {
                   without(s, PartKind::rigid);
                   without(s, PartKind::elastic);
                   give(s.contact.range, 1.0);
               },
               "scene.toml:7:9: contact.range", "has no effect: no part is solid"},
        Oddity{"strength_without_range",
               [](Scene& s) {
                   without(s, PartKind::elastic);
                   s.contact.range = 0.0;
                   give(s.contact.strength, 1.0);
               },
               "scene.toml:7:9: contact.strength", "has no effect: contact.range is 0"},
        Oddity{"contact_that_follows_no_fluid", [](Scene& s) { without(s, PartKind::fluid); }, "contact.strength",
               "is \"auto\", which follows the fluid, and there is none"},
        Oddity{"no_contact", [](Scene& s) { give(s.contact.range, 0.0); }, "scene.toml:7:9: contact.range",
               "spring bodies and walls that touch will pass through each other"},
        Oddity{"shifting_of_nothing",
               [](Scene& s) {
                   without_fluid(s);
                   give(s.numerics.shifting, 4.0);
               },
               "scene.toml:7:9: numerics.shifting", "has no effect: no part is a fluid"},
        Oddity{"diffusion_of_nothing",
               [](Scene& s) {
                   without_fluid(s);
                   give(s.numerics.density_diffusion, 0.1);
               },
               "scene.toml:7:9: numerics.density_diffusion", "has no effect: no part is a fluid"},
        Oddity{"kernel_of_nothing",
               [](Scene& s) {
                   without_fluid(s);
                   give(s.numerics.kernel, KernelKind::lucy);
               },
               "scene.toml:7:9: numerics.kernel", "has no effect: no part is a fluid"},
        Oddity{"a_support_below_the_cliff", [](Scene& s) { give(s.numerics.support, 2.5); },
               "scene.toml:7:9: numerics.support", "is below 2.9 spacings"},
        Oddity{"sound_too_fast_for_shifting",
               [](Scene& s) {
                   use_plain_scheme(s);
                   give(s.flow.largest_speed, 0.1);
                   give(s.numerics.shifting, 4.0);
                   give(s.numerics.sound_speed, 5.0);
               },
               "scene.toml:7:9: numerics.sound_speed", "is 50 times flow.largest_speed or more"},
        Oddity{"walls_of_nothing",
               [](Scene& s) {
                   without(s, PartKind::rigid);
                   without(s, PartKind::elastic);
                   give(s.numerics.walls, WallModel::plain);
               },
               "scene.toml:7:9: numerics.walls", "has no effect: no part is solid"},
        Oddity{"inviscid_between_walls", [](Scene& s) { give(s.parts[0].viscosity, 0.0); },
               "scene.toml:7:9: part.water.viscosity", "is 0 between no-slip walls"},
        Oddity{"nothing_moves", [](Scene& s) { s.flow.acceleration[0] = Expression(); }, "flow.acceleration",
               "nothing will move"},
        Oddity{"stepping_of_nothing",
               [](Scene& s) {
                   without(s, PartKind::elastic);
                   give(s.numerics.spring_stepping, SpringStepping::subcycled);
               },
               "scene.toml:7:9: numerics.spring_stepping", "has no effect: no part is elastic"},
        Oddity{"step_factor_of_implicit_springs", [](Scene& s) { give(s.numerics.spring_step_factor, 0.5); },
               "scene.toml:7:9: numerics.spring_step_factor", "has no effect: springs are stepped implicitly"},
        Oddity{"shifting_step_factor_of_the_corrected_scheme",
               [](Scene& s) { give(s.numerics.shifting_step_factor, 2.0); },
               "scene.toml:7:9: numerics.shifting_step_factor", "has no effect: with scheme"},
        Oddity{"step_factor_of_no_species", [](Scene& s) { give(s.numerics.species_step_factor, 0.4); },
               "scene.toml:7:9: numerics.species_step_factor", "has no effect: no species is stepped explicitly"},
        Oddity{"gap_of_a_disabled_part",
               [](Scene& s) {
                   s.parts[2].enabled = false;
                   Measure gap;
                   gap.name = std::string("gap");
                   gap.kind = MeasureKind::gap;
                   give(gap.part, std::string("flap"));
                   s.measures = {gap};
               },
               "scene.toml:7:9: measure.gap.part", "'flap' is left out (enabled = false)"},
        Oddity{"energy_of_no_fluid",
               [](Scene& s) {
                   without_fluid(s);
                   s.numerics.density_diffusion = 0.0;
                   s.numerics.shifting = 0.0;
                   Measure energy;
                   energy.name = std::string("energy");
                   energy.kind.location = {"scene.toml", 7, 9};
                   energy.kind.value = MeasureKind::kinetic_energy;
                   s.measures = {energy};
                   s.output.fields = std::vector<FluidField>{};
               },
               "scene.toml:7:9: measure.energy.kind", "is of the fluid, and no part is a fluid"},
        Oddity{"rows_of_nothing", [](Scene& s) { give(s.output.measure_every, 0.1); },
               "scene.toml:7:9: output.measure_every", "has no effect: the scene has no [[measure]]"},
        Oddity{"region_of_nothing",
               [](Scene& s) {
                   s.regions.resize(1);
                   give(s.regions[0].name, std::string("sinus"));
               },
               "scene.toml:7:9: region.sinus", "has no effect: 'residence_time' is not among output.fields"},
        Oddity{"average_of_nothing", [](Scene& s) { give(s.output.average_from, 1.0); },
               "scene.toml:7:9: output.average_from", "has no effect: no elastic solid has 'mean_displacement'"},
        Oddity{"average_after_the_end",
               [](Scene& s) {
                   give(s.output.average_from, 4.0);
                   s.output.solid_fields = {SolidField::mean_displacement};
               },
               "scene.toml:7:9: output.average_from", "is not before the run's end"},
        Oddity{"picture_of_nothing", [](Scene& s) { give(s.output.picture_field, FluidField::pressure); },
               "scene.toml:7:9: output.picture_field", "'pressure' is not among output.fields"}),
    name_of);

TEST(Warnings, of_nothing_that_moves_know_every_drive) {
    Scene scene = pipe();
    scene.flow.acceleration[0] = Expression();
    const Expression one("1", "1");
    Scene thrown = scene, pressed = scene, belt = scene, sucked = scene;
    sucked.flow.pressure_gradient.value[0] = one;
    thrown.flow.initial_velocity.value[1] = one;
    pressed.flow.initial_pressure = one;
    belt.parts[1].surface_velocity.value[0] = one;
    Scene squeezed = scene, brushed = scene;
    squeezed.forces.resize(1);
    brushed.moving_shapes.resize(1);
    for (const Scene& driven : {thrown, pressed, belt, sucked, squeezed, brushed})
        EXPECT_THAT(texts(driven), IsEmpty());
    belt.parts[1].enabled = false;
    EXPECT_THAT(texts(belt), Contains(HasSubstr("nothing will move")));
}

TEST(Warnings, of_solidifying_are_about_reach_and_times_and_not_about_the_regions_it_names) {
    Scene scene = pipe();
    scene.particles.spacing = 1e-3;
    scene.regions.resize(1);
    give(scene.regions[0].name, std::string("sinus"));
    Solidify clot;
    clot.name = std::string("clot");
    clot.seed_region = std::string("sinus");
    clot.reach = 1.2e-3;
    scene.solidify = {clot};
    EXPECT_THAT(texts(scene, 2), IsEmpty());
    give(scene.solidify[0].reach, 0.912e-3);
    EXPECT_THAT(texts(scene, 2), ElementsAre(AllOf(HasSubstr("scene.toml:7:9: solidify.clot.reach"),
                                                   HasSubstr("is less than the spacing"))));
    scene.solidify[0].reach = 1.2e-3;
    give(scene.solidify[0].from, 4.0);
    EXPECT_THAT(texts(scene, 2), ElementsAre(HasSubstr("nothing will turn solid")));
}

TEST(Warnings, of_uptake_are_about_layers_thinner_than_the_spacing) {
    Scene scene = pipe();
    scene.particles.spacing = 1e-5;
    scene.output.fields = {FluidField::velocity, FluidField::concentration};
    Species oxygen;
    oxygen.name = std::string("oxygen");
    oxygen.diffusivity.all = Value<double>(2e-9);
    oxygen.concentration.all = Value<Expression>(Expression("1", "1"));
    oxygen.uptake.parts["water"] = {19.0, here};
    scene.species = {oxygen};
    EXPECT_THAT(texts(scene), IsEmpty());
    scene.species[0].uptake.parts["water"] = {80.0, here};
    EXPECT_THAT(texts(scene),
                ElementsAre(AllOf(HasSubstr("scene.toml:7:9: species.oxygen.uptake in 'water' makes layers "
                                            "of sqrt(D / k) = 5 um"),
                                  HasSubstr("thinner than the spacing of the particles, 10 um"))));
    scene.species[0].diffusivity.all = Value<double>(0.0);
    EXPECT_THAT(texts(scene), IsEmpty()) << "nothing comes from elsewhere";
}

TEST(Warnings, of_missing_contact_count_bodies) {
    Scene scene = pipe();
    without(scene, PartKind::rigid);
    scene.contact.range = 0.0;
    EXPECT_THAT(texts(scene, 1), IsEmpty());
    EXPECT_THAT(texts(scene, 2), ElementsAre(HasSubstr("spring bodies that touch will pass through each other")));
}

TEST(Warnings, recommend_implicit_viscosity_where_it_saves_nine_tenths) {
    Scene scene = pipe();
    const std::vector<StepLimit> thick{{"sound", 1e-3, ""}, {"viscosity", 1e-6, ""}, {"contact", 2.1e-4, ""}};
    const std::optional<Warning> warning = viscosity_better_implicit(scene, thick);
    ASSERT_TRUE(warning);
    EXPECT_THAT(warning->text(), AllOf(HasSubstr("numerics.viscosity_stepping"), HasSubstr("210 times shorter")));
    EXPECT_FALSE(viscosity_better_implicit(scene, {{"sound", 1e-3, ""}, {"viscosity", 1e-5, ""}}));
    EXPECT_FALSE(viscosity_better_implicit(scene, {{"viscosity", 1e-5, ""}})) << "nothing to compare with";
    scene.numerics.viscosity_stepping = ViscosityStepping::implicitly;
    EXPECT_FALSE(viscosity_better_implicit(scene, thick));
}

TEST(Warnings, liquids_of_unlike_density_that_viscosity_hardly_damps) {
    Scene scene = pipe();
    scene.particles.spacing = 0.04;
    EXPECT_FALSE(stirred_interface(scene, 9.81)) << "one liquid";
    scene.parts.push_back(part("oil", PartKind::fluid));
    EXPECT_FALSE(stirred_interface(scene, 9.81)) << "of one density";
    give(scene.parts.back().density, 500.0);
    const auto found = stirred_interface(scene, 9.81);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->key, "part.oil.density");
    EXPECT_THAT(found->problem, HasSubstr("sqrt(A g dx^3) / nu is 1.45e+04"));  // nu = 10^-6 m^2/s
    EXPECT_FALSE(stirred_interface(scene, 0));
    scene.particles.spacing = 1e-4;
    EXPECT_FALSE(stirred_interface(scene, 9.81));
    scene.particles.spacing = 0.04;
    scene.numerics.scheme = FluidScheme::plain;
    EXPECT_FALSE(stirred_interface(scene, 9.81));
    give(scene.parts.back().density, 90.0);
    const auto stirred = stirred_interface(scene, 9.81);
    ASSERT_TRUE(stirred);
    EXPECT_THAT(stirred->text(), HasSubstr("part.oil.density is less than a tenth of that of 'water'"));
    EXPECT_FALSE(stirred_interface(scene, 0));
}

}  // namespace
}  // namespace dmp::tests::solver_warnings_tests
