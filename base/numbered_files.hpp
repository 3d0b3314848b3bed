// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dmp {

/// Files of one kind in a folder that are told apart by a number in their names: frame_000012.h5.
class NumberedFiles {
  public:
    /// Numbers are filled up with zeros to `digits`; longer ones are as long as they are.
    NumberedFiles(std::string prefix, int digits, std::string ending)
        : prefix_(std::move(prefix)), digits_(digits), ending_(std::move(ending)) {}

    [[nodiscard]] std::string name(long number) const;
    /// None for names that are not of this kind.
    [[nodiscard]] std::optional<long> number(const std::string& name) const;

    /// Those in the folder, by number; none where there is no folder. Throws InputError when it cannot be looked into.
    [[nodiscard]] std::map<long, std::filesystem::path> in(const std::filesystem::path& folder) const;
    /// Those that were begun under another name (unfinished_name) and left so. Throws like in().
    [[nodiscard]] std::vector<std::filesystem::path> unfinished_in(const std::filesystem::path& folder) const;

  private:
    std::string prefix_;
    int digits_;
    std::string ending_;
};

/// Throws ResourceError when a file that is there cannot be removed.
void remove_file(const std::filesystem::path& file);

}  // namespace dmp
