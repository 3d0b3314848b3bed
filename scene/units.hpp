// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace dmp::scene {

/// Exponents of the seven SI base dimensions: length, mass, time, electric current, temperature, amount of substance,
/// luminous intensity. They are stored in units of one half, so that square roots are exact. Angles have no dimension.
struct Dimension {
    std::array<int, 7> halves{};

    bool operator==(const Dimension&) const = default;
    [[nodiscard]] bool none() const { return *this == Dimension{}; }
    /// This dimension raised to `exponent`; nullopt if a resulting exponent is not a multiple of one half.
    [[nodiscard]] std::optional<Dimension> to_the(double exponent) const;
    /// "length", "bending stiffness", "number"; in SI units ("m^3/kg") if it has no name.
    [[nodiscard]] std::string name() const;
    /// "a length", "an energy", "a quantity in m^3/kg".
    [[nodiscard]] std::string name_with_article() const;
    /// "kg/m^3", "N*m^2", "s^-1", empty for a number; read_unit_greedily() can read it.
    [[nodiscard]] std::string si_unit() const;
};

Dimension operator*(const Dimension& a, const Dimension& b);
Dimension operator/(const Dimension& a, const Dimension& b);

/// A unit: factor 10^power_of_ten SI units. The power is separate so that "0.2 mm" is the double nearest to 0.0002.
struct Unit {
    double factor = 1;
    int power_of_ten = 0;
    Dimension dimension;
};

Unit operator*(const Unit& a, const Unit& b);
Unit power(const Unit& unit, int exponent);

/// The unit of a symbol with its prefix, such as "mm" or "kPa"; nullopt if there is no such unit. A symbol takes
/// precedence over a prefix with a symbol: "min" is the minute, "cd" the candela.
std::optional<Unit> unit_symbol(std::string_view symbol);

/// The known unit symbol most similar to `symbol`, preferably of dimension `wanted`; empty if none is similar.
std::string nearest_unit(std::string_view symbol, const Dimension* wanted = nullptr);

}  // namespace dmp::scene
