// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "scene/units.hpp"
#include "scene/written_text.hpp"

namespace dmp::scene {

/// A number in SI units and its dimension.
struct Quantity {
    double si = 0;
    Dimension dimension;
};

/// End of the unsigned number that starts at `begin`; `begin` if there is none.
std::size_t end_of_number(std::string_view text, std::size_t begin);
/// End of the name that starts at `begin` (letters, digits, '_' and the micro sign); `begin` if there is none.
std::size_t end_of_name(std::string_view text, std::size_t begin);
std::size_t skip_spaces(std::string_view text, std::size_t begin);

/// A unit found in a text, and its end.
struct UnitReading {
    Unit unit;
    std::size_t end = 0;
};

/// Reads a unit greedily from `begin`: symbols with whole-number exponents joined by * and /, evaluated from left to
/// right ("kg/m/s^2"). The next factor belongs to the unit if it is a known symbol, is not followed by "(" and
/// `not_unit` is false for it; the rest of the text is not read. nullopt if the first name is not a unit. Throws
/// InputError for an exponent that is not a whole number.
std::optional<UnitReading> read_unit_greedily(const WrittenText& text, std::size_t begin,
                                              bool (*not_unit)(std::string_view));

/// `number` (unsigned) in `unit`, converted to SI units with a single rounding. Throws InputError at `location` if it
/// does not fit into a double.
double in_si(std::string_view number, const Unit& unit, const SourceLocation& location);

/// Whether `text` consists of a number, with or without sign.
bool is_bare_number(std::string_view text);

/// Reads "3.5 mPa*s", "-40 mm", "50 1/s" or "0.5". Throws InputError with the location in the text. `wanted` improves
/// the suggestion for a misspelt unit.
Quantity parse_quantity(const WrittenText& text, const Dimension* wanted = nullptr);

/// The shortest decimal text that reads back as the same double (at most 17 significant digits).
std::string exact_text(double value);

/// The quantity that a key expects, given by an example: "0.1 mm" stands for any length.
class Expected {
  public:
    explicit Expected(std::string example);

    [[nodiscard]] const Dimension& dimension() const { return dimension_; }
    /// `a length such as "0.1 mm"`.
    [[nodiscard]] std::string phrase() const;
    /// "mm"
    [[nodiscard]] const std::string& unit() const { return unit_; }
    [[nodiscard]] const std::string& example() const { return example_; }

    /// The quantity in `text` in SI units. `subject` is its key and may be empty. Throws InputError if the unit
    /// is missing, unknown or of another dimension; a bare 0 needs no unit.
    [[nodiscard]] double read(const WrittenText& text, const std::string& subject) const;
    /// The error for a number without a unit.
    [[nodiscard]] InputError missing_unit(const SourceLocation& location, const std::string& written,
                                          const std::string& subject) const;

  private:
    std::string example_;
    std::string unit_;
    Dimension dimension_;
};

/// The last word of a key's path: "spacing" of "particles.spacing".
std::string last_word(const std::string& path);

}  // namespace dmp::scene
