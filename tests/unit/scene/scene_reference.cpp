// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "scene/read_scene.hpp"
#include "scene/schema.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::scene_reference_tests {
namespace {

using testing::HasSubstr;

std::string fault_of(const std::string& key) {
    try {
        explain_key(key);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(ExplainKey, a_required_quantity) {
    EXPECT_EQ(explain_key("run.duration"),
              "run.duration\n"
              "    Simulated time.\n"
              "    type:    a time such as \"4 s\", more than 0\n"
              "    default: none, it must be given\n");
}

TEST(ExplainKey, a_word_with_a_default) {
    EXPECT_EQ(
        explain_key("numerics.kernel"),
        "numerics.kernel\n"
        "    Smoothing kernel.\n"
        "    type:    one of 'wendland_c2', 'wendland_c4', 'lucy', 'cubic_spline' and 'quintic_spline'\n"
        "    default: \"wendland_c2\"; scheme = \"plain\": \"wendland_c2\" (draft: \"lucy\", fine: \"wendland_c2\")\n");
}

TEST(ExplainKey, a_key_of_parts_by_pattern_by_name_and_without) {
    const std::string text =
        "part.*.density\n"
        "    Density at rest.\n"
        "    type:    a density such as \"1000 kg/m^3\", more than 0\n"
        "    default: none, it must be given\n"
        "    only for fluid parts\n"
        "\n"
        "part.*.density\n"
        "    Density of the material, in 3-D and for an area in 2-D; a strip (a curve in 2-D) takes mass_per_length "
        "instead.\n"
        "    type:    a density such as \"1100 kg/m^3\", more than 0\n"
        "    default: none\n"
        "    only for elastic parts\n"
        "\n"
        "part.*.density\n"
        "    Density of the spheres; or give mass.\n"
        "    type:    a density such as \"2500 kg/m^3\", more than 0\n"
        "    default: none\n"
        "    only for spheres parts\n";
    EXPECT_EQ(explain_key("part.*.density"), text);
    EXPECT_EQ(explain_key("part.blood.density"), text);
    EXPECT_EQ(explain_key("part.density"), text);
}

TEST(ExplainKey, a_key_that_differs_between_kinds) {
    EXPECT_EQ(
        explain_key("part.layers"),
        "part.*.layers\n"
        "    Rows of wall particles; the wall must be as thick as the kernel's support.\n"
        "    type:    a whole number, at least 1\n"
        "    default: 3 (draft: 3, fine: 4)\n"
        "    only for rigid parts\n"
        "\n"
        "part.*.layers\n"
        "    Rows of particles of strips and shells; thicker strips have more, by their thickness. May be left out.\n"
        "    type:    a whole number, only 2\n"
        "    default: 2\n"
        "    only for elastic parts\n");
}

TEST(ExplainKey, a_whole_table) {
    EXPECT_THAT(explain_key("run"), HasSubstr("run.duration\n"));
    EXPECT_THAT(explain_key("run"), HasSubstr("run.threads\n"));
    EXPECT_THAT(explain_key("part"), HasSubstr("part.*.anchor\n"));
    EXPECT_EQ(explain_key("geometry.parameters.width"), explain_key("geometry.parameters"));
}

TEST(ExplainKey, near_misses) {
    EXPECT_EQ(fault_of("particle.spacing"), "unknown key 'particle.spacing'\n  did you mean 'particles.spacing'?");
    EXPECT_EQ(fault_of("spacing"), "unknown key 'spacing'\n  did you mean 'particles.spacing'?");
    EXPECT_EQ(fault_of("part.blood.densty"), "unknown key 'part.blood.densty'\n  did you mean 'part.*.density'?");
    EXPECT_EQ(fault_of("run.zzz"), "unknown key 'run.zzz'\n  [run] takes 'duration', 'threads' and 'until_steady'");
    EXPECT_EQ(fault_of("zzz"),
              "unknown key 'zzz'\n  a scene has 'schema', 'title', 'dimension' and 'quality' and the tables "
              "[geometry], [[select]], [particles], "
              "[[part]], [[join]], [[contact_pair]], [box], [flow], [contact], [numerics], [run], [output], "
              "[[species]], [[force]], "
              "[[moving_shape]], [[region]], [[measure]], [[reference]], [[solidify]], [[break]]");
}

TEST(SceneReference, has_one_line_a_key_in_the_order_of_a_scene) {
    const std::string text = scene_reference();
    const auto facts = schema().facts();
    EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), facts.size() + 2);
    std::size_t at = 0;
    for (const auto& key : facts) {
        at = text.find("\n| `" + key.path + "` | ", at);
        ASSERT_NE(at, std::string::npos) << key.path;
        ++at;
        EXPECT_FALSE(key.meaning.empty()) << key.path;
    }
    EXPECT_THAT(text,
                HasSubstr("| `part.*.viscosity` | a dynamic viscosity such as \"1 mPa*s\", at least 0 | required | "
                          "Dynamic viscosity. Only for fluid parts. |\n"));
    EXPECT_THAT(
        text,
        HasSubstr(
            "| `output.solid_fields` | a list of any of 'velocity', 'displacement', 'mean_displacement', 'stress', "
            "'von_mises', 'strain', 'force', 'surface_stress', 'principal_stretches' and 'traction' | "
            "[\"velocity\", \"displacement\", \"stress\", \"von_mises\", \"strain\", \"force\"] | Fields of elastic "
            "solids in the frames; strain and force are per bond, surface_stress is the largest von Mises stress "
            "at the surface of a cell, traction that of the fluid on each face (docs/results.md). |\n"));
}

/// The page in the docs; with DMP_UPDATE_DOCS set it is written first.
void expect_in_docs(const std::string& page, const std::string& text) {
    const std::string file = DMP_SOURCE_DIR "/docs/scene/" + page + ".md";
    if (std::getenv("DMP_UPDATE_DOCS") != nullptr) std::ofstream(file) << text;
    std::ifstream stream(file);
    const std::string found{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    EXPECT_EQ(found, text) << file << " is out of date: DMP_UPDATE_DOCS=1 ./dmp test --filter SceneReference writes it";
}

TEST(SceneReference, pages_in_the_docs_are_those_of_the_keys) {
    expect_in_docs("index", reference_index());
    std::string all;
    for (const std::string& table : reference_tables()) {
        expect_in_docs(table, reference_page(table));
        all += reference_page(table);
    }
    for (const KeyFacts& key : schema().facts()) EXPECT_THAT(all, HasSubstr("| `" + key.path + "` |"));
    EXPECT_THROW((void)reference_page("accuracy"), std::out_of_range);
}

}  // namespace
}  // namespace dmp::tests::scene_reference_tests
