// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace dmp {

/// Makes the folder and those above it. Throws InputError when it cannot be made or written to.
void make_folder(const std::filesystem::path& folder);

/// Throws the InputError of make_folder where that is certain to fail, and makes nothing. To be called before long
/// work.
void check_output_folder(const std::filesystem::path& folder);

/// Throws InputError where `file` cannot be written as a file: its folder cannot be made or written to, or something
/// else than a file has its name (a device, a pipe, a folder), which renaming would replace. Makes the folder. To be
/// called before long work.
void check_output_file(const std::filesystem::path& file);

/// Replaces `file` by `content` in one go: whoever reads it sees the old file or the new one, never a part.
/// Throws ResourceError when it cannot; the old file then stays as it was. InputError where no file has its name, but a
/// device, a pipe or a folder.
void write_file(const std::filesystem::path& file, std::string_view content);

/// Adds to the end of a file that is there, in one go. Throws ResourceError if it cannot be written.
void append_to_file(const std::filesystem::path& file, std::string_view content);

/// The name `file` is written under until it is whole: in the same folder, so that the renaming is one step.
[[nodiscard]] std::filesystem::path unfinished_name(const std::filesystem::path& file);

/// The inverse of unfinished_name; none for other names.
[[nodiscard]] std::optional<std::filesystem::path> finished_name(const std::filesystem::path& unfinished);

/// Gives the whole file `unfinished` the name `file`, in one go and so that a power cut leaves the old or the new one.
/// Throws ResourceError, which names `file`, or InputError as write_file does; `unfinished` then stays as it was.
void rename_durably(const std::filesystem::path& unfinished, const std::filesystem::path& file);

/// Throws the ResourceError for `file` that could not be written: the reason if known, the room left, what to do.
[[noreturn]] void throw_write_error(const std::filesystem::path& file, const std::string& reason);

/// The whole file. Throws InputError when it cannot be read.
std::string read_file(const std::filesystem::path& file);

}  // namespace dmp
