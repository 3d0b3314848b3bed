// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "scene/toml_node.hpp"
#include "study/study.hpp"

namespace dmp::study {

/// A value as the study has it. `unit`: of the key's numbers; empty: as yet unknown, and then that of this value.
VariedValue varied_value(const TomlNode& node, std::string& unit);

/// A number in the key's unit; `quoted`: the key takes it as a text with its unit.
VariedValue varied_number(double number, const std::string& unit, bool quoted);

/// A quantity that was worked out, in its SI unit.
VariedValue varied_quantity(const Quantity& quantity);

/// "0.8 mm" -> "mm"; "" where there is no unit.
std::string unit_in(const std::string& text);

/// A number in `unit`, from SI units. Where the study does not write it in this unit, it is rounded to 15 digits, so
/// that 1 cm is 10 mm and not 10.000000000000002 mm.
double number_in_unit(double si, const std::string& unit);

/// The k-th of `count` numbers of a range, with both ends; numbers between them are rounded to 12 digits, so that they
/// look as a person would write them. `k` need not be a whole number.
double number_of(const NumberRange& range, double k, double count);

}  // namespace dmp::study
