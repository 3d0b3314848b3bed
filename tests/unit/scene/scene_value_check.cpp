// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Values of single keys, checked without reading a scene anew.
#include <gtest/gtest.h>

#include "scene/formula.hpp"
#include "scene/value_check.hpp"
#include "tests/modules.hpp"
#include "tests/unit/scene/scene_text.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::value_check_tests {
namespace {

/// What is wrong with a value; "" if nothing is.
std::string fault(const std::string& key, const std::string& value) {
    const SourceLocation location{"study.toml", 7, 3};
    try {
        ValueCheck(read_text(good_scene), key, location)(parse_toml_value(value, location));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(ValueCheck, PassesWhatASceneTakes) {
    EXPECT_EQ(fault("particles.spacing", "\"0.2 mm\""), "");
    EXPECT_EQ(fault("particles.arrangement", "\"hexagonal\""), "");
    EXPECT_EQ(fault("part.leaflets.bending_stiffness", "\"1e-6 N*m^2\""), "");
    EXPECT_EQ(fault("geometry.parameters.width", "\"2 mm\""), "");
    EXPECT_EQ(fault("quality", "\"fine\""), "");
    EXPECT_EQ(fault("measure.flux_in.to", "[\"1 mm\", 0]"), "");
}

TEST(ValueCheck, RefusesWhatASceneRefuses) {
    EXPECT_EQ(fault("particles.spacing", "\"3 s\""),
              "study.toml:7:3: particles.spacing: found \"3 s\" (time), expected a length such as \"0.1 mm\"\n"
              "  give a length for spacing");
    EXPECT_EQ(fault("particles.spacing", "\"0 mm\""),
              "study.toml:7:3: particles.spacing: found \"0 mm\", expected more than 0\n"
              "  give a value that is more than 0");
    EXPECT_EQ(fault("geometry.parameters.width", "\"2 s\"").substr(0, 45),
              "study.toml:7:3: geometry.parameters.width: fo");
}

TEST(ValueCheck, RefusesKeysThatTheSceneDoesNotHave) {
    EXPECT_EQ(fault("particles.spcing", "1"),
              "study.toml:7:3: unknown key 'particles.spcing'\n  did you mean 'spacing' in [particles]?");
    EXPECT_EQ(fault("part.leaflet.density", "1"),
              "study.toml:7:3: the scene has no part 'leaflet'\n  did you mean 'leaflets'?");
    EXPECT_EQ(fault("part.density", "1"),
              "study.toml:7:3: 'part.density' does not say which part and which of its keys\n"
              "  write part.NAME.KEY=VALUE");
    EXPECT_EQ(fault("part.wall.viscosity", "1").substr(0, 78),
              "study.toml:7:3: 'viscosity' does not apply to the part 'wall' of kind 'rigid'\n");
}

TEST(ConstantFormula, HasAnyDimension) {
    const Quantity energy = constant_formula({"2 N * (3 mm + 1 m)", {}, {}}, "level");
    EXPECT_DOUBLE_EQ(energy.si, 2.006);
    EXPECT_EQ(energy.dimension.name(), "energy");
    EXPECT_DOUBLE_EQ(constant_formula({"sqrt(4) + 1", {}, {}}, "level").si, 3);
}

TEST(ConstantFormula, RefusesVariablesAndWhatIsNoNumber) {
    const auto fault_in = [](const std::string& text) {
        return text_thrown<InputError>([&] {
            static_cast<void>(constant_formula({text, {"study.toml", 3, 4}, {}}, "level"));
        });
    };
    EXPECT_EQ(fault_in("2 m * sin(t / 1 s)"),
              "study.toml:3:4: level: \"2 m * sin(t / 1 s)\" depends on t, x, y or z\n  give a formula of numbers");
    EXPECT_EQ(fault_in("1 / 0"),
              "study.toml:3:4: level: \"1 / 0\" is no finite number\n"
              "  check for a division by zero, or a root or logarithm of a negative number");
}

}  // namespace
}  // namespace dmp::tests::value_check_tests
