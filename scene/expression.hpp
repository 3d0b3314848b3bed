// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/vec.hpp"

namespace dmp::scene {

/// Which places of a particle a formula may ask for: the present one (x, y, z), also that in the initial state (X, Y,
/// Z).
enum class PlacesKnown { now, now_and_at_start };

/// A checked formula of t [s], of the place x, y, z [m] and, where a formula may ask for it, of the place X, Y, Z [m]
/// in the initial state. Its value is in SI units. Copies are cheap and independent, so each thread may evaluate its
/// own copy.
class Expression {
  public:
    /// The constant 0.
    Expression();
    /// `formula` follows muParser's grammar, with all literals in SI units; `in_si` is the same with units, all
    /// literals in SI base units (empty: `as_written`). Throws std::invalid_argument with muParser's message.
    Expression(std::string formula, std::string as_written, std::string in_si = {});
    Expression(const Expression& other);
    Expression(Expression&& other) noexcept;
    Expression& operator=(const Expression& other);
    Expression& operator=(Expression&& other) noexcept;
    ~Expression();

    /// In the initial state, or of a formula that does not ask for it.
    [[nodiscard]] double operator()(double t, double x = 0, double y = 0, double z = 0) const;
    /// Of a particle that is here now, and was there in the initial state [m].
    [[nodiscard]] double at(double t, const Vec& now, const Vec& at_start) const;

    /// `variable`: "t", "x", "X" and so on.
    [[nodiscard]] bool depends_on(std::string_view variable) const;
    [[nodiscard]] bool depends_on_time() const { return depends_on("t"); }
    [[nodiscard]] bool depends_on_position() const;
    [[nodiscard]] bool depends_on_initial_position() const;
    /// Whether it is 0 at all times and positions.
    [[nodiscard]] bool is_zero() const {
        return !depends_on_time() && !depends_on_position() && !depends_on_initial_position() && (*this)(0) == 0;
    }
    /// As the user wrote it, with units.
    [[nodiscard]] const std::string& text() const { return as_written_; }
    /// With units, literals in SI base units: the same text for the same formula in any units.
    [[nodiscard]] const std::string& si_text() const { return in_si_; }

  private:
    struct Parser;
    std::string formula_;
    std::string as_written_;
    std::string in_si_;
    std::unique_ptr<Parser> parser_;
};

}  // namespace dmp::scene
