// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "scene/quantity.hpp"
#include "scene/read_scene.hpp"
#include "scene/units.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::scene_units_tests {
namespace {

Dimension dimension_of(const std::string& unit) { return Expected("1 " + unit).dimension(); }

std::string message_for(const std::string& text, const std::string& unit) {
    try {
        read_quantity(text, unit, {"--until", 0, 0});
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

struct Sample {
    const char* text;
    const char* unit;
    double si;
};

class QuantityValue : public testing::TestWithParam<Sample> {};

TEST_P(QuantityValue, is_the_double_nearest_to_the_decimal_value) {
    EXPECT_EQ(read_quantity(GetParam().text, GetParam().unit), GetParam().si);
}

// every value is written as a decimal literal: one rounding, no drift through a factor
INSTANTIATE_TEST_SUITE_P(
    Units, QuantityValue,
    testing::Values(Sample{"0.2 mm", "m", 0.0002}, Sample{"3.5 mPa*s", "Pa*s", 0.0035},
                    Sample{"1056 kg/m^3", "kg/m^3", 1056}, Sample{"9.81 m/s^2", "m/s^2", 9.81},
                    Sample{"3e-6 N*m^2", "N*m^2", 3e-6}, Sample{"2.5 J", "N*m", 2.5}, Sample{"7 um", "m", 7e-6},
                    Sample{"7 \u00B5m", "m", 7e-6}, Sample{"7 \u03BCm", "m", 7e-6}, Sample{"50 Hz", "1/s", 50},
                    Sample{"50 1/s", "Hz", 50}, Sample{"50 s^-1", "Hz", 50}, Sample{"40 ms", "s", 0.04},
                    Sample{"2 min", "s", 120}, Sample{"1.5 h", "s", 5400}, Sample{"1 d", "s", 86400},
                    Sample{"5 g", "kg", 0.005}, Sample{"3 mg/mm^3", "kg/m^3", 3000}, Sample{"1 g/cm^3", "kg/m^3", 1000},
                    Sample{"1 bar", "Pa", 1e5}, Sample{"10 mmHg", "Pa", 1333.22387415}, Sample{"4 cP", "Pa*s", 0.004},
                    Sample{"-40 mm", "m", -0.04}, Sample{"+ 4.e-1 mm", "m", 0.0004}, Sample{".5 km", "m", 500},
                    Sample{"  2 m ", "m", 2}, Sample{"2m", "m", 2}, Sample{"0.5", "1", 0.5}, Sample{"0.5 1", "1", 0.5},
                    Sample{"0", "m", 0}, Sample{"3 kg * m / s^2", "N", 3}, Sample{"1 J/kg/K", "m^2/s^2/K", 1},
                    Sample{"2 dam", "m", 20}, Sample{"1 cd", "cd", 1}, Sample{"3 mol/L", "mol/m^3", 3000},
                    Sample{"2 rad", "1", 2}));

TEST(Quantity, degrees_become_radians) {
    EXPECT_DOUBLE_EQ(read_quantity("90 deg", "rad"), std::numbers::pi / 2);
    EXPECT_DOUBLE_EQ(read_quantity("180 deg", "1"), std::numbers::pi);
}

TEST(Quantity, volume_flow_per_minute) { EXPECT_DOUBLE_EQ(read_quantity("60 L/min", "m^3/s"), 1e-3); }

TEST(Units, whole_symbols_go_before_a_prefix) {
    EXPECT_EQ(unit_symbol("min")->dimension, dimension_of("s"));
    EXPECT_EQ(unit_symbol("Pa")->dimension, dimension_of("N/m^2"));
    EXPECT_EQ(unit_symbol("cd")->power_of_ten, 0);
    EXPECT_FALSE(unit_symbol("kmin"));
    EXPECT_FALSE(unit_symbol("mdeg"));
    EXPECT_FALSE(unit_symbol("x"));
    EXPECT_FALSE(unit_symbol(""));
}

TEST(Dimension, has_a_name_and_an_si_unit_that_reads_back) {
    EXPECT_EQ(dimension_of("mm").name(), "length");
    EXPECT_EQ(dimension_of("N*m^2").name(), "bending stiffness");
    EXPECT_EQ(dimension_of("N*m").name_with_article(), "an energy");
    EXPECT_EQ(dimension_of("m^3/kg").name_with_article(), "a quantity in m^3/kg");
    for (const std::string unit : {"N", "J", "W", "Pa", "Pa/m", "Pa*s", "N/m", "N*m^2", "1/s", "kg/m^3", "1/m^2/s", "V",
                                   "mol/L", "K", "cd", "A"}) {
        EXPECT_EQ(dimension_of(dimension_of(unit).si_unit()), dimension_of(unit)) << unit;
    }
    EXPECT_EQ(dimension_of("1/m/s").si_unit(), "m^-1*s^-1");
    EXPECT_EQ(dimension_of("J").si_unit(), "J");
    EXPECT_EQ(dimension_of("kg*m/s^2").si_unit(), "N");
    EXPECT_EQ(dimension_of("N*m^2").si_unit(), "N*m^2");
    EXPECT_EQ(dimension_of("J*m").si_unit(), "N*m^2");
    EXPECT_EQ(dimension_of("J/K").si_unit(), "m^2*kg/s^2/K");
    EXPECT_EQ(dimension_of("m").to_the(0.5)->si_unit(), "m^0.5");
    EXPECT_EQ(dimension_of("1/m").to_the(1.5)->si_unit(), "m^-1.5");
    EXPECT_FALSE(dimension_of("m").to_the(0.25));
    EXPECT_FALSE(dimension_of("m").to_the(1.0 / 3));
}

TEST(ExactText, reads_back_bit_for_bit) {
    for (const double value : {0.1, 1.0 / 3, 1e-300, 6.02214076e23, 0.0, -2.5, 1056.0}) {
        EXPECT_EQ(std::stod(exact_text(value)), value);
    }
}

TEST(QuantityError, missing_unit_may_be_the_example_s_or_that_without_a_prefix) {
    EXPECT_THAT(message_for("0.0035", "mPa*s"),
                testing::HasSubstr(R"(write "0.0035 mPa*s" or "0.0035 Pa*s", with the unit you mean)"));
    EXPECT_THAT(message_for("3", "1/ms"), testing::HasSubstr(R"(write "3 1/ms" or "3 1/s", with)"));
    EXPECT_THAT(message_for("3", "kg/m^3"), testing::HasSubstr(R"(write "3 kg/m^3", with)"));
    EXPECT_THAT(message_for("3", "mm^2/s"), testing::HasSubstr(R"(write "3 mm^2/s" or "3 m^2/s", with)"));
}

TEST(QuantityError, missing_unit) {
    EXPECT_EQ(
        message_for("3", "s"),
        "--until: missing unit: found 3, expected a time such as \"1 s\"\n  write \"3 s\", with the unit you mean");
    EXPECT_EQ(
        message_for("-3", "s"),
        "--until: missing unit: found -3, expected a time such as \"1 s\"\n  write \"-3 s\", with the unit you mean");
}

TEST(QuantityError, wrong_dimension_names_both) {
    EXPECT_EQ(message_for("3 s", "mm"),
              "--until: found \"3 s\" (time), expected a length such as \"1 mm\"\n  give a length");
    EXPECT_EQ(message_for("3 m^3/kg", "J"),
              "--until: found \"3 m^3/kg\" (m^3/kg), expected an energy such as \"1 J\"\n  give an energy");
    EXPECT_EQ(message_for("0 s", "m"),
              "--until: found \"0 s\" (time), expected a length such as \"1 m\"\n  give a length");
}

TEST(QuantityError, unknown_units_name_the_nearest) {
    EXPECT_EQ(message_for("3 mmm", "m"), "--until: unknown unit 'mmm' in \"3 mmm\"\n  did you mean 'mm'?");
    EXPECT_EQ(message_for("3 MMHG", "Pa"), "--until: unknown unit 'MMHG' in \"3 MMHG\"\n  did you mean 'mmHg'?");
    EXPECT_EQ(
        message_for("3 kg/foot", "kg"),
        "--until: unknown unit 'foot' in \"3 kg/foot\"\n  units are written like m/s^2, mPa*s or J/kg/K, with the "
        "SI symbols and prefixes");
}

TEST(QuantityError, faults_of_form) {
    EXPECT_EQ(message_for("fast", "m/s"),
              "--until: expected a number in \"fast\"\n  write a number and its unit, such as \"0.1 mm\"");
    EXPECT_EQ(message_for("mm", "m"),
              "--until: found the unit \"mm\" without a number\n  write a number before it, such as \"1 mm\"");
    EXPECT_EQ(message_for("", "m"),
              "--until: expected a number in \"\"\n  write a number and its unit, such as \"0.1 mm\"");
    EXPECT_EQ(
        message_for("3 mPa s", "Pa*s"),
        "--until: unexpected 's' in \"3 mPa s\"\n  join units with * or /: units are written like m/s^2, mPa*s or "
        "J/kg/K");
    EXPECT_EQ(message_for("3 m/(s)", "m/s"),
              "--until: unexpected '(' in \"3 m/(s)\"\n  units are written like m/s^2, mPa*s or J/kg/K");
    EXPECT_EQ(message_for("3 m/", "m"),
              "--until: unexpected end in \"3 m/\"\n  units are written like m/s^2, mPa*s or J/kg/K");
    EXPECT_EQ(
        message_for("3 m^0.5", "m"),
        "--until: the exponent of the unit 'm' is not a whole number up to 20\n  write a whole number such as m^2; "
        "to raise a quantity to a power put it in parentheses, such as (2 m)^0.5");
    EXPECT_EQ(
        message_for("1e400 m", "m"),
        "--until: the number 1e400 is too large or too small for this machine\n  check its exponent and its unit");
    EXPECT_EQ(message_for("3 1 m", "m"),
              "--until: unexpected 'm' in \"3 1 m\"\n  join units with * or /: units are written like m/s^2, mPa*s or "
              "J/kg/K");
}

TEST(QuantityError, points_into_the_text) {
    const WrittenText text{"\u00B5 3 mmm", {"scene.toml", 4, 11}, {"scene.toml", 4, 12}};
    EXPECT_EQ(text.at(3).column, 14) << "the micro sign is two bytes and one column";
    const WrittenText lines{"ab\ncd", {"scene.toml", 4, 11}, {"scene.toml", 5, 1}};
    EXPECT_EQ(lines.at(4).text(), "scene.toml:6:2");
    try {
        parse_quantity({"0.1  mn", {"scene.toml", 4, 11}, {"scene.toml", 4, 12}});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.where().text(), "scene.toml:4:17");
    }
}

}  // namespace
}  // namespace dmp::tests::scene_units_tests
