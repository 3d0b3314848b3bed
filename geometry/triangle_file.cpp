// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <utility>

namespace dmp::geometry {

namespace {

/// Corners are numbered by int; a file of more bytes may have more of them.
constexpr std::uintmax_t largest_file = 16ULL << 30U;

using Reader = TriangleSoup (*)(std::string_view, const std::string&);

Reader reader_of(const std::string& file) {
    constexpr std::array<std::pair<std::string_view, Reader>, 4> readers{
        {{".stl", read_stl_text}, {".obj", read_obj_text}, {".ply", read_ply_text}, {".off", read_off_text}}};
    std::string ending = std::filesystem::path(file).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto found = std::ranges::find(readers, ending, &std::pair<std::string_view, Reader>::first);
    return found == readers.end() ? nullptr : found->second;
}

std::string contents_of(const std::string& file, const SourceLocation& location) {
    std::error_code error;
    const bool regular = std::filesystem::is_regular_file(file, error);
    const std::uintmax_t size = regular ? std::filesystem::file_size(file, error) : 0;
    if (size > largest_file)
        throw InputError(location, "'" + file + "' is larger than 16 GiB", "export the surface with fewer triangles");
    std::string contents(size, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(contents.data(), static_cast<std::streamsize>(size));
    if (!regular || error || !stream)
        throw InputError(location, "'" + file + "' cannot be read", "check the file's name and permissions");
    return contents;
}

}  // namespace

bool is_triangle_file(const std::string& file) { return reader_of(file) != nullptr; }

TriangleSoup read_triangle_file(const std::string& file, const SourceLocation& location) {
    const Reader reader = reader_of(file);
    const std::string contents = contents_of(file, location);
    if (contents.empty()) throw InputError(location, "'" + file + "' is empty", "export the surface again");
    TriangleSoup soup = (reader == nullptr ? read_stl_text : reader)(contents, file);
    if (soup.surface.triangles.empty())
        throw InputError(location, "'" + file + "' has no triangle with an area", "export the surface again");
    return soup;
}

TriangleSurface read_stl(const std::string& file, double unit, const SourceLocation& location) {
    const std::string contents = contents_of(file, location);
    TriangleSurface surface = read_stl_text(contents, file).surface;
    if (surface.triangles.empty())
        throw InputError(location, "'" + file + "' has no triangle with an area", "export the surface again");
    for (Vec& corner : surface.corners) corner *= unit;
    return surface;
}

}  // namespace dmp::geometry
