// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/geometry_source.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <string_view>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "geometry/geo_text.hpp"
#include "geometry/geometry_file.hpp"

namespace dmp::geometry {

namespace {

std::string path_of(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

int file_in_memory(const std::string& text) {
    const int file = memfd_create("dmp_script", MFD_CLOEXEC);
    std::string_view left = text;
    while (file >= 0 && !left.empty()) {
        const ssize_t count = ::write(file, left.data(), left.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) break;
        left.remove_prefix(static_cast<std::size_t>(count));
    }
    if (file < 0 || !left.empty())
        throw ResourceError(std::string("a script cannot be kept in memory: ") + std::strerror(errno),
                            "Free memory, and try again.");
    return file;
}

/// The first bytes of an open file.
std::string beginning_of(int descriptor) {
    std::array<char, 4096> buffer{};
    const ssize_t count = ::pread(descriptor, buffer.data(), buffer.size(), 0);
    return count > 0 ? std::string(buffer.data(), static_cast<std::size_t>(count)) : std::string();
}

/// gmsh knows a mesh by how it begins, and takes all else for a script.
void check_mesh(const std::string& file, const std::string& beginning) {
    constexpr auto beginnings =
        std::to_array<std::string_view>({"$MeshFormat", "$Comments", "$NOD", "$NOE", "$PTS", "$PARA", "$ELM"});
    if (std::ranges::any_of(beginnings, [&](std::string_view words) { return beginning.starts_with(words); })) return;
    throw InputError({.file = file, .line = 1}, "this is no mesh of gmsh: it does not begin with $MeshFormat",
                     "Save the mesh again; name a gmsh script .geo.");
}

}  // namespace

GeometrySource::GeometrySource(const GeometryOptions& options) : file_(options.file), path_(options.file) {
    empty_descriptor_ = file_in_memory("//\n");
    empty_script_ = path_of(empty_descriptor_);
    if (is_script(file_) && options.trust == Trust::none) {
        script_.emplace(file_);
        descriptor_ = file_in_memory(script_->text());
        path_ = path_of(descriptor_);
        return;
    }
    descriptor_ = ::open(file_.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (descriptor_ < 0) throw InputError({.file = file_}, "the geometry cannot be read", "Check its permissions.");
    if (options.trust == Trust::unchecked) return;
    if (is_script(file_)) {
        std::error_code error;
        if (std::filesystem::exists(file_ + ".opt", error))
            throw InputError({.file = file_ + ".opt"}, "gmsh would do what this file of options says",
                             "Move it elsewhere, or rename it.");
        return;
    }
    if (!is_cad_file(file_)) check_mesh(file_, beginning_of(descriptor_));
    path_ = path_of(descriptor_);
}

GeometrySource::~GeometrySource() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (empty_descriptor_ >= 0) ::close(empty_descriptor_);
}

SourceLocation GeometrySource::assignment_of(const std::string& name) const {
    const int line = GeoText(script_ ? script_->text() : file_text(file_)).line_of_assignment(name);
    if (script_ && line > 0) return script_->written_at(line);
    return {.file = file_, .line = line};
}

std::string GeometrySource::in_users_words(std::string message) const {
    if (path_ == file_) return message;
    constexpr std::string_view before_line = "', line ";
    for (std::size_t at = message.find(path_); at != std::string::npos; at = message.find(path_, at)) {
        std::size_t end = at + path_.size();
        if (end < message.size() && message[end] >= '0' && message[end] <= '9') {  // another file's number
            at = end;
            continue;
        }
        std::string name = file_;
        if (script_ && message.compare(end, before_line.size(), before_line) == 0) {
            int line = 0;
            const char* digits = message.data() + end + before_line.size();
            const char* digits_end = std::from_chars(digits, message.data() + message.size(), line).ptr;
            const SourceLocation where = script_->written_at(line);
            end += before_line.size() + static_cast<std::size_t>(digits_end - digits);
            name = where.file + std::string(before_line) + std::to_string(where.line);
        }
        message.replace(at, end - at, name);
        at += name.size();
    }
    return message;
}

}  // namespace dmp::geometry
