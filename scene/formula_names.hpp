// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scene/units.hpp"

// Functions, variables and constants of formulas, for formula.cpp only.
namespace dmp::scene::formula_names {

/// Dimensions of a function's arguments and of its result.
enum class Rule { number_to_number, keeps, to_number, square_root, like_to_same, like_to_number };

struct Function {
    std::string_view name;
    Rule rule;
    std::size_t fewest;
    std::size_t most;
};

inline constexpr std::size_t any_count = 1000;
inline constexpr std::array functions = {
    Function{"sin", Rule::number_to_number, 1, 1},     Function{"cos", Rule::number_to_number, 1, 1},
    Function{"tan", Rule::number_to_number, 1, 1},     Function{"asin", Rule::number_to_number, 1, 1},
    Function{"acos", Rule::number_to_number, 1, 1},    Function{"atan", Rule::number_to_number, 1, 1},
    Function{"sinh", Rule::number_to_number, 1, 1},    Function{"cosh", Rule::number_to_number, 1, 1},
    Function{"tanh", Rule::number_to_number, 1, 1},    Function{"asinh", Rule::number_to_number, 1, 1},
    Function{"acosh", Rule::number_to_number, 1, 1},   Function{"atanh", Rule::number_to_number, 1, 1},
    Function{"exp", Rule::number_to_number, 1, 1},     Function{"ln", Rule::number_to_number, 1, 1},
    Function{"log", Rule::number_to_number, 1, 1},     Function{"log2", Rule::number_to_number, 1, 1},
    Function{"log10", Rule::number_to_number, 1, 1},   Function{"rint", Rule::number_to_number, 1, 1},
    Function{"sqrt", Rule::square_root, 1, 1},         Function{"abs", Rule::keeps, 1, 1},
    Function{"sign", Rule::to_number, 1, 1},           Function{"atan2", Rule::like_to_number, 2, 2},
    Function{"min", Rule::like_to_same, 1, any_count}, Function{"max", Rule::like_to_same, 1, any_count},
    Function{"sum", Rule::like_to_same, 1, any_count}, Function{"avg", Rule::like_to_same, 1, any_count},
};

inline constexpr Dimension length{{2, 0, 0, 0, 0, 0, 0}};
inline constexpr Dimension time{{0, 0, 2, 0, 0, 0, 0}};

struct Variable {
    std::string_view name;
    Dimension dimension;
};

inline constexpr std::array variables = {Variable{"t", time}, Variable{"x", length}, Variable{"y", length},
                                         Variable{"z", length}};
/// Of a particle in the initial state [m], in formulas that may ask for it.
inline constexpr std::array<std::string_view, 3> initial_position = {"X", "Y", "Z"};

inline bool is_initial_position(std::string_view name) {
    return std::find(initial_position.begin(), initial_position.end(), name) != initial_position.end();
}

inline bool is_variable_or_constant(std::string_view name) {
    return name == "pi" || std::any_of(variables.begin(), variables.end(), [&](auto& v) { return v.name == name; });
}

inline bool is_value(std::string_view name) { return is_variable_or_constant(name) || is_initial_position(name); }

inline std::vector<std::string> known_names() {
    std::vector<std::string> names = {"pi"};
    for (const auto& variable : variables) names.emplace_back(variable.name);
    for (const auto& function : functions) names.emplace_back(function.name);
    return names;
}

}  // namespace dmp::scene::formula_names
