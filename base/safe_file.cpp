// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/safe_file.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/errors.hpp"

namespace dmp {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view unfinished_start = ".", unfinished_end = ".unfinished";

std::string system_text(int error) { return std::generic_category().message(error); }

/// Writes everything, whatever the number of calls it takes; 0 or the errno of the failure.
int write_all(int descriptor, std::string_view content) {
    while (!content.empty()) {
        const ssize_t written = ::write(descriptor, content.data(), content.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        content.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

std::string megabytes(std::uintmax_t bytes) { return std::to_string(bytes / 1'000'000) + " MB"; }

/// The folder that holds `file`.
fs::path folder_of(const fs::path& file) { return file.parent_path().empty() ? fs::path(".") : file.parent_path(); }

/// Waits until the disk has the file or folder; 0 or the errno of the failure.
int sync_to_disk(const fs::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return errno;
    const int error = ::fsync(descriptor) == 0 ? 0 : errno;
    ::close(descriptor);
    return error;
}

/// ", 12 MB free on the disk, files limited to 3 MB"
std::string room_left(const fs::path& file) {
    std::string text;
    std::error_code failed;
    const fs::space_info space = fs::space(folder_of(file), failed);
    if (!failed) text += "; " + megabytes(space.available) + " free on that disk";
    rlimit limit{};
    if (getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        text += "; files are limited to " + megabytes(limit.rlim_cur) + " (ulimit -f)";
    return text;
}

/// Links are followed: one to a device stands for the device.
void refuse_what_is_no_file(const fs::path& file) {
    std::error_code unknown;
    const fs::file_status there = fs::status(file, unknown);
    if (!fs::exists(there) || fs::is_regular_file(there)) return;
    throw InputError({file.string()},
                     "this is no file, but " + std::string(fs::is_directory(there) ? "a folder" : "a device or pipe") +
                         ", which dmp would replace by a file",
                     "Give the name of a file, or of one that is not there yet.");
}

}  // namespace

void check_output_file(const fs::path& file) {
    make_folder(folder_of(file));
    refuse_what_is_no_file(file);
}

void check_output_folder(const fs::path& folder) {
    std::error_code unknown;
    fs::path above = folder;  // as it was given, for the message
    while (!above.empty() && !fs::exists(above, unknown)) above = above.parent_path();
    if (above.empty()) above = ".";
    if (!fs::is_directory(above, unknown))
        throw InputError("output folder '" + folder.string() + "' cannot be made: '" + above.string() + "' is a file",
                         "Name a folder that does not run through a file, or move the file away.");
    if (::access(above.c_str(), W_OK | X_OK) != 0)
        throw InputError("output folder '" + folder.string() + "' cannot be made or written to: " + system_text(errno),
                         "Name a folder you may write to.");
}

void make_folder(const fs::path& folder) {
    check_output_folder(folder);
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (!failed && fs::is_directory(folder, failed) && ::access(folder.c_str(), W_OK | X_OK) == 0) return;
    const std::string reason = failed ? failed.message() : system_text(EACCES);
    throw InputError("output folder '" + folder.string() + "' cannot be made or written to: " + reason,
                     "Name a folder you may write to.");
}

void throw_write_error(const fs::path& file, const std::string& reason) {
    throw ResourceError("cannot write '" + file.string() + "': " + reason + room_left(file),
                        "Free some room or raise the limit, or choose another output folder, then run again. "
                        "What was written before is whole.");
}

fs::path unfinished_name(const fs::path& file) {
    return file.parent_path() /
           (std::string(unfinished_start) + file.filename().string() + std::string(unfinished_end));
}

std::optional<fs::path> finished_name(const fs::path& unfinished) {
    const std::string name = unfinished.filename().string();
    if (!name.starts_with(unfinished_start) || !name.ends_with(unfinished_end) ||
        name.size() <= unfinished_start.size() + unfinished_end.size())
        return {};
    return unfinished.parent_path() /
           name.substr(unfinished_start.size(), name.size() - unfinished_start.size() - unfinished_end.size());
}

void rename_durably(const fs::path& unfinished, const fs::path& file) {
    refuse_what_is_no_file(file);
    int error = sync_to_disk(unfinished);
    if (error == 0 && ::rename(unfinished.c_str(), file.c_str()) != 0) error = errno;
    if (error != 0) throw_write_error(file, system_text(error));
    // Folders that cannot be synced (EINVAL) or not be listed (EACCES) leave that to the file system.
    error = sync_to_disk(folder_of(file));
    if (error != 0 && error != EINVAL && error != EACCES) throw_write_error(folder_of(file), system_text(error));
}

void write_file(const fs::path& file, std::string_view content) {
    refuse_what_is_no_file(file);
    const fs::path unfinished = unfinished_name(file);
    const int descriptor = ::open(unfinished.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0) throw_write_error(file, system_text(errno));
    int error = write_all(descriptor, content);
    if (::close(descriptor) != 0 && error == 0) error = errno;
    if (error == 0 && ::rename(unfinished.c_str(), file.c_str()) != 0) error = errno;
    if (error != 0) {
        ::unlink(unfinished.c_str());
        throw_write_error(file, system_text(error));
    }
}

void append_to_file(const fs::path& file, std::string_view content) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    if (descriptor < 0) throw_write_error(file, system_text(errno));
    int error = write_all(descriptor, content);
    if (::close(descriptor) != 0 && error == 0) error = errno;
    if (error != 0) throw_write_error(file, system_text(error));
}

std::string read_file(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream || fs::is_directory(file))
        throw InputError("cannot read '" + file.string() + "'",
                         "Check the name; the folder of a finished run holds summary.json, measures.csv, *.pvd.");
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace dmp
