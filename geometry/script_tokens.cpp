// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/script_tokens.hpp"

#include <algorithm>
#include <utility>

#include "base/errors.hpp"

namespace dmp::geometry {

namespace {

constexpr std::size_t longest_text = 1023;  ///< gmsh's buffer; it takes what is beyond it for statements
constexpr std::size_t longest_word = 200;   ///< gmsh writes names into buffers of 256 without looking

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

/// Reads tokens from the first character to the last.
class Scanner {
  public:
    Scanner(const std::string& text, const std::string& file) : text_(text), file_(file) {}

    std::vector<ScriptToken> tokens() {
        refuse_what_is_no_script();
        std::vector<ScriptToken> all;
        bool spaced = true;
        while (at_ < text_.size()) {
            if (is_space(text_[at_])) {
                advance(1);
                spaced = true;
            } else if (text_.compare(at_, 2, "//") == 0) {
                advance(std::min(text_.find('\n', at_), text_.size()) - at_);
                spaced = true;
            } else if (text_.compare(at_, 2, "/*") == 0) {
                const std::size_t end = text_.find("*/", at_ + 2);
                if (end == std::string::npos) refuse("a comment without its end", "Close it with */ where it ends.");
                advance(end + 2 - at_);
                spaced = true;
            } else {
                ScriptToken token = next();
                token.spaced = std::exchange(spaced, false);
                all.push_back(std::move(token));
            }
        }
        return all;
    }

  private:
    [[noreturn]] void refuse(const std::string& problem, const std::string& what_to_do) const {
        throw InputError({.file = file_, .line = line_, .column = column()}, problem, what_to_do);
    }

    void refuse_what_is_no_script() {
        at_ = text_.find('\0');
        if (at_ != std::string::npos) {
            line_ = 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + static_cast<long>(at_), '\n'));
            refuse("a zero byte: this is no gmsh script", "Give it the ending of what it is.");
        }
        at_ = 0;
        if (text_.starts_with('$')) refuse("this is a mesh or a result of gmsh, and no script", "Name a mesh .msh.");
    }

    [[nodiscard]] int column() const { return static_cast<int>(at_ - line_begin_) + 1; }

    void advance(std::size_t count) {
        for (; count > 0; --count, ++at_) {
            if (text_[at_] != '\n') continue;
            ++line_;
            line_begin_ = at_ + 1;
        }
    }

    ScriptToken next() {
        ScriptToken token;
        token.line = line_;
        token.column = column();
        const char c = text_[at_];
        if (c == '"' || c == '\'') {
            token.kind = TokenKind::text;
            token.quote = c;
            token.text = quoted(c);
            advance(token.text.size() + 2);
            return token;
        }
        std::size_t length = 1;
        if (is_letter(c)) {
            token.kind = TokenKind::word;
            while (at_ + length < text_.size() && (is_letter(text_[at_ + length]) || is_digit(text_[at_ + length])))
                ++length;
            if (length > longest_word)
                refuse("a word of more than " + std::to_string(longest_word) + " characters", "Shorten it.");
        } else if (const std::size_t digits = length_of_number(); digits > 0) {
            token.kind = TokenKind::number;
            length = digits;
        }
        token.text = text_.substr(at_, length);
        advance(length);
        return token;
    }

    [[nodiscard]] std::string quoted(char quote) const {
        const std::size_t end = text_.find_first_of(std::string{quote, '\n', '\r'}, at_ + 1);
        if (end == std::string::npos || text_[end] != quote)
            refuse("a text without its closing quote on the same line",
                   "Close the text on the line that it begins on.");
        if (end - at_ - 1 > longest_text)
            refuse("a text of more than " + std::to_string(longest_text) + " characters",
                   "Shorten it; gmsh takes the rest for statements.");
        return text_.substr(at_ + 1, end - at_ - 1);
    }

    /// 0: here stands no number.
    [[nodiscard]] std::size_t length_of_number() const {
        const auto digits_from = [&](std::size_t from) {
            std::size_t end = from;
            while (end < text_.size() && is_digit(text_[end])) ++end;
            return end - from;
        };
        const std::size_t whole = digits_from(at_);
        std::size_t length = whole;
        if (at_ + length < text_.size() && text_[at_ + length] == '.') {
            const std::size_t fraction = digits_from(at_ + length + 1);
            if (whole + fraction > 0) length += 1 + fraction;
        }
        if (length == 0) return 0;
        std::size_t end = at_ + length;
        if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
            ++end;
            if (end < text_.size() && (text_[end] == '+' || text_[end] == '-')) ++end;
            const std::size_t exponent = digits_from(end);
            if (exponent > 0) length = end + exponent - at_;
        }
        return length;
    }

    const std::string& text_;
    const std::string& file_;
    std::size_t at_ = 0, line_begin_ = 0;
    int line_ = 1;
};

}  // namespace

std::vector<ScriptToken> script_tokens(const std::string& text, const std::string& file) {
    return Scanner(text, file).tokens();
}

}  // namespace dmp::geometry
