// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Numerical methods that exclude each other, or that a scene's scheme does not support.
#include "tests/modules.hpp"
#include "tests/unit/scene/fault.hpp"

namespace dmp::tests::scene_numerics_errors_tests {
namespace {

class BadNumerics : public testing::TestWithParam<Fault> {};

TEST_P(BadNumerics, says_where_what_and_what_to_do) {
    EXPECT_EQ(fault_of(scene_with(GetParam().found, GetParam().replacement)), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Scene, BadNumerics,
    testing::ValuesIn(std::vector<Fault>{
        Fault{"implicit_viscosity_and_subcycled_springs", "[run]",
              "[numerics]\nviscosity_stepping = \"implicit\"\nspring_stepping = \"subcycled\"\n[run]",
              "scene.toml:32:19: numerics.viscosity_stepping = \"implicit\" solves for fluid and elastic solids "
              "together; numerics.spring_stepping = \"subcycled\" integrates the solids separately\n"
              "  write spring_stepping = \"implicit\""},
        Fault{"implicit_viscosity_of_approaching_pairs", "[run]",
              "[numerics]\nviscosity_stepping = \"implicit\"\nviscous_law = \"monaghan_approaching\"\n[run]",
              "scene.toml:32:15: numerics.viscosity_stepping = \"implicit\" needs a force that is linear in the "
              "velocities; numerics.viscous_law = \"monaghan_approaching\" is not\n"
              "  write viscous_law = \"morris\", \"monaghan\", \"cleary\" or \"newtonian\""},
        Fault{"implicit_viscosity_of_approaching_pairs_in_the_plain_scheme", "[run]",
              "[numerics]\nscheme = \"plain\"\nviscosity_stepping = \"implicit\"\n"
              "viscous_law = \"monaghan_approaching\"\n[run]",
              "scene.toml:33:15: numerics.viscosity_stepping = \"implicit\" needs a force that is linear in the "
              "velocities; numerics.viscous_law = \"monaghan_approaching\" is not\n"
              "  write viscous_law = \"morris\", \"monaghan\" or \"cleary\""},
        Fault{"diffusion_of_a_summed_density", "[run]",
              "[numerics]\nscheme = \"plain\"\ndensity = \"summation\"\ndensity_diffusion = 0.1\n[run]",
              "scene.toml:33:21: numerics.density_diffusion smooths an integrated density; numerics.density = "
              "\"summation\" does not integrate it\n"
              "  leave density_diffusion out, or write density = \"continuity\""},
        Fault{"shifting_and_transport", "[run]",
              "[numerics]\nscheme = \"plain\"\ntransport_velocity = true\nshifting = 4\n[run]",
              "scene.toml:33:12: numerics.shifting and numerics.transport_velocity both spread the particles\n"
              "  leave one of them out"},
        Fault{"summation_beside_plain_walls", "[run]",
              "[numerics]\nscheme = \"plain\"\ndensity = \"summation\"\nwalls = \"plain\"\n[run]",
              "scene.toml:33:9: numerics.walls = \"plain\" integrates the density of wall particles, which "
              "numerics.density = \"summation\" does not support\n"
              "  leave walls out, or density"},
        Fault{"correction_beside_plain_walls", "[run]",
              "[numerics]\nscheme = \"plain\"\ngradient_correction = true\nwalls = \"plain\"\n[run]",
              "scene.toml:33:9: numerics.walls = \"plain\" integrates the density of wall particles, which "
              "numerics.gradient_correction = true does not support\n"
              "  leave walls out, or gradient_correction"},
        Fault{"corrected_scheme_of_a_liquid_and_a_gas", "[run]",
              "[[part]]\nname = \"air\"\nkind = \"fluid\"\ndensity = \"1 kg/m^3\"\nviscosity = \"0.02 mPa*s\"\n[run]",
              "scene.toml:33:11: 'blood' is more than 10 times as dense as 'air': numerics.scheme = \"corrected\" is "
              "unstable there\n"
              "  give it a density within ten times of the other's"},
        Fault{"corrected_scheme_of_a_summed_density", "[run]",
              "[numerics]\nscheme = \"corrected\"\ndensity = \"summation\"\n[run]",
              "scene.toml:32:11: numerics.scheme = \"corrected\" does not support numerics.density = \"summation\"\n"
              "  leave it out, or write scheme = \"plain\""},
        Fault{"corrected_scheme_beside_plain_walls", "[run]",
              "[numerics]\nscheme = \"corrected\"\nwalls = \"plain\"\n[run]",
              "scene.toml:32:9: numerics.scheme = \"corrected\" does not support numerics.walls = \"plain\"\n"
              "  leave it out, or write scheme = \"plain\""},
        Fault{"corrected_scheme_and_transport_velocity", "[run]",
              "[numerics]\nscheme = \"corrected\"\ntransport_velocity = true\n[run]",
              "scene.toml:32:22: numerics.scheme = \"corrected\" does not support numerics.transport_velocity = true\n"
              "  leave it out, or write scheme = \"plain\""},
        Fault{"corrected_scheme_corrected_twice", "[run]",
              "[numerics]\nscheme = \"corrected\"\ngradient_correction = true\n[run]",
              "scene.toml:32:23: numerics.scheme = \"corrected\" does not support numerics.gradient_correction = true\n"
              "  leave it out, or write scheme = \"plain\""},
        Fault{"corrected_scheme_and_a_long_repulsion", "[run]",
              "[contact]\nrange = 0.9\n[numerics]\nscheme = \"corrected\"\n[run]",
              "scene.toml:31:9: contact.range = 0.9 is within reach of the fluid that numerics.scheme = \"corrected\" "
              "keeps evenly spread: shifting would press it into the repulsion of elastic solids, step by step\n"
              "  leave range out: it is then 0.7"},
        Fault{"corrected_scheme_of_another_kernel", "[run]",
              "[numerics]\nscheme = \"corrected\"\nkernel = \"lucy\"\n[run]",
              "scene.toml:32:10: numerics.scheme = \"corrected\" does not support numerics.kernel = \"lucy\"\n"
              "  leave it out, or write scheme = \"plain\""},
        Fault{"corrected_scheme_of_a_small_support", "[run]",
              "[numerics]\nscheme = \"corrected\"\nsupport = 2.5\n[run]",
              "scene.toml:32:11: numerics.scheme = \"corrected\" does not support numerics.support = 2.5, below 2.8\n"
              "  leave it out, or write scheme = \"plain\""},
        Fault{"newtonian_law_of_the_plain_scheme", "[run]",
              "[numerics]\nscheme = \"plain\"\nviscous_law = \"newtonian\"\n[run]",
              "scene.toml:32:15: numerics.scheme = \"plain\" does not support numerics.viscous_law = \"newtonian\"\n"
              "  leave it out, or write scheme = \"corrected\""}}),
    name_of);

// The advice in both messages above is to be right for every law, also for one that is added.
TEST(ImplicitViscosity, takes_the_laws_that_its_advice_names_and_no_other) {
    for (const std::string scheme : {"corrected", "plain"}) {
        const auto fault = [&](const std::string& law) {
            return fault_of(scene_with("[run]", "[numerics]\nscheme = \"" + scheme +
                                                    "\"\nviscosity_stepping = \"implicit\"\nviscous_law = \"" + law +
                                                    "\"\n[run]"));
        };
        const std::string refused = fault("monaghan_approaching");
        const std::string advice = refused.substr(refused.find("\n  write viscous_law"));
        for (const models::LawFacts& law : models::ViscousLaws::facts()) {
            const std::string key(law.key);
            EXPECT_EQ(fault(key) == "no error", advice.find('"' + key + '"') != std::string::npos)
                << scheme << " " << key;
        }
    }
}

}  // namespace
}  // namespace dmp::tests::scene_numerics_errors_tests
