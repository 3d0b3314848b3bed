// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace dmp::cli {

enum class Stream { output, error };

/// Whether somebody sees it as it is written.
[[nodiscard]] bool is_terminal(Stream stream);
/// A terminal that shows colours, and nobody set NO_COLOR (https://no-color.org).
[[nodiscard]] bool colours_on(Stream stream);
/// Characters in a line of the terminal; 80 when it does not say.
[[nodiscard]] int terminal_width(Stream stream);

/// Text as it may be shown, whoever wrote what is in it: other control characters than the ends of lines and tabs,
/// which a terminal might act on, and bytes that are no UTF-8 become \xNN. The marks of Style stay, if it may have made
/// any.
[[nodiscard]] std::string printable(std::string_view text, bool marked);

/// The text without the marks of Style.
[[nodiscard]] std::string without_marks(std::string_view text);

/// Text to stdout, made printable. Throws ResourceError when it does not get there, unless nobody reads it any more (a
/// closed pipe, a terminal that is gone): a run must not end because of that.
void print(std::string_view text);
/// Throws likewise when what was printed does not get there.
void flush_output();
/// Text to stderr, made printable, at once. Nothing happens when it does not get there: a run must not end because
/// nobody reads its output.
void print_error(std::string_view text);

/// Takes back the unfinished line on stderr, of a terminal.
void erase_error_line();

/// Marks text for the eye, or leaves it as it is.
class Style {
  public:
    explicit Style(bool colour) : colour_(colour) {}
    explicit Style(Stream stream) : colour_(colours_on(stream)) {}

    [[nodiscard]] std::string strong(std::string_view text) const;
    [[nodiscard]] std::string faint(std::string_view text) const;
    [[nodiscard]] std::string good(std::string_view text) const;
    [[nodiscard]] std::string warning(std::string_view text) const;
    [[nodiscard]] std::string error(std::string_view text) const;

  private:
    [[nodiscard]] std::string marked(std::string_view mark, std::string_view text) const;

    bool colour_;
};

}  // namespace dmp::cli
