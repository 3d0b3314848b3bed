// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "scene/formula.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::scene_expressions_tests {
namespace {

constexpr double pi = std::numbers::pi;

/// The formula as if it stood in scene.toml:12:17, quotes included.
Expression formula(const std::string& text, const std::string& example) {
    return read_formula({text, {"scene.toml", 12, 17}, {"scene.toml", 12, 18}}, Expected(example), "flow.acceleration");
}

Expression number(const std::string& text) { return formula(text, "1 1"); }

std::string message_for(const std::string& text, const std::string& example = "0.1 m/s^2") {
    try {
        formula(text, example);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Expression, default_is_zero) {
    const Expression zero;
    EXPECT_EQ(zero(1, 2, 3, 4), 0);
    EXPECT_EQ(zero.text(), "0");
    EXPECT_FALSE(zero.depends_on_time());
    EXPECT_FALSE(zero.depends_on_position());
}

TEST(Expression, takes_a_plain_formula) {
    const Expression f("2*t+x", "2*t + x");
    EXPECT_EQ(f(3, 4), 10);
    EXPECT_EQ(f.text(), "2*t + x");
    EXPECT_EQ(f.si_text(), "2*t + x");
    EXPECT_THROW(Expression("2*", "2*"), std::invalid_argument);
    EXPECT_THROW(Expression("2*unknown", ""), std::invalid_argument);
}

TEST(Expression, tells_what_it_depends_on) {
    EXPECT_TRUE(number("t / 1 s").depends_on_time());
    EXPECT_FALSE(number("t / 1 s").depends_on_position());
    EXPECT_TRUE(number("y / 1 m").depends_on_position());
    EXPECT_FALSE(number("y / 1 m").depends_on_time());
    EXPECT_FALSE(number("2").depends_on_time());
}

TEST(Expression, knows_the_present_place_and_that_in_the_initial_state) {
    const Expression f = read_formula({"100*X + 10*Y + Z + x/10 + y/100 + z/1000", {}, {}}, Expected("1 m"), "force",
                                      PlacesKnown::now_and_at_start);
    EXPECT_DOUBLE_EQ(f.at(0, Vec(1, 2, 3), Vec(4, 5, 6)), 456.123);
    EXPECT_DOUBLE_EQ(f(0, 1, 2, 3), 123.123) << "in the initial state";
    EXPECT_TRUE(f.depends_on_position());
    EXPECT_TRUE(f.depends_on_initial_position());
    EXPECT_TRUE(f.depends_on("Z"));
    EXPECT_FALSE(f.depends_on_time());
    const Expression of_place = read_formula({"Y", {}, {}}, Expected("1 m"), "force", PlacesKnown::now_and_at_start);
    EXPECT_FALSE(of_place.depends_on_position());
    EXPECT_FALSE(of_place.depends_on("X"));
    EXPECT_FALSE(of_place.is_zero());
    EXPECT_FALSE(number("x / 1 m").depends_on_initial_position());
    EXPECT_EQ(
        message_for("0.1 m/s^2 * X / 1 m"),
        "scene.toml:12:30: 'X' is a place in the initial state, which only a [[force]] knows in \"0.1 m/s^2 * X / "
        "1 m\"\n  write x, y or z for the present place, or leave it out");
}

TEST(Expression, copies_and_moves_are_independent) {
    Expression first = number("sin(t / 1 s)");
    const Expression copy = first;
    Expression assigned;
    assigned = first;
    const Expression moved = std::move(first);
    EXPECT_EQ(copy(0.5), std::sin(0.5));
    EXPECT_EQ(assigned(0.25), std::sin(0.25));
    EXPECT_EQ(moved(0.75), std::sin(0.75));
    EXPECT_EQ(copy.text(), "sin(t / 1 s)");
}

TEST(Formula, the_drive_of_the_valve) {
    const auto drive = formula("0.15 m/s^2 * sin(2*pi*t / 4 s)", "0.1 m/s^2");
    for (const double t : {0.0, 0.3, 1.0, 3.7}) EXPECT_DOUBLE_EQ(drive(t), 0.15 * std::sin(2 * pi * t / 4));
    EXPECT_EQ(drive.text(), "0.15 m/s^2 * sin(2*pi*t / 4 s)");
    EXPECT_EQ(drive.si_text(), "((0.15 m/s^2)*sin((((2*pi)*t)/(4 s))))");
}

TEST(Formula, the_same_in_other_units_is_the_same) {
    const auto a = formula("0.15 m/s^2 * sin(2*pi*t / 4 s)", "0.1 m/s^2");
    const auto b = formula("150 mm/s^2*sin( 2*pi*t/4000 ms )", "0.1 m/s^2");
    EXPECT_EQ(a.si_text(), b.si_text());
    EXPECT_EQ(formula(a.si_text(), "0.1 m/s^2").si_text(), a.si_text());
}

TEST(Formula, a_unit_is_read_greedily_after_a_number) {
    EXPECT_DOUBLE_EQ(number("3 min / 1 s")(0), 180);
    EXPECT_DOUBLE_EQ(number("min(3, 2) * 1 m / 1 m")(0), 2);
    EXPECT_DOUBLE_EQ(formula("2 m * min(3, 2)", "1 m")(0), 4) << "a name before '(' is no unit";
    EXPECT_DOUBLE_EQ(formula("1 m / s * t", "1 m")(5), 5) << "t is the time, not a unit";
    EXPECT_DOUBLE_EQ(formula("1 m/s*s/s^2*s*2", "1 m/s")(0), 2);
    EXPECT_DOUBLE_EQ(formula("1 N*m^2 / 2 m", "1 N*m")(0), 0.5);
    EXPECT_DOUBLE_EQ(formula("1 m / 2 s", "1 m/s")(0), 0.5);
    EXPECT_DOUBLE_EQ(formula("1 m * x", "1 m^2")(0, 3), 3);
    EXPECT_DOUBLE_EQ(number("4*t/4 s")(2), 2);
    EXPECT_DOUBLE_EQ(number("1 s^-1 * t")(2), 2);
    EXPECT_DOUBLE_EQ(number("30 deg * 6 / pi")(0), 1);
}

TEST(Formula, operators_bind_as_usual) {
    EXPECT_EQ(number("1 + 2 * 3")(0), 7);
    EXPECT_EQ(number("10 - 4 - 3")(0), 3);
    EXPECT_EQ(number("16 / 4 / 2")(0), 2);
    EXPECT_EQ(number("2 ^ 3 ^ 2")(0), 512);
    EXPECT_EQ(number("-2 ^ 2")(0), -4);
    EXPECT_EQ(number("2 ^ -1")(0), 0.5);
    EXPECT_EQ(number("2 * -3")(0), -6);
    EXPECT_EQ(number("--3 + +1")(0), 4);
    EXPECT_EQ(number("(1 + 2) * 3")(0), 9);
    EXPECT_EQ(number("1 < 2 && 3 < 2 || 1 == 1")(0), 1);
    EXPECT_EQ(number("1 != 1 || 2 >= 3 || 2 <= 1 || 1 > 2")(0), 0);
    EXPECT_EQ(number("1 > 2 ? 3 : 2 > 1 ? 4 : 5")(0), 4);
}

TEST(Formula, functions) {
    EXPECT_DOUBLE_EQ(number("cos(1)+tan(1)+asin(0.5)+acos(0.5)+atan(1)")(0),
                     std::cos(1) + std::tan(1) + std::asin(0.5) + std::acos(0.5) + std::atan(1));
    EXPECT_DOUBLE_EQ(number("sinh(1)+cosh(1)+tanh(1)+asinh(1)+acosh(2)+atanh(0.5)")(0),
                     std::sinh(1) + std::cosh(1) + std::tanh(1) + std::asinh(1) + std::acosh(2) + std::atanh(0.5));
    EXPECT_DOUBLE_EQ(number("exp(1)+ln(3)+log(3)+log2(3)+log10(3)+rint(2.4)")(0),
                     std::exp(1) + 2 * std::log(3) + std::log2(3) + std::log10(3) + 2);
    EXPECT_DOUBLE_EQ(number("atan2(1 m, 2 m) + sign(-3 s)")(0), std::atan2(1, 2) - 1);
    EXPECT_DOUBLE_EQ(formula("abs(x) + max(1 m, 2 m, y) + sum(1 m, 1 m) + avg(1 m, 3 m)", "1 m")(0, -5, 3), 12);
}

TEST(Formula, a_start_ramp_with_a_condition) {
    const auto ramp = formula("t < 1 s ? 2 m/s^2 * t / 1 s : 0", "1 m/s^2");
    EXPECT_DOUBLE_EQ(ramp(0.5), 1);
    EXPECT_DOUBLE_EQ(ramp(2), 0);
    const auto parabola = formula("4 m/s^2 * y * (1 cm - y) / (1 cm)^2", "1 m/s^2");
    EXPECT_DOUBLE_EQ(parabola(0, 0, 0.005), 1);
}

TEST(Formula, powers_and_roots_carry_the_dimension) {
    EXPECT_DOUBLE_EQ(formula("sqrt(2 * 9.81 m/s^2 * 5 m)", "1 m/s")(0), std::sqrt(98.1));
    EXPECT_DOUBLE_EQ(formula("(9 m)^(1/2) * (4 m)^0.5", "1 m")(0), 6);
    EXPECT_DOUBLE_EQ(formula("x^-2", "1 1/m^2")(0, 2), 0.25);
    EXPECT_DOUBLE_EQ(number("2^(t / 1 s)")(3), 8) << "a plain base takes any exponent";
}

TEST(Formula, a_bare_zero_goes_with_any_dimension) {
    EXPECT_EQ(formula("0", "1 m/s^2")(1), 0);
    EXPECT_EQ(formula("-0.0", "1 m/s^2")(1), 0);
    EXPECT_EQ(formula("max(0, x) + 0", "1 m")(0, 2), 2);
    EXPECT_EQ(formula("x > 0 ? 1 m : 0", "1 m")(0, 2), 1);
}

TEST(FormulaError, whole_formula_of_the_wrong_dimension) {
    EXPECT_EQ(message_for("0.15 m/s * sin(2*pi*t / 4 s)"),
              "scene.toml:12:18: flow.acceleration: found \"0.15 m/s * sin(2*pi*t / 4 s)\" (speed), expected an "
              "acceleration such as \"0.1 m/s^2\"\n  check the units of its factors: the whole formula must be an "
              "acceleration");
    EXPECT_EQ(message_for("0.15"),
              "scene.toml:12:17: missing unit: acceleration = 0.15, expected an acceleration such as \"0.1 m/s^2\"\n"
              "  write acceleration = \"0.15 m/s^2\", with the unit you mean");
}

TEST(FormulaError, sums_of_different_dimensions_point_at_the_sign) {
    EXPECT_EQ(message_for("1 m/s^2 + 2 m"),
              "scene.toml:12:26: '+' joins an acceleration and a length in \"1 m/s^2 + 2 m\"\n  both need the same "
              "dimension");
    EXPECT_EQ(message_for("t < 2 m ? 1 m/s^2 : 0"),
              "scene.toml:12:20: '<' joins a time and a length in \"t < 2 m ? 1 m/s^2 : 0\"\n  both need the same "
              "dimension");
    EXPECT_EQ(message_for("1 < 2 ? 1 m/s^2 : 1 m"),
              "scene.toml:12:34: ':' joins an acceleration and a length in \"1 < 2 ? 1 m/s^2 : 1 m\"\n  both need the "
              "same dimension");
    EXPECT_EQ(message_for("max(1 m, 1 s)"),
              "scene.toml:12:27: max joins a length and a time in \"max(1 m, 1 s)\"\n  both need the same dimension");
}

TEST(FormulaError, functions_of_numbers_point_at_the_argument) {
    EXPECT_EQ(
        message_for("1 m/s^2 * sin(2*pi*t)"),
        "scene.toml:12:32: sin is given a time, expected a plain number in \"1 m/s^2 * sin(2*pi*t)\"\n  divide it "
        "by a quantity of the same dimension, such as 1 s");
    EXPECT_EQ(message_for("x ? 1 : 2"),
              "scene.toml:12:18: the condition before '?' is given a length, expected a plain number in \"x ? 1 : 2\"\n"
              "  divide it by a quantity of the same dimension, such as 1 m");
    EXPECT_EQ(
        message_for("2^t"),
        "scene.toml:12:20: the exponent after '^' is given a time, expected a plain number in \"2^t\"\n  divide it "
        "by a quantity of the same dimension, such as 1 s");
}

TEST(FormulaError, powers_without_a_unit) {
    EXPECT_EQ(message_for("x^(t/1 s)"),
              "scene.toml:12:19: a length is raised to a power that is not constant in \"x^(t/1 s)\"\n  use a constant "
              "exponent such as 2 or 0.5, or divide by a quantity first");
    EXPECT_EQ(message_for("x^0.3"),
              "scene.toml:12:19: a length is raised to a power that leaves no whole or half unit in \"x^0.3\"\n  use a "
              "constant exponent such as 2 or 0.5, or divide by a quantity first");
    EXPECT_EQ(
        message_for("sqrt(sqrt(x))"),
        "scene.toml:12:23: sqrt is given a quantity in m^0.5, whose root has no unit in \"sqrt(sqrt(x))\"\n  take "
        "the root of a quantity whose unit is a whole power");
    EXPECT_EQ(message_for("2 m^0.5"),
              "scene.toml:12:22: the exponent of the unit 'm' is not a whole number up to 20\n  write a whole number "
              "such as m^2; to raise a quantity to a power put it in parentheses, such as (2 m)^0.5");
}

TEST(FormulaError, unknown_names) {
    EXPECT_EQ(message_for("1 m/s^2 * sinn(1)"),
              "scene.toml:12:28: unknown function 'sinn' in \"1 m/s^2 * sinn(1)\"\n  did you mean 'sin'?");
    EXPECT_EQ(message_for("1 m/s^2 * pii"),
              "scene.toml:12:28: unknown name 'pii' in \"1 m/s^2 * pii\"\n  did you mean 'pi'?");
    EXPECT_EQ(message_for("time * 2"),
              "scene.toml:12:18: unknown name 'time' in \"time * 2\"\n  use t, x, y, z, pi or functions such as "
              "sin, exp, sqrt, min");
    EXPECT_EQ(message_for("1 m/sek"),
              "scene.toml:12:22: unknown name 'sek' in \"1 m/sek\"\n  use t, x, y, z, pi or "
              "functions such as sin, exp, sqrt, min");
    EXPECT_EQ(message_for("3 mmm"), "scene.toml:12:20: unknown unit 'mmm' after 3 in \"3 mmm\"\n  did you mean 'mm'?");
    EXPECT_EQ(message_for("sin(t/s)"),
              "scene.toml:12:24: the unit 's' stands without a number in \"sin(t/s)\"\n  write 1 s");
}

TEST(FormulaError, missing_operators_and_parentheses) {
    EXPECT_EQ(message_for("2 t"),
              "scene.toml:12:20: missing operator before 't' in \"2 t\"\n  write * or / between them");
    EXPECT_EQ(message_for("1 m/s^2 sin(1)"),
              "scene.toml:12:26: missing operator before 'sin' in \"1 m/s^2 sin(1)\"\n  write * or / between them");
    EXPECT_EQ(message_for("2 (3)"),
              "scene.toml:12:20: missing operator before '(' in \"2 (3)\"\n  write an operator such as * or / there");
    EXPECT_EQ(message_for("2 3"),
              "scene.toml:12:20: missing operator before '3' in \"2 3\"\n  write an operator such as * or / there");
    EXPECT_EQ(message_for("t (3)"),
              "scene.toml:12:19: missing operator after 't' in \"t (3)\"\n  write * between 't' and '('");
    EXPECT_EQ(message_for("(1 + 2"),
              "scene.toml:12:24: expected ')' but found the end in \"(1 + 2\"\n  close the "
              "parenthesis opened at character 1 of the formula");
    EXPECT_EQ(message_for("1 + "),
              "scene.toml:12:22: the formula ends too early in \"1 + \"\n  expected a number, a name or '(' here");
    EXPECT_EQ(message_for(""),
              "scene.toml:12:18: the formula ends too early in \"\"\n  expected a number, a name or '(' here");
    EXPECT_EQ(message_for("1 + 2)"),
              "scene.toml:12:23: unexpected ')' in \"1 + 2)\"\n  check the operators and parentheses");
    EXPECT_EQ(message_for("1 * / 2"),
              "scene.toml:12:22: unexpected '/' in \"1 * / 2\"\n  expected a number, a name or '(' here");
    EXPECT_EQ(message_for("1 ? 2"),
              "scene.toml:12:23: expected ':' but found the end in \"1 ? 2\"\n  write condition ? value : other value");
    EXPECT_EQ(message_for("sin(1, 2)"), "scene.toml:12:18: sin is given 2 values in \"sin(1, 2)\"\n  give it 1");
    EXPECT_EQ(message_for("max()"),
              "scene.toml:12:18: max is given 0 values in \"max()\"\n  give it one or more, joined by commas");
    EXPECT_EQ(message_for("t = 2"),
              "scene.toml:12:20: unexpected '=' in \"t = 2\"\n  check the operators and parentheses");
}

TEST(FormulaError, deep_nesting_is_an_error_and_no_crash) {
    EXPECT_NE(message_for(std::string(100000, '(')).find("inside each other"), std::string::npos);
    EXPECT_NE(message_for(std::string(100000, '-') + "1").find("inside each other"), std::string::npos);
}

}  // namespace
}  // namespace dmp::tests::scene_expressions_tests
