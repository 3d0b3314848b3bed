// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace dmp {

/// Makes the folder and those above it. Throws InputError when it cannot be made or written to.
void make_folder(const std::filesystem::path& folder);

/// Replaces `file` by `content` in one go: whoever reads it sees the old file or the new one, never a part.
/// Throws ResourceError when it cannot; the old file then stays as it was.
void write_file(const std::filesystem::path& file, std::string_view content);

/// Throws the ResourceError for `file` that could not be written: the reason if known, the room left, what to do.
[[noreturn]] void throw_write_error(const std::filesystem::path& file, const std::string& reason);

/// The whole file. Throws InputError when it cannot be read.
std::string read_file(const std::filesystem::path& file);

}  // namespace dmp
