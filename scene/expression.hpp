// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

namespace dmp::scene {

/// A checked formula of t [s], x, y, z [m] whose value is in SI units.
/// Copies are cheap and independent, so each thread may evaluate its own copy.
class Expression {
  public:
    /// The constant 0.
    Expression();
    /// `formula` in muParser's grammar, every literal already in SI; `in_si` is the same with units, every literal in
    /// SI base units (empty: `as_written`). Throws std::invalid_argument with muParser's words.
    Expression(std::string formula, std::string as_written, std::string in_si = {});
    Expression(const Expression& other);
    Expression(Expression&& other) noexcept;
    Expression& operator=(const Expression& other);
    Expression& operator=(Expression&& other) noexcept;
    ~Expression();

    [[nodiscard]] double operator()(double t, double x = 0, double y = 0, double z = 0) const;

    [[nodiscard]] bool depends_on_time() const;
    [[nodiscard]] bool depends_on_position() const;
    /// Whether it is 0 at any time and place.
    [[nodiscard]] bool is_zero() const { return !depends_on_time() && !depends_on_position() && (*this)(0) == 0; }
    /// As the user wrote it, with units.
    [[nodiscard]] const std::string& text() const { return as_written_; }
    /// With units, literals in SI base units; the same for every way to write the same formula in other units.
    [[nodiscard]] const std::string& si_text() const { return in_si_; }

  private:
    struct Parser;
    std::string formula_;
    std::string as_written_;
    std::string in_si_;
    std::unique_ptr<Parser> parser_;
};

}  // namespace dmp::scene
