// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/check_script.hpp"

#include <algorithm>
#include <set>

#include "geometry/script_words.hpp"

namespace dmp::geometry {

namespace {

/// Looks at each token and its neighbours.
class Checker {
  public:
    Checker(const std::vector<ScriptToken>& tokens, const std::vector<std::string>& files)
        : tokens_(tokens), files_(files) {
        for (std::size_t i = 0; i + 1 < tokens.size(); ++i)
            if (tokens[i].is_word("Struct") && !is_option_category(tokens[i + 1].text))
                structures_.insert(tokens[i + 1].text);
        has_blocks_ = std::ranges::any_of(tokens, [](const ScriptToken& token) {
            return token.is_word("If") || token.is_word("For") || token.is_word("Macro") || token.is_word("Function");
        });
    }

    void check() const {
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (tokens_[i].kind == TokenKind::word) {
                check_word(i);
                if (tokens_[i].text == "Printf") check_printf(i);
                if (tokens_[i].text == "Field") check_field(i);
            } else if (tokens_[i].kind == TokenKind::text) {
                check_text(i);
            } else if (tokens_[i].is_symbol('.')) {
                check_option(i);
            }
        }
    }

  private:
    [[nodiscard]] const ScriptToken* token(std::size_t i) const { return i < tokens_.size() ? &tokens_[i] : nullptr; }
    [[nodiscard]] bool is_symbol(std::size_t i, char symbol) const { return token(i) && tokens_[i].is_symbol(symbol); }

    [[nodiscard]] SourceLocation where(std::size_t i) const {
        const ScriptToken& at = tokens_[i];
        return {.file = files_.at(static_cast<std::size_t>(at.file)), .line = at.line, .column = at.column};
    }
    [[noreturn]] void refuse(std::size_t i, const std::string& word, std::string_view harm) const {
        throw harm_in_script(where(i), word, std::string(harm));
    }

    void check_word(std::size_t i) const {
        const std::string& word = tokens_[i].text;
        if (const auto harm = harm_of_word(word); !harm.empty()) refuse(i, word, harm);
        const std::string_view within = block_word_within(word);
        if (!within.empty() && within != word && has_blocks_) refuse_block_word(i, within);
        const ScriptToken* next = token(i + 1);
        if (next == nullptr) return;
        if (next->kind == TokenKind::word || next->kind == TokenKind::text)
            if (const auto harm = harm_of_command(word); !harm.empty()) refuse(i, word, harm);
        if (word == "View" && next->kind == TokenKind::text) refuse(i, word, "make a view, which is no geometry");
        if (word == "Delete" && (next->is_word("Options") || next->is_word("All")))
            refuse(i, word + " " + next->text, "undo what dmp has set up");
        const bool text_follows =
            next->kind == TokenKind::text || (next->kind == TokenKind::word && begins_a_text(next->text));
        if (text_follows && !takes_a_text(word) && !begins_a_text(word) && !stands_after_comma(i))
            refuse(i, word, "do what dmp does not know to be harmless: it is no command that describes a geometry");
    }

    /// On one line: gmsh can begin a statement at any line.
    [[nodiscard]] bool stands_after_comma(std::size_t i) const {
        return i > 0 && is_symbol(i - 1, ',') && tokens_[i - 1].line == tokens_[i].line &&
               tokens_[i - 1].file == tokens_[i].file;
    }

    [[noreturn]] void refuse_block_word(std::size_t i, std::string_view word) const {
        throw InputError(where(i),
                         "'" + tokens_[i].text + "' holds the word '" + std::string(word) +
                             "', at which gmsh may go on as if the rest were statements",
                         "Use another word there.");
    }

    void check_text(std::size_t i) const {
        const std::string_view within = block_word_within(tokens_[i].text);
        if (!within.empty() && has_blocks_) refuse_block_word(i, within);
    }

    /// Printf(...) > "file" and >> "file".
    void check_printf(std::size_t i) const {
        if (!is_symbol(i + 1, '(')) refuse(i, "Printf", "write a file, unless a bracket follows");
        const std::size_t end = closing(i + 1);
        if (token(end) != nullptr && !is_symbol(end + 1, ';')) refuse(i, "Printf", "write what it says into a file");
    }

    /// Field[1] = TYPE.
    void check_field(std::size_t i) const {
        if (!is_symbol(i + 1, '[')) return;
        const std::size_t end = closing(i + 1);
        if (!is_symbol(end + 1, '=') || token(end + 2) == nullptr) return;
        const ScriptToken& type = tokens_[end + 2];
        if (type.kind != TokenKind::word || !is_harmless_field(type.text))
            refuse(end + 2, type.text,
                   "be a field that dmp does not know to be harmless: others read files or run programs");
    }

    /// CATEGORY.NAME: options of gmsh; members of structures are written alike.
    void check_option(std::size_t i) const {
        const ScriptToken* name = token(i + 1);
        if (name == nullptr || name->kind != TokenKind::word) return;
        if (i == 0) refuse(i, "." + name->text, "set an option");
        const ScriptToken& category = tokens_[i - 1];
        const std::string option = category.text + "." + name->text;
        constexpr const char* harm = "set or read an option that is none of a geometry's: some hold commands and files";
        if (category.is_symbol(']')) {
            const std::size_t begin = opening(i - 1);
            if (begin == 0 || !tokens_[begin - 1].is_word("Field")) refuse(i + 1, name->text, harm);
            return;
        }
        if (category.kind != TokenKind::word) refuse(i + 1, option, harm);
        const bool is_color = category.text == "Color" && i >= 2 && is_symbol(i - 2, '.');
        if (!is_color && !structures_.contains(category.text) && !is_harmless_option(category.text, name->text))
            refuse(i - 1, option, harm);
    }

    /// The bracket that closes the one at i, of whichever kind; past the end where none does.
    [[nodiscard]] std::size_t closing(std::size_t i) const {
        int depth = 0;
        for (; i < tokens_.size(); ++i) {
            if (is_symbol(i, '(') || is_symbol(i, '[') || is_symbol(i, '{')) ++depth;
            if ((is_symbol(i, ')') || is_symbol(i, ']') || is_symbol(i, '}')) && --depth == 0) return i;
        }
        return i;
    }
    /// The bracket that opens the one at i; 0 where none does.
    [[nodiscard]] std::size_t opening(std::size_t i) const {
        int depth = 0;
        for (; i > 0; --i) {
            if (is_symbol(i, ')') || is_symbol(i, ']') || is_symbol(i, '}')) ++depth;
            if ((is_symbol(i, '(') || is_symbol(i, '[') || is_symbol(i, '{')) && --depth == 0) return i;
        }
        return 0;
    }

    const std::vector<ScriptToken>& tokens_;
    const std::vector<std::string>& files_;
    std::set<std::string> structures_;
    bool has_blocks_ = false;
};

}  // namespace

InputError harm_in_script(const SourceLocation& where, const std::string& word, const std::string& harm) {
    return {where, "'" + word + "' would " + harm + ", which a geometry may not",
            "Remove it. If you know who wrote it and want it done, add --trust-geometry on the command line."};
}

void check_script(const std::vector<ScriptToken>& tokens, const std::vector<std::string>& files) {
    Checker(tokens, files).check();
}

}  // namespace dmp::geometry
