// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/units.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <numbers>
#include <vector>

#include "base/nearest_name.hpp"

namespace dmp::scene {

namespace {

constexpr Dimension of(int length, int mass, int time, int current = 0, int temperature = 0, int amount = 0,
                       int intensity = 0) {
    return {{2 * length, 2 * mass, 2 * time, 2 * current, 2 * temperature, 2 * amount, 2 * intensity}};
}

struct Symbol {
    std::string_view name;
    Unit unit;
    bool takes_prefix;
};

constexpr double degree = std::numbers::pi / 180;
constexpr double millimetre_of_mercury = 133.322387415;  // [Pa], BS 350: 13595.1 kg/m^3 x 9.80665 m/s^2 x 1 mm

constexpr std::array symbols = {
    Symbol{"m", {1, 0, of(1, 0, 0)}, true},
    Symbol{"g", {1, -3, of(0, 1, 0)}, true},
    Symbol{"s", {1, 0, of(0, 0, 1)}, true},
    Symbol{"A", {1, 0, of(0, 0, 0, 1)}, true},
    Symbol{"K", {1, 0, of(0, 0, 0, 0, 1)}, true},
    Symbol{"mol", {1, 0, of(0, 0, 0, 0, 0, 1)}, true},
    Symbol{"cd", {1, 0, of(0, 0, 0, 0, 0, 0, 1)}, true},
    Symbol{"rad", {1, 0, of(0, 0, 0)}, true},
    Symbol{"Hz", {1, 0, of(0, 0, -1)}, true},
    Symbol{"N", {1, 0, of(1, 1, -2)}, true},
    Symbol{"Pa", {1, 0, of(-1, 1, -2)}, true},
    Symbol{"J", {1, 0, of(2, 1, -2)}, true},
    Symbol{"W", {1, 0, of(2, 1, -3)}, true},
    Symbol{"C", {1, 0, of(0, 0, 1, 1)}, true},
    Symbol{"V", {1, 0, of(2, 1, -3, -1)}, true},
    Symbol{"F", {1, 0, of(-2, -1, 4, 2)}, true},
    Symbol{"T", {1, 0, of(0, 1, -2, -1)}, true},
    Symbol{"l", {1, -3, of(3, 0, 0)}, true},
    Symbol{"L", {1, -3, of(3, 0, 0)}, true},
    Symbol{"bar", {1, 5, of(-1, 1, -2)}, true},
    Symbol{"P", {1, -1, of(-1, 1, -1)}, true},  // poise
    Symbol{"min", {6, 1, of(0, 0, 1)}, false},
    Symbol{"h", {36, 2, of(0, 0, 1)}, false},
    Symbol{"d", {864, 2, of(0, 0, 1)}, false},
    Symbol{"deg", {degree, 0, of(0, 0, 0)}, false},
    Symbol{"mmHg", {millimetre_of_mercury, 0, of(-1, 1, -2)}, false},
    Symbol{"atm", {101325, 0, of(-1, 1, -2)}, false},
};

struct Prefix {
    std::string_view name;
    int power_of_ten;
};

constexpr std::array prefixes = {
    Prefix{"Y", 24},  Prefix{"Z", 21},  Prefix{"E", 18},  Prefix{"P", 15},      Prefix{"T", 12},      Prefix{"G", 9},
    Prefix{"M", 6},   Prefix{"k", 3},   Prefix{"h", 2},   Prefix{"da", 1},      Prefix{"d", -1},      Prefix{"c", -2},
    Prefix{"m", -3},  Prefix{"u", -6},  Prefix{"n", -9},  Prefix{"\u00B5", -6}, Prefix{"\u03BC", -6}, Prefix{"p", -12},
    Prefix{"f", -15}, Prefix{"a", -18}, Prefix{"z", -21}, Prefix{"y", -24},
};

/// A name, or the name of a unit, of a dimension.
struct NamedDimension {
    std::string_view name;
    Dimension dimension;
};

constexpr std::array named_dimensions = {
    NamedDimension{"number", of(0, 0, 0)},
    NamedDimension{"length", of(1, 0, 0)},
    NamedDimension{"mass", of(0, 1, 0)},
    NamedDimension{"time", of(0, 0, 1)},
    NamedDimension{"electric current", of(0, 0, 0, 1)},
    NamedDimension{"temperature", of(0, 0, 0, 0, 1)},
    NamedDimension{"amount of substance", of(0, 0, 0, 0, 0, 1)},
    NamedDimension{"luminous intensity", of(0, 0, 0, 0, 0, 0, 1)},
    NamedDimension{"area", of(2, 0, 0)},
    NamedDimension{"volume", of(3, 0, 0)},
    NamedDimension{"speed", of(1, 0, -1)},
    NamedDimension{"acceleration", of(1, 0, -2)},
    NamedDimension{"frequency", of(0, 0, -1)},
    NamedDimension{"force", of(1, 1, -2)},
    NamedDimension{"energy", of(2, 1, -2)},
    NamedDimension{"power", of(2, 1, -3)},
    NamedDimension{"pressure", of(-1, 1, -2)},
    NamedDimension{"pressure gradient", of(-2, 1, -2)},
    NamedDimension{"density", of(-3, 1, 0)},
    NamedDimension{"dynamic viscosity", of(-1, 1, -1)},
    NamedDimension{"kinematic viscosity", of(2, 0, -1)},
    NamedDimension{"volume flow", of(3, 0, -1)},
    NamedDimension{"mass per time", of(0, 1, -1)},
    NamedDimension{"mass per length", of(-1, 1, 0)},
    NamedDimension{"stiffness", of(0, 1, -2)},
    NamedDimension{"bending stiffness", of(3, 1, -2)},
};

/// Dimensions whose usual unit is not made of base units.
constexpr std::array derived_units = {
    NamedDimension{"N", of(1, 1, -2)},   NamedDimension{"J", of(2, 1, -2)},     NamedDimension{"W", of(2, 1, -3)},
    NamedDimension{"Pa", of(-1, 1, -2)}, NamedDimension{"Pa/m", of(-2, 1, -2)}, NamedDimension{"Pa*s", of(-1, 1, -1)},
    NamedDimension{"N/m", of(0, 1, -2)}, NamedDimension{"N*m^2", of(3, 1, -2)},
};

constexpr std::array<std::string_view, 7> base_units = {"m", "kg", "s", "A", "K", "mol", "cd"};

/// Candidates for a misspelt unit, the most common first.
const std::vector<std::string>& usual_units() {
    static const std::vector<std::string> usual = {
        "mm", "m",  "um", "cm",  "km",   "nm",   "s",   "ms",  "us",  "min",  "h",  "d",  "kg", "g",  "mg",
        "ug", "N",  "mN", "uN",  "kN",   "Pa",   "mPa", "kPa", "MPa", "GPa",  "J",  "mJ", "uJ", "nJ", "kJ",
        "W",  "mW", "kW", "Hz",  "kHz",  "MHz",  "K",   "mK",  "mol", "mmol", "A",  "mA", "V",  "mV", "L",
        "mL", "l",  "ml", "bar", "mbar", "mmHg", "atm", "deg", "rad", "P",    "cP", "C",  "F",  "T",  "cd"};
    return usual;
}

/// The unit that differs only in upper and lower case, otherwise the most similar one.
std::string nearest_among(std::string_view symbol, const std::vector<std::string>& units) {
    const auto same_but_for_case = [&](const std::string& unit) {
        return std::equal(unit.begin(), unit.end(), symbol.begin(), symbol.end(),
                          [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
    };
    const auto found = std::find_if(units.begin(), units.end(), same_but_for_case);
    return found != units.end() ? *found : nearest_name(symbol, units);
}

}  // namespace

std::optional<Dimension> Dimension::to_the(double exponent) const {
    Dimension result;
    for (std::size_t i = 0; i < halves.size(); ++i) {
        const double power = halves[i] * exponent;
        if (power != std::round(power) || std::abs(power) > 200) return {};
        result.halves[i] = static_cast<int>(power);
    }
    return result;
}

std::string Dimension::name() const {
    for (const auto& named : named_dimensions) {
        if (named.dimension == *this) return std::string(named.name);
    }
    return si_unit();
}

std::string Dimension::name_with_article() const {
    const bool named = std::any_of(named_dimensions.begin(), named_dimensions.end(),
                                   [this](const NamedDimension& n) { return n.dimension == *this; });
    if (!named) return "a quantity in " + si_unit();
    const std::string text = name();
    return (std::string_view("aeiou").find(text[0]) == std::string_view::npos ? "a " : "an ") + text;
}

std::string Dimension::si_unit() const {
    for (const auto& derived : derived_units) {
        if (derived.dimension == *this) return std::string(derived.name);
    }
    const auto factor = [](std::string_view unit, int twice) {
        if (twice == 2) return std::string(unit);
        const std::string whole = (twice < 0 ? "-" : "") + std::to_string(std::abs(twice) / 2);
        return std::string(unit) + "^" + whole + (twice % 2 == 0 ? "" : ".5");
    };
    const bool has_numerator = std::any_of(halves.begin(), halves.end(), [](int half) { return half > 0; });
    std::string text;
    for (std::size_t i = 0; i < halves.size(); ++i) {
        if (halves[i] > 0) text += (text.empty() ? "" : "*") + factor(base_units[i], halves[i]);
    }
    for (std::size_t i = 0; i < halves.size(); ++i) {
        if (halves[i] >= 0) continue;
        if (has_numerator) {
            text += "/" + factor(base_units[i], -halves[i]);
        } else {
            text += (text.empty() ? "" : "*") + factor(base_units[i], halves[i]);
        }
    }
    return text;
}

Dimension operator*(const Dimension& a, const Dimension& b) {
    Dimension product = a;
    for (std::size_t i = 0; i < product.halves.size(); ++i) product.halves[i] += b.halves[i];
    return product;
}

Dimension operator/(const Dimension& a, const Dimension& b) {
    Dimension quotient = a;
    for (std::size_t i = 0; i < quotient.halves.size(); ++i) quotient.halves[i] -= b.halves[i];
    return quotient;
}

Unit operator*(const Unit& a, const Unit& b) {
    return {a.factor * b.factor, a.power_of_ten + b.power_of_ten, a.dimension * b.dimension};
}

Unit power(const Unit& unit, int exponent) {
    Dimension dimension = unit.dimension;
    for (int& half : dimension.halves) half *= exponent;
    return {std::pow(unit.factor, exponent), unit.power_of_ten * exponent, dimension};
}

std::optional<Unit> unit_symbol(std::string_view symbol) {
    const auto known = [](std::string_view name) {
        return std::find_if(symbols.begin(), symbols.end(), [&](const Symbol& s) { return s.name == name; });
    };
    if (const auto* const found = known(symbol); found != symbols.end()) return found->unit;
    for (const auto& prefix : prefixes) {
        if (!symbol.starts_with(prefix.name)) continue;
        const auto* const found = known(symbol.substr(prefix.name.size()));
        if (found == symbols.end() || !found->takes_prefix) continue;
        Unit unit = found->unit;
        unit.power_of_ten += prefix.power_of_ten;
        return unit;
    }
    return {};
}

std::string nearest_unit(std::string_view symbol, const Dimension* wanted) {
    if (wanted != nullptr) {
        std::vector<std::string> fitting;
        std::copy_if(usual_units().begin(), usual_units().end(), std::back_inserter(fitting),
                     [&](const std::string& unit) { return unit_symbol(unit)->dimension == *wanted; });
        if (auto found = nearest_among(symbol, fitting); !found.empty()) return found;
    }
    return nearest_among(symbol, usual_units());
}

}  // namespace dmp::scene
