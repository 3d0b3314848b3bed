// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/checked_script.hpp"

#include <algorithm>
#include <filesystem>

#include "geometry/check_script.hpp"
#include "geometry/endless_script.hpp"
#include "geometry/geometry_file.hpp"
#include "geometry/script_tokens.hpp"

namespace dmp::geometry {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t deepest_include = 20, most_files = 1000, most_tokens = 50'000'000;

/// The tokens of a script with those of the files that it includes in their places.
class Includes {
  public:
    explicit Includes(const std::string& file) : folder_(fs::canonical(file).parent_path()) {
        add(fs::canonical(file), file);
    }

    std::vector<ScriptToken> tokens;
    std::vector<std::string> files;

  private:
    /// Reads `path`, without links in it: what was checked to lie in the folder. `file`: its name for the user.
    void add(const fs::path& path, const std::string& file) {
        const int number = static_cast<int>(files.size());
        files.push_back(file);
        open_.push_back(path);
        std::vector<ScriptToken> own = script_tokens(file_text(path.string()), file);
        for (ScriptToken& token : own) token.file = number;
        for (std::size_t i = 0; i < own.size(); ++i) {
            const bool includes = (own[i].is_word("Include") || own[i].is_word("Merge")) && i + 2 < own.size() &&
                                  own[i + 1].kind == TokenKind::text && own[i + 2].is_symbol(';');
            if (includes) {
                const SourceLocation where{.file = file, .line = own[i].line, .column = own[i].column};
                const fs::path named = fs::path(file).parent_path() / own[i + 1].text;  // absolute names stay
                add(included(named, own[i].text, own[i + 1].text, where), named.lexically_normal().string());
                i += 2;
            } else {
                tokens.push_back(own[i]);
            }
            if (tokens.size() > most_tokens || files.size() > most_files)
                throw InputError({.file = file}, "the script and what it includes are too large to check",
                                 "Describe it in fewer statements, or save it as a mesh or a STEP file.");
        }
        open_.pop_back();
    }

    /// The file that a script names, which must lie in its folder and be a script.
    [[nodiscard]] fs::path included(const fs::path& named, const std::string& word, const std::string& name,
                                    const SourceLocation& where) const {
        std::error_code error;
        const fs::path file = fs::canonical(named, error);
        if (error)
            throw InputError(where, "'" + word + "' names the file '" + name + "', which cannot be found",
                             "Put it beside the geometry, or correct its name.");
        const auto [end, rest] = std::ranges::mismatch(folder_, file);
        if (end != folder_.end())
            throw harm_in_script(where, word, "read '" + name + "', which lies outside the folder of the geometry");
        if (!fs::is_regular_file(file, error))
            throw harm_in_script(where, word, "read '" + name + "', which is no ordinary file");
        if (word == "Merge" && !is_script(name))
            throw harm_in_script(where, word, "read '" + name + "' with another of gmsh's readers");
        if (std::ranges::find(open_, file) != open_.end() || open_.size() >= deepest_include)
            throw InputError(where, "'" + word + "' of '" + name + "' has no end: it includes itself",
                             "Remove it from the file that is included.");
        return file;
    }

    fs::path folder_;             ///< nothing outside is read
    std::vector<fs::path> open_;  ///< those that are being read, each included by the one before
};

/// The symbol at which the head of a block or a call is complete, after which gmsh notes where to jump back to: only
/// the end of a line may follow, as it notes the end of what it has read by then.
std::size_t end_of_head(const std::vector<ScriptToken>& tokens, std::size_t i) {
    const ScriptToken& word = tokens[i];
    if (word.is_word("Call")) {
        while (i < tokens.size() && !tokens[i].is_symbol(';')) ++i;
        return i;
    }
    if (word.is_word("Macro") || word.is_word("Function")) return i + 1;
    if (!word.is_word("For")) return tokens.size();
    int depth = 0;
    for (++i; i < tokens.size(); ++i) {
        if (tokens[i].is_symbol('(') || tokens[i].is_symbol('{')) ++depth;
        if ((tokens[i].is_symbol(')') || tokens[i].is_symbol('}')) && --depth == 0) return i;
    }
    return i;
}

}  // namespace

CheckedScript::CheckedScript(const std::string& file) {
    Includes read(file);
    files_ = std::move(read.files);
    check_script(read.tokens, files_);
    check_that_it_ends(read.tokens, files_);
    std::size_t line_ends_after = read.tokens.size();
    for (std::size_t i = 0; i < read.tokens.size(); ++i) {
        const ScriptToken& token = read.tokens[i];
        const bool new_line = places_.empty() || places_.back().file != token.file ||
                              places_.back().line != token.line || (i > 0 && i - 1 == line_ends_after);
        if (new_line) {
            if (!places_.empty()) text_ += '\n';
            places_.push_back({token.file, token.line});
        } else if (token.spaced) {
            text_ += ' ';
        }
        if (token.quote != 0) text_ += token.quote;
        text_ += token.text;
        if (token.quote != 0) text_ += token.quote;
        if (const std::size_t end = end_of_head(read.tokens, i); end < read.tokens.size()) line_ends_after = end;
    }
    text_ += '\n';
}

SourceLocation CheckedScript::written_at(int line) const {
    if (places_.empty()) return {.file = files_.front()};
    const auto index = static_cast<std::size_t>(std::max(line - 1, 0));
    const Place& place = places_[std::min(index, places_.size() - 1)];
    return {.file = files_[static_cast<std::size_t>(place.file)], .line = place.line};
}

}  // namespace dmp::geometry
