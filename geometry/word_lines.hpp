// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dmp::geometry {

/// The lines of a text one after another, each cut into words at blanks. The text must outlive it.
class TokenLines {
  public:
    /// What follows `comment` on a line is none of it; '\0': there are no comments. `first_line` counts from 1.
    /// `goes_on`: a line that ends with '\' goes on in the next one.
    explicit TokenLines(std::string_view text, char comment = '\0', int first_line = 1, bool goes_on = false)
        : rest_(text), comment_(comment), goes_on_(goes_on), number_(first_line - 1) {}

    /// Goes to the next line; false where there is none.
    bool next();
    /// Goes to the next line that has words.
    bool next_with_tokens();

    [[nodiscard]] const std::vector<std::string_view>& words() const { return words_; }
    [[nodiscard]] std::string_view line() const { return line_; }  ///< without its end
    [[nodiscard]] int number() const { return number_; }

  private:
    std::string_view rest_, line_;
    char comment_;
    bool goes_on_;
    int number_;
    std::vector<std::string_view> words_;
};

/// A piece of a file in quotes, for a message: '?' for what cannot be printed, and of a long one its beginning.
[[nodiscard]] std::string in_quotes(std::string_view text, char mark = '"');

/// The number that a word is, finite or not; none where it is no number.
[[nodiscard]] std::optional<double> number_in(std::string_view word);
/// The whole number that a word is.
[[nodiscard]] std::optional<long long> whole_number_in(std::string_view word);

}  // namespace dmp::geometry
