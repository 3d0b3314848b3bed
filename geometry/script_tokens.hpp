// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace dmp::geometry {

/// What gmsh's scanner makes of a script's characters (Gmsh.l of gmsh 4.8).
enum class TokenKind { word, number, text, symbol };

struct ScriptToken {
    TokenKind kind = TokenKind::symbol;
    std::string text;     ///< as it stands in the script; of a text without its quotes
    char quote = 0;       ///< of a text: which of the two kinds of quote
    bool spaced = false;  ///< whether something (a space, a comment, a line break) stands before it
    int file = 0;         ///< which of the script's files, where there are several
    int line = 0, column = 0;

    [[nodiscard]] bool is_word(const char* word) const { return kind == TokenKind::word && text == word; }
    [[nodiscard]] bool is_symbol(char symbol) const { return kind == TokenKind::symbol && text[0] == symbol; }
};

/// The tokens of a script without its comments. Symbols of several characters are several tokens.
///
/// Throws InputError for what makes gmsh take texts or comments for statements, or the other way round: a text that
/// goes on in the next line or is longer than gmsh's buffer, a comment without its end, a zero byte, and a file that
/// begins as a mesh does.
[[nodiscard]] std::vector<ScriptToken> script_tokens(const std::string& text, const std::string& file);

}  // namespace dmp::geometry
