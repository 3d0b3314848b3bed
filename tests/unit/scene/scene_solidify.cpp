// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// [[solidify]] and [[break]]: what they read as, and what is wrong with them where.
#include "scene/schema.hpp"
#include "tests/modules.hpp"
#include "tests/unit/scene/fault.hpp"

namespace dmp::tests::scene_solidify_tests {
namespace {

/// good_scene is 49 lines long.
const std::string solidify = R"(
[[region]]
name = "nidus"
from = [0, 0]
to = ["1 mm", "1 mm"]

[[solidify]]
name = "clot"
liquid = "blood"
seed_region = "nidus"
reach = "0.12 mm"
probability = 0.25
interval = "10 ms"
bond_stiffness = "10 N/m"

[[break]]
name = "tear"
part = "clot"
force_above = "1 mN"
)";

std::string scene_text(const std::string& found, const std::string& replacement) {
    std::string text = good_scene + solidify;
    const auto at = text.find(found);
    if (at == std::string::npos) throw std::logic_error("the test scene has no " + found);
    return text.replace(at, found.size(), replacement);
}

Scene scene_of(const std::string& text) {
    const Folder folder;
    Folder::write(text);
    return read_scene("scene.toml", {});
}

TEST(SolidifyScene, reads_what_is_given_and_its_defaults) {
    const Scene scene = scene_of(good_scene + solidify);
    ASSERT_EQ(scene.solidify.size(), 1U);
    const Solidify& rule = scene.solidify[0];
    EXPECT_EQ(*rule.name, "clot");
    EXPECT_EQ(*rule.liquid, "blood");
    EXPECT_EQ(*rule.seed_region, "nidus");
    EXPECT_DOUBLE_EQ(*rule.reach, 1.2e-4);
    EXPECT_EQ(*rule.probability, 0.25);
    EXPECT_DOUBLE_EQ(*rule.interval, 0.01);
    EXPECT_EQ(*rule.bond_stiffness, 10);
    EXPECT_EQ(*rule.rule, SolidifyRule::per_candidate);
    EXPECT_EQ(*rule.active, SeedActivity::always);
    EXPECT_EQ(*rule.bond_to, BondTo::seed);
    EXPECT_TRUE(*rule.spreads);
    EXPECT_EQ(*rule.from, 0);
    EXPECT_EQ(*rule.rest_length, 0) << "auto";
    EXPECT_EQ(*rule.bond_damping, 0.01);
    EXPECT_EQ(*rule.seed, 1);
    EXPECT_FALSE(rule.most_bonds.given());
    ASSERT_EQ(scene.breaking.size(), 1U);
    EXPECT_EQ(*scene.breaking[0].part, "clot");
    EXPECT_DOUBLE_EQ(*scene.breaking[0].force_above, 1e-3);
    EXPECT_EQ(*scene.breaking[0].interval, 0) << "every step";
    EXPECT_TRUE(scene.changes_bodies());
    EXPECT_FALSE(scene_of(good_scene).changes_bodies());
}

TEST(SolidifyScene, is_read_back_from_what_it_resolves_to) {
    const Scene scene = scene_of(scene_text("seed_region = \"nidus\"",
                                            "seed_part = \"wall\"\nactive = \"one_in\"\none_in = 10\nmost_bonds = 4\n"
                                            "rest_length = \"0.1 mm\"\nrule = \"mutually_closest\"\nspreads = false"));
    EXPECT_EQ(scene_of(resolved_scene(scene)).hash, scene.hash);
    EXPECT_EQ(*scene_of(resolved_scene(scene)).solidify[0].one_in, 10);
}

TEST(SolidifyScene, follows_residence_only_where_a_rule_waits_for_it) {
    EXPECT_FALSE(scene_of(good_scene + solidify).asks_for(FluidField::residence_time));
    const std::string waits = "seed_region = \"nidus\"\nseed_residence_above = \"1 s\"";
    EXPECT_TRUE(scene_of(scene_text("seed_region = \"nidus\"", waits)).asks_for(FluidField::residence_time));
}

class BadSolidify : public testing::TestWithParam<Fault> {};

TEST_P(BadSolidify, says_where_what_and_what_to_do) {
    const std::string text = scene_text(GetParam().found, GetParam().replacement);
    try {
        (void)scene_of(text);
        FAIL() << "nothing was thrown";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()), GetParam().message);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Scene, BadSolidify,
    testing::ValuesIn(std::vector<Fault>{
        Fault{"probability_2", "probability = 0.25", "probability = 2",
              "scene.toml:57:15: solidify.clot.probability: found 2, expected more than 0 and at most 1\n"
              "  give a value that is more than 0 and at most 1"},
        Fault{"no_reach", "reach = \"0.12 mm\"", "reach = 0",
              "scene.toml:56:9: solidify.clot.reach: found 0, expected more than 0\n"
              "  give a value that is more than 0"},
        Fault{"reach_of_0", "reach = \"0.12 mm\"", "reach = \"0 mm\"",
              "scene.toml:56:9: solidify.clot.reach: found \"0 mm\", expected more than 0\n"
              "  give a value that is more than 0"},
        Fault{"negative_stiffness", "\"10 N/m\"", "\"-10 N/m\"",
              "scene.toml:59:18: solidify.clot.bond_stiffness: found \"-10 N/m\", expected more than 0\n"
              "  give a value that is more than 0"},
        Fault{"liquid_that_is_a_wall", "liquid = \"blood\"", "liquid = \"wall\"",
              "scene.toml:54:10: liquid of solidify 'clot': part 'wall' is of kind 'rigid', expected a fluid part\n"
              "  the scene has 'blood'"},
        Fault{"liquid_that_is_not", "liquid = \"blood\"", "liquid = \"blod\"",
              "scene.toml:54:10: liquid of solidify 'clot': the scene has no 'blod'\n"
              "  did you mean 'blood'?"},
        Fault{"name_of_a_part", "name = \"clot\"", "name = \"wall\"",
              "scene.toml:53:8: there is already a part called 'wall', at scene.toml:17:8\n"
              "  give the [[solidify]] a name of its own"},
        Fault{"no_seeds", "seed_region = \"nidus\"\n", "",
              "scene.toml:53:8: solidify 'clot' has no seeds: nothing would solidify\n"
              "  add seed_part, seed_region or seed_stress_above"},
        Fault{"two_kinds_of_seeds", "seed_region = \"nidus\"", "seed_region = \"nidus\"\nseed_part = \"wall\"",
              "scene.toml:56:13: solidify 'clot' has both a seed_part and fluid seeds\n"
              "  leave out seed_part, or write a [[solidify]] for each"},
        Fault{"seeds_of_a_liquid", "seed_region = \"nidus\"", "seed_part = \"blood\"",
              "scene.toml:55:13: seed_part of solidify 'clot': part 'blood' is of kind 'fluid', expected a rigid or "
              "elastic solid\n"
              "  the scene has 'wall' and 'leaflets'"},
        Fault{"region_that_is_not", "seed_region = \"nidus\"", "seed_region = \"nidos\"",
              "scene.toml:55:15: seed_region of solidify 'clot': the scene has no region 'nidos'\n"
              "  did you mean 'nidus'?"},
        Fault{"residence_nowhere", "seed_region = \"nidus\"", "seed_region = \"nidus\"\nresidence_above = \"1 s\"",
              "scene.toml:56:19: residence_above of solidify 'clot' is a time in a region, and there is no region\n"
              "  add region, the name of a [[region]]"},
        Fault{"one_in_how_many", "probability = 0.25", "probability = 0.25\nactive = \"one_in\"",
              "scene.toml:58:10: solidify 'clot': active = \"one_in\" needs the number one_in\n"
              "  add one_in = 10, for example"},
        Fault{"one_in_of_always", "probability = 0.25", "probability = 0.25\none_in = 3",
              "scene.toml:58:10: solidify 'clot': one_in needs active = \"one_in\", and active is \"always\"\n"
              "  write active = \"one_in\", or leave one_in out"},
        Fault{"until_before_from", "probability = 0.25", "probability = 0.25\nfrom = \"2 s\"\nuntil = \"1 s\"",
              "scene.toml:59:9: solidify 'clot': until is not after from, its first event: nothing would turn solid\n"
              "  end later, or leave until out"},
        Fault{"species_beside_it", "[[region]]",
              "[[species]]\nname = \"oxygen\"\ndiffusivity = \"1e-9 m^2/s\"\n[[region]]",
              "scene.toml:56:8: solidify 'clot': the scene has [[species]], which would be lost from fluid that "
              "solidifies\n"
              "  species in aggregates are not supported yet: leave out [[solidify]] or [[species]]"},
        Fault{"break_of_nothing", "part = \"clot\"", "part = \"wall\"",
              "scene.toml:63:8: part of break 'tear': part 'wall' is of kind 'rigid', expected an elastic solid or a "
              "[[solidify]]\n"
              "  the scene has 'leaflets' and 'clot'"},
        Fault{"two_limits", "force_above = \"1 mN\"", "force_above = \"1 mN\"\nstrain_above = 0.1",
              "scene.toml:65:16: break 'tear' has two limits\n"
              "  give force_above or strain_above"},
        Fault{"no_limit", "force_above = \"1 mN\"\n", "",
              "scene.toml:62:8: break 'tear' has no limit: nothing would ever break\n"
              "  give force_above or strain_above"},
        Fault{
            "mean_of_what_changes", "every = \"20 ms\"", "every = \"20 ms\"\nsolid_fields = ['mean_displacement']",
            "scene.toml:54:8: output.solid_fields or a measure asks for mean_displacement, which is not available with "
            "[[solidify]] or [[break]]\n"
            "  leave mean_displacement out"},
        Fault{"aggregate_of_a_wall", "[[break]]",
              "[[measure]]\nname = \"size\"\nkind = \"aggregate\"\npart = \"wall\"\n\n[[break]]",
              "scene.toml:64:8: part of measure 'size': part 'wall' is of kind 'rigid', expected an elastic solid or a "
              "[[solidify]]\n"
              "  the scene has 'leaflets' and 'clot'"}}),
    name_of);

}  // namespace
}  // namespace dmp::tests::scene_solidify_tests
