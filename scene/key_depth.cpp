// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/key_depth.hpp"

#include <algorithm>
#include <cctype>

#include "base/errors.hpp"

namespace dmp::scene {

namespace {

constexpr int most_dots = 32;

bool may_stand_in_key(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("._- \t").find(c) != std::string_view::npos;
}

/// The first character behind the quoted text that begins at `at`; of one without an end, the end of its line or text.
std::size_t end_of_text(std::string_view text, std::size_t at) {
    const char quote = text[at];
    const std::string three(3, quote);
    const bool several_lines = text.substr(at).starts_with(three);
    for (at += several_lines ? 3 : 1; at < text.size(); ++at) {
        if (text[at] == '\\' && quote == '"') {
            ++at;
        } else if (several_lines) {
            if (text.substr(at).starts_with(three)) return at + 3;
        } else if (text[at] == quote) {
            return at + 1;
        } else if (text[at] == '\n') {
            return at;
        }
    }
    return text.size();
}

}  // namespace

void check_key_depth(std::string_view text, const std::string& file) {
    int dots = 0;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '"' || c == '\'') {
            at = end_of_text(text, at);
            continue;
        }
        if (c == '#') {
            at = std::min(text.find('\n', at), text.size());
            continue;
        }
        if (!may_stand_in_key(c)) dots = 0;
        if (c == '.' && ++dots > most_dots) {
            const std::string_view before = text.substr(0, at);
            const auto line = static_cast<int>(std::ranges::count(before, '\n')) + 1;
            const auto line_begin = before.rfind('\n') + 1;  // 0 on the first line
            throw InputError({file, line, static_cast<int>(at - line_begin) + 1},
                             "a key of more than " + std::to_string(most_dots) + " parts",
                             "no key of a scene has more than five; correct the line");
        }
        ++at;
    }
}

}  // namespace dmp::scene
