// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/shell_word.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace dmp {

std::string shell_word(const std::string& word) {
    constexpr std::string_view plain = "_-./=,:+@%";
    const auto needs_none = [&](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || plain.find(c) != std::string_view::npos;
    };
    if (!word.empty() && std::ranges::all_of(word, needs_none)) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string(R"('\'')") : std::string(1, c);
    return quoted + "'";
}

std::string quoted_command(const std::string& command, const std::string& file) {
    const std::string word = shell_word(file);
    return word == file ? "'" + command + " " + file + "'" : command + " " + word;
}

}  // namespace dmp
