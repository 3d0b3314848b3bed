// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/geo_text.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

namespace dmp::geometry {

namespace {

bool is_word_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string without_comments_and_strings(const std::string& text) {
    std::string code = text;
    const auto blank = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < std::min(to, code.size()); ++i) {
            if (code[i] != '\n') code[i] = ' ';
        }
        return to;
    };
    const auto after = [&](std::string_view end, std::size_t from) {
        const std::size_t found = text.find(end, from);
        return found == std::string::npos ? text.size() : found + end.size();
    };
    for (std::size_t i = 0; i < text.size();) {
        if (text.compare(i, 2, "//") == 0) {
            i = blank(i, after("\n", i));
        } else if (text.compare(i, 2, "/*") == 0) {
            i = blank(i, after("*/", i + 2));
        } else if (text[i] == '"') {
            i = blank(i, after("\"", i + 1));
        } else {
            ++i;
        }
    }
    return code;
}

/// Calls visit(word, index after it, line) for each word of the code.
template <class Visit>
void for_each_word(const std::string& code, Visit&& visit) {
    int line = 1;
    for (std::size_t i = 0; i < code.size();) {
        if (!is_word_character(code[i])) {
            if (code[i++] == '\n') ++line;
            continue;
        }
        std::size_t end = i;
        while (end < code.size() && is_word_character(code[end])) ++end;
        visit(std::string_view(code).substr(i, end - i), end, line);
        i = end;
    }
}

}  // namespace

GeoText::GeoText(const std::string& text) : code_(without_comments_and_strings(text)) {}

int GeoText::line_of_assignment(const std::string& name) const {
    int found = 0;
    for_each_word(code_, [&](std::string_view word, std::size_t end, int line) {
        if (found != 0 || word != name) return;
        const std::size_t next = code_.find_first_not_of(" \t\r\n", end);
        const bool assigned = next != std::string::npos && code_[next] == '=' && code_.compare(next, 2, "==") != 0;
        if (assigned) found = line;
    });
    return found;
}

std::optional<GeoText::Unclosed> GeoText::unclosed_block() const {
    std::vector<Unclosed> open;
    std::optional<Unclosed> orphan;
    for_each_word(code_, [&](std::string_view word, std::size_t, int line) {
        if (orphan) return;
        if (word == "If" || word == "For") open.push_back({.word = std::string(word), .line = line});
        if (word != "EndIf" && word != "EndFor") return;
        if (open.empty() || "End" + open.back().word != word) {
            orphan = Unclosed{.word = std::string(word), .line = line};
        } else {
            open.pop_back();
        }
    });
    if (orphan) return orphan;
    if (!open.empty()) return open.back();
    return std::nullopt;
}

int GeoText::line_cut_short() const {
    const std::size_t line_break = code_.rfind('\n');
    const std::size_t last = line_break == std::string::npos ? 0 : line_break + 1;
    const std::size_t semicolon = code_.find(';', last);
    if (semicolon == std::string::npos) return 0;
    const bool more = code_.find_first_not_of(" \t\r", semicolon + 1) != std::string::npos;
    return more ? static_cast<int>(std::ranges::count(code_, '\n')) + 1 : 0;
}

}  // namespace dmp::geometry
