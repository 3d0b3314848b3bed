// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Any surface of some triangles on a small lattice, where corners, edges and faces often coincide, through the ladder
// of repairs: it has an inside then, or is refused with what to do. The input: a byte for the highest rung and the
// spacing, one for the number of corners, three for each corner, and three for each triangle.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>

#include "geometry/repair_surface.hpp"
#include "geometry/surface_edges.hpp"
#include "tests/modules.hpp"

namespace {

void need(bool holds, int line = __builtin_LINE()) {
    if (holds) return;
    std::fprintf(stderr, "line %d does not hold\n", line);
    std::abort();
}

/// 0 to 15, half of them off by what welding may or may not close.
double coordinate(std::uint8_t byte) {
    constexpr std::uint8_t positions = 15;
    const int off = byte >> 4;
    return (byte & positions) + (off < 8 ? 0 : (off - 7) * 1e-3);
}

dmp::geometry::TriangleSurface surface_of(std::span<const std::uint8_t> bytes) {
    dmp::geometry::TriangleSurface surface;
    const std::size_t corners = std::min<std::size_t>(bytes[0], (bytes.size() - 1) / 3);
    for (std::size_t k = 0; k < corners; ++k)
        surface.corners.emplace_back(coordinate(bytes[1 + 3 * k]), coordinate(bytes[2 + 3 * k]),
                                     coordinate(bytes[3 + 3 * k]));
    if (corners == 0) return surface;
    const auto index = [&](std::size_t at) { return static_cast<int>(bytes[at] % corners); };
    for (std::size_t at = 1 + 3 * corners; at + 3 <= bytes.size(); at += 3)
        surface.triangles.push_back({index(at), index(at + 1), index(at + 2)});
    return surface;
}

// A volume below this is none, as for triangle_geometry.
double rounding_of(const dmp::geometry::TriangleSurface& surface) { return 1e-12 * std::pow(surface.area(), 1.5); }

void check(const dmp::geometry::RepairedSurface& repaired, const dmp::geometry::RepairLimits& limits) {
    const dmp::geometry::TriangleSurface& surface = repaired.surface;
    const auto corners = static_cast<int>(surface.corners.size());
    need(!surface.triangles.empty());
    for (const auto& triangle : surface.triangles)
        for (const int corner : triangle) need(corner >= 0 && corner < corners);
    for (const dmp::Vec& corner : surface.corners) need(corner.allFinite());
    for (const std::string& line : repaired.report.lines()) need(!line.empty() && line.size() < 1000);
    const bool closed = dmp::geometry::count_edges(surface).closed();
    need(closed || (surface.has_holes && repaired.report.by == dmp::geometry::RepairedBy::vote));
    if (repaired.report.by == dmp::geometry::RepairedBy::vote)
        need(limits.highest >= dmp::geometry::RepairRung::vote && repaired.report.doubt <= limits.largest_doubt);
    else
        need(surface.enclosed_volume() >=
             -rounding_of(surface));  // about 0: crosses itself, triangle_geometry refuses it
    if (repaired.report.by == dmp::geometry::RepairedBy::wrap) need(limits.highest == dmp::geometry::RepairRung::wrap);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 2) return 0;
    dmp::geometry::RepairLimits limits;
    // Votes and wraps take a second under the sanitizers: one input in eight comes so far.
    limits.highest = static_cast<dmp::geometry::RepairRung>(data[0] % 8 == 0 ? 3 + data[0] / 8 % 2 : data[0] % 3);
    limits.spacing = data[0] % 2 == 0 ? 4 : 2;
    try {
        const dmp::geometry::RepairedSurface repaired =
            dmp::geometry::repair_surface(surface_of({data + 1, size - 1}), limits, "fuzzed", {});
        check(repaired, limits);
        if (repaired.report.by == dmp::geometry::RepairedBy::vote) return 0;
        // What is in order comes back as it is.
        const dmp::geometry::RepairedSurface again =
            dmp::geometry::repair_surface(repaired.surface, limits, "repaired", {});
        const double volume = repaired.surface.enclosed_volume();
        need(std::abs(again.surface.enclosed_volume() - volume) <= 1e-9 * volume + rounding_of(repaired.surface));
    } catch (const dmp::InputError& error) {
        need(!error.problem().empty() && !error.what_to_do().empty() && error.problem().size() < 1000);
    }
    return 0;
}
