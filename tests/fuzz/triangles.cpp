// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a file of triangles, as far as `dmp inspect` goes with it: they are a sound geometry, or an InputError
// that says what to do. The format is the build's DMP_FORMAT.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "geometry/geometry_bytes.hpp"
#include "geometry/triangle_file.hpp"
#include "geometry/triangle_geometry.hpp"
#include "tests/modules.hpp"

namespace {

void need(bool holds, int line = __builtin_LINE()) {
    if (holds) return;
    std::fprintf(stderr, "line %d does not hold\n", line);
    std::abort();
}

void check(const dmp::geometry::TriangleSurface& surface) {
    const auto corners = static_cast<int>(surface.corners.size());
    need(!surface.triangles.empty());
    for (const auto& triangle : surface.triangles)
        for (const int corner : triangle) need(corner >= 0 && corner < corners);
    for (const dmp::Vec& corner : surface.corners) need(corner.allFinite());
}

dmp::geometry::TriangleSoup read(std::string_view text, const std::string& file) {
    constexpr std::string_view format = DMP_FORMAT;
    if (format == "stl") return dmp::geometry::read_stl_text(text, file);
    if (format == "obj") return dmp::geometry::read_obj_text(text, file);
    return format == "ply" ? dmp::geometry::read_ply_text(text, file) : dmp::geometry::read_off_text(text, file);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    dmp::geometry::GeometryOptions options;
    options.file = "fuzzed." DMP_FORMAT;
    options.unit = 1e-3;
    try {
        dmp::geometry::TriangleSoup soup = read({reinterpret_cast<const char*>(data), size}, options.file);
        need(soup.group.size() == soup.surface.triangles.size());
        for (const int group : soup.group) need(group >= 0 && static_cast<std::size_t>(group) < soup.names.size());
        if (soup.surface.triangles.empty()) return 0;
        check(soup.surface);
        const dmp::geometry::Geometry geometry = dmp::geometry::triangle_geometry(std::move(soup), options);
        need(!geometry.solids.empty() || !geometry.surfaces.empty());
        for (const dmp::geometry::Solid& solid : geometry.solids) {
            check(solid.surface);
            need(!solid.name.empty() && std::isfinite(solid.volume()) && solid.volume() != 0);
        }
        for (const dmp::geometry::SurfaceSet& set : geometry.surfaces) check(set.surface);
        const std::string bytes = dmp::geometry::bytes_of(geometry);
        need(dmp::geometry::bytes_of(dmp::geometry::geometry_of(bytes)) == bytes);
    } catch (const dmp::InputError& error) {
        need(!error.problem().empty() && !error.what_to_do().empty() && error.problem().size() < 1000);
    }
    return 0;
}
