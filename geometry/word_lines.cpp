// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/word_lines.hpp"

#include <charconv>
#include <limits>
#include <system_error>

namespace dmp::geometry {

namespace {

std::string_view without_plus(std::string_view word) {
    return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace

bool TokenLines::next() {
    words_.clear();
    if (rest_.empty()) return false;
    for (bool more = true; more && !rest_.empty();) {
        const std::size_t end = rest_.find('\n');
        line_ = rest_.substr(0, end);
        rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
        ++number_;
        if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
        std::string_view text = comment_ == '\0' ? line_ : line_.substr(0, line_.find(comment_));
        more = goes_on_ && !text.empty() && text.back() == '\\';
        if (more) text.remove_suffix(1);
        for (std::size_t at = 0; (at = text.find_first_not_of(" \t\v\f\r", at)) != std::string_view::npos;) {
            const std::size_t stop = text.find_first_of(" \t\v\f\r", at);
            words_.push_back(text.substr(at, stop == std::string_view::npos ? stop : stop - at));
            if (stop == std::string_view::npos) break;
            at = stop;
        }
    }
    return true;
}

bool TokenLines::next_with_tokens() {
    while (next())
        if (!words_.empty()) return true;
    return false;
}

std::string in_quotes(std::string_view text, char mark) {
    constexpr std::size_t longest = 60;
    std::string shown(1, mark);
    for (const char c : text.substr(0, longest)) shown += c == '\t' ? ' ' : c < ' ' || c > '~' ? '?' : c;
    return shown + (text.size() > longest ? "..." : "") + mark;
}

std::optional<double> number_in(std::string_view word) {
    word = without_plus(word);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || end != word.data() + word.size() || error == std::errc::invalid_argument) return std::nullopt;
    if (error == std::errc::result_out_of_range)  // the digits before the exponent decide: too large, or as good as 0
        return word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos
                   ? 0
                   : std::numeric_limits<double>::infinity();
    return value;
}

std::optional<long long> whole_number_in(std::string_view word) {
    word = without_plus(word);
    long long value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || end != word.data() + word.size() || error != std::errc{}) return std::nullopt;
    return value;
}

}  // namespace dmp::geometry
