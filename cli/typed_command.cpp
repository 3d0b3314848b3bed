// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/typed_command.hpp"

#include <algorithm>
#include <utility>

namespace dmp::cli {

namespace {

const std::vector<std::string> exclusive{"--resume", "--overwrite", "--dry-run"};

std::string line_of(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) line += (line.empty() ? "" : " ") + shell_word(word);
    return line;
}

}  // namespace

std::string TypedCommand::text() const { return line_of(words_); }

TypedCommand TypedCommand::on_ranks(int ranks) const {
    if (ranks <= 1) return *this;
    std::vector<std::string> words{"mpirun", "-n", std::to_string(ranks)};
    words.insert(words.end(), words_.begin(), words_.end());
    return TypedCommand(std::move(words));
}

std::vector<std::string> TypedCommand::without(const std::vector<std::string>& flags, const std::string& option) const {
    std::vector<std::string> kept;
    for (std::size_t k = 0; k < words_.size(); ++k) {
        const std::string& word = words_[k];
        if (std::ranges::find(flags, word) != flags.end()) continue;
        if (!option.empty() && word.starts_with(option + "=")) continue;
        if (!option.empty() && word == option) {
            ++k;
            continue;
        }
        kept.push_back(word);
    }
    return kept;
}

std::string TypedCommand::with(const std::string& option) const {
    std::vector<std::string> words = without(exclusive, option == "--resume" ? "--from" : "");
    words.push_back(option);
    return line_of(words);
}

std::string TypedCommand::into(const std::filesystem::path& folder) const {
    std::vector<std::string> words = without(exclusive, "--out");
    words.insert(words.end(), {"--out", folder.string()});
    return line_of(words);
}

std::filesystem::path next_free(const std::filesystem::path& folder) {
    // "out/" is the folder "out".
    const auto base = folder.has_filename() ? folder : folder.parent_path();
    std::error_code unknown;
    for (int number = 2;; ++number) {
        std::filesystem::path next = base.string() + "_" + std::to_string(number);
        if (!std::filesystem::exists(std::filesystem::symlink_status(next, unknown))) return next;
    }
}

}  // namespace dmp::cli
