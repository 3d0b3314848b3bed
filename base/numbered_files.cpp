// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/numbered_files.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "base/errors.hpp"
#include "base/safe_file.hpp"

namespace dmp {

namespace fs = std::filesystem;

namespace {

/// All there is in the folder; nothing where there is no folder.
std::vector<fs::path> entries(const fs::path& folder) {
    std::error_code failed;
    std::vector<fs::path> paths;
    if (!fs::exists(folder, failed) && !failed) return paths;
    fs::directory_iterator entry(folder, failed);
    for (; !failed && entry != fs::directory_iterator(); entry.increment(failed)) paths.push_back(entry->path());
    if (failed)
        throw InputError(SourceLocation{folder.string(), 0, 0}, "cannot be looked into: " + failed.message(),
                         "Check that it is a folder and that you may read it.");
    return paths;
}

}  // namespace

std::string NumberedFiles::name(long number) const {
    const std::string digits = std::to_string(number);
    const auto zeros = static_cast<std::size_t>(digits_) - std::min(digits.size(), static_cast<std::size_t>(digits_));
    return prefix_ + std::string(zeros, '0') + digits + ending_;
}

std::optional<long> NumberedFiles::number(const std::string& name) const {
    if (!name.starts_with(prefix_) || name.size() < prefix_.size() + ending_.size()) return {};
    long number = 0;
    const auto [end, failed] = std::from_chars(name.data() + prefix_.size(), name.data() + name.size(), number);
    if (failed != std::errc() || number < 0 || name != this->name(number)) return {};
    return number;
}

std::map<long, fs::path> NumberedFiles::in(const fs::path& folder) const {
    std::map<long, fs::path> found;
    for (const fs::path& path : entries(folder))
        if (const auto its_number = number(path.filename().string())) found.emplace(*its_number, path);
    return found;
}

std::vector<fs::path> NumberedFiles::unfinished_in(const fs::path& folder) const {
    std::vector<fs::path> found;
    for (const fs::path& path : entries(folder))
        if (const auto finished = finished_name(path); finished && number(finished->filename().string()))
            found.push_back(path);
    return found;
}

void remove_file(const fs::path& file) {
    std::error_code failed;
    fs::remove(file, failed);
    if (failed)
        throw ResourceError("cannot remove '" + file.string() + "': " + failed.message(),
                            "Check that you may write to its folder.");
}

}  // namespace dmp
