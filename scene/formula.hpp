// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "scene/expression.hpp"
#include "scene/quantity.hpp"

namespace dmp::scene {

/// Reads a formula with units, such as "0.25 m/s^2 * sin(2*pi*t / 4 s)", and checks the dimension of every step.
///
/// Variables: t [s], x, y, z [m]. Constant: pi. Functions: sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh
/// atanh exp ln log (natural) log2 log10 rint sqrt abs sign min max sum avg. Operators, loosest first:
/// condition ? a : b, ||, &&, < <= > >= == !=, + -, * /, sign, ^ (from the right).
///
/// A number may be followed by its unit, which is read greedily: after a symbol and its whole-number exponent, "* name"
/// and "/ name" still belong to the unit if the name is a known unit symbol, is not followed by "(" and is none of t,
/// x, y, z, pi. Names are read whole, so "min" is the minute and never "m" and "in". Thus "2*pi*t / 4 s" is (2*pi*t) /
/// (4 s), "1 m/s^2 * sin(...)" is (1 m/s^2) * sin(...), and "1 m / s * t" is (1 m/s) * t.
///
/// Dimensions: + - comparisons, min, max, sum, avg and the two results of ?: need equal ones; sin, exp and their like
/// need plain numbers; sqrt halves them; ^ needs a plain number, and a constant multiple of 1/2 where the base has a
/// dimension. A bare 0 goes with any dimension.
///
/// `subject` is the key the formula is for. Throws InputError that points at the word in the text that is wrong.
Expression read_formula(const WrittenText& text, const Expected& expected, const std::string& subject);

}  // namespace dmp::scene
