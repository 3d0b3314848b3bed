// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "scene/expression.hpp"
#include "scene/quantity.hpp"

namespace dmp::scene {

/// Reads a formula with units, such as "0.25 m/s^2 * sin(2*pi*t / 4 s)", and checks the dimensions of every operation.
///
/// Variables: t [s], x, y, z [m], by `places` X, Y, Z [m]. Constant: pi. Functions: sin cos tan asin acos atan atan2
/// sinh cosh tanh asinh acosh atanh exp ln log (natural) log2 log10 rint sqrt abs sign min max sum avg. Operators, by
/// increasing precedence: condition ? a : b, ||, &&, < <= > >= == !=, + -, * /, sign, ^ (right-associative).
///
/// A number may be followed by its unit, which is read greedily: after a symbol and its whole-number exponent, "* name"
/// and "/ name" belong to the unit if the name is a known unit symbol, is not followed by "(" and is not t, x, y, z or
/// pi. Names are read as a whole: "min" is the minute, not "m" and "in". Thus "2*pi*t / 4 s" is (2*pi*t) / (4 s),
/// "1 m/s^2 * sin(...)" is (1 m/s^2) * sin(...), and "1 m / s * t" is (1 m/s) * t.
///
/// Dimensions: + - comparisons, min, max, sum, avg and the two results of ?: need equal dimensions; sin, exp and
/// similar functions need plain numbers; sqrt halves the exponents; the exponent of ^ is a plain number, and a constant
/// multiple of 1/2 if the base has a dimension. A bare 0 has any dimension.
///
/// `subject` is the formula's key. Throws InputError with the location of the fault in the text.
Expression read_formula(const WrittenText& text, const Expected& expected, const std::string& subject,
                        PlacesKnown places = PlacesKnown::now);
/// The same of any dimension.
Expression read_formula(const WrittenText& text, const std::string& subject);

/// Whether a name has a meaning in formulas: a unit, a function, a variable or pi.
bool is_formula_word(std::string_view name);

/// The value of a formula without variables, of any dimension. Throws InputError likewise, also where it depends on t,
/// x, y or z, or is no finite number.
Quantity constant_formula(const WrittenText& text, const std::string& subject);

}  // namespace dmp::scene
