// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/shell_word.hpp"

namespace dmp::cli {

/// The command line that the user typed, for lines to paste that change it.
class TypedCommand {
  public:
    TypedCommand() = default;
    /// The program's name as it was called, the command, and its options.
    explicit TypedCommand(std::vector<std::string> words) : words_(std::move(words)) {}

    /// The program, as it was called.
    [[nodiscard]] std::string program() const { return words_.empty() ? "dmp" : shell_word(words_.front()); }

    /// The line itself.
    [[nodiscard]] std::string text() const;
    /// With this many ranks; 1: without mpirun.
    [[nodiscard]] TypedCommand on_ranks(int ranks) const;

    /// The line with this option and without those that exclude it: --resume, --overwrite, --dry-run; a run that is
    /// resumed has its start behind it, so --resume takes --from away, too.
    [[nodiscard]] std::string with(const std::string& option) const;
    /// The line with the results in another folder.
    [[nodiscard]] std::string into(const std::filesystem::path& folder) const;

  private:
    /// Without these flags, and without an option that has a value ("": none).
    [[nodiscard]] std::vector<std::string> without(const std::vector<std::string>& flags,
                                                   const std::string& option) const;

    std::vector<std::string> words_;
};

/// The first of folder_2, folder_3, ... that is not there.
[[nodiscard]] std::filesystem::path next_free(const std::filesystem::path& folder);

}  // namespace dmp::cli
