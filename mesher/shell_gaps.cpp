// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/shell_gaps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "base/length_text.hpp"
#include "geometry/segments.hpp"
#include "geometry/surface_pieces.hpp"
#include "geometry/thickened_sheet.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

namespace {

/// A sheet is held by what its edge is this near to [spacings].
constexpr double held_within = 0.25;
/// What a free edge comes to within this share of its distance from where the sheet is held, it leads to.
constexpr double leads_to = 0.5;

double distance_between(const NearestTriangle& surface, const Vec& position) {
    const auto found = surface.nearest(position);
    return found ? found->distance : std::numeric_limits<double>::infinity();
}

/// Of a fluid's surface what ends at walls: not where the scene goes on, nor where another fluid is beyond it.
TriangleSurface closed_sides(const Geometry& geometry, const Scene& scene, const Part& fluid,
                             const std::function<bool(const Vec&)>& goes_on) {
    const double touching = 1e-3 * scene.particles.spacing;
    std::vector<NearestTriangle> others;
    for (const Part* part : scene.parts_of(PartKind::fluid))
        if (part != &fluid) others.emplace_back(geometry.solid(part->name)->surface, touching);
    TriangleSurface sides = geometry.solid(fluid.name)->surface;
    std::erase_if(sides.triangles, [&](const std::array<int, 3>& triangle) {
        Vec middle = Vec::Zero();
        for (const int corner : triangle) middle += sides.corners[static_cast<std::size_t>(corner)] / 3;
        return goes_on(middle) || std::ranges::any_of(others, [&](const NearestTriangle& other) {
                   return other.nearest(middle).has_value();
               });
    });
    return sides;
}

}  // namespace

ShellGaps::ShellGaps(const Geometry& geometry, const Scene& scene, double fewest,
                     const std::function<bool(const Vec&)>& goes_on)
    : spacing_(scene.particles.spacing), fewest_(fewest) {
    const double reach = (fewest + 1) * spacing_;
    for (const PartKind kind : {PartKind::rigid, PartKind::elastic})
        for (const Part* part : scene.parts_of(kind))
            if (const Solid* solid = geometry.solid(part->name)) solids_.emplace_back(solid->surface, reach);
    for (const Part* part : scene.parts_of(PartKind::fluid))
        solids_.emplace_back(closed_sides(geometry, scene, *part, goes_on), reach);
    for (const Part* part : scene.parts_of(PartKind::elastic)) {
        const SurfaceSet* set = geometry.surface_set(part->name);
        if (set == nullptr) continue;
        const SurfacePieces pieces(set->surface);
        for (const SurfacePiece& piece : pieces.all()) {
            TriangleSurface surface = part_of(set->surface, piece.triangles);
            NearestTriangle nearest(surface, reach);
            sheets_.push_back({part, std::move(surface), std::move(nearest), {}});
        }
    }
    for (Sheet& sheet : sheets_) {
        const auto is_held = [&](const Vec& a, const Vec& b) {
            const Vec middle = 0.5 * (a + b);
            const auto touches = [&](const NearestTriangle& other) {
                return distance_between(other, middle) < held_within * spacing_;
            };
            const bool held = goes_on(middle) || std::ranges::any_of(solids_, touches) ||
                              std::ranges::any_of(sheets_, [&](const Sheet& other) {
                                  return &other != &sheet && touches(other.nearest);
                              });
            (held ? held_ : sheet.free_edges).push_back({a, b});
            return held;
        };
        bodies_.push_back(thickened_sheet(sheet.surface, spacing_, is_held));
    }
}

double ShellGaps::distance_to_held(const Vec& position) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Edge& edge : held_) nearest = std::min(nearest, nearest_on_segment(position, edge[0], edge[1]).distance);
    return nearest;
}

bool ShellGaps::is_in_a_wedge(const ThicknessSample& sample) const {
    // As wide as a wedge would be here whose sides meet at the held edge, give or take a half.
    const double from_edge = distance_to_held(sample.position);
    return std::isfinite(from_edge) && sample.thickness < 1.5 * (from_edge + spacing_) * sample.slant &&
           1.5 * sample.thickness > (from_edge - spacing_) * sample.slant;
}

double ShellGaps::particles_beside(const Vec& position, const Sheet& own) const {
    // A layer of fluid is half a spacing from a wall, and a whole one from a sheet.
    double solid = std::numeric_limits<double>::infinity(), sheet = solid;
    for (const NearestTriangle& other : solids_) solid = std::min(solid, distance_between(other, position));
    for (const Sheet& other : sheets_)
        if (&other != &own) sheet = std::min(sheet, distance_between(other.nearest, position));
    const double particles = std::min(solid / spacing_ - 0.5, sheet / spacing_ - 1);
    if (particles >= fewest_) return particles;
    const double leads_within = leads_to * distance_to_held(position);
    return std::min(solid < leads_within ? solid / spacing_ - 0.5 : fewest_,
                    sheet < leads_within ? sheet / spacing_ - 1 : fewest_);
}

std::vector<std::string> ShellGaps::narrow_edges() const {
    struct Narrowest {
        const Part* part;
        double particles;
        Vec position;
    };
    std::vector<Narrowest> found;
    const double limit = fewest_ * (1 - 1e-9);
    for (const Sheet& sheet : sheets_) {
        if (found.empty() || found.back().part != sheet.part) found.push_back({sheet.part, limit, Vec::Zero()});
        for (const auto& [a, b] : sheet.free_edges) {
            const int positions = std::max(1, static_cast<int>(std::ceil((b - a).norm() / spacing_)));
            for (int k = 0; k < positions; ++k) {
                const Vec position = a + (k + 0.5) / positions * (b - a);
                const double particles = particles_beside(position, sheet);
                if (particles < found.back().particles) found.back() = {sheet.part, particles, position};
            }
        }
    }
    std::vector<std::string> said;
    for (const auto& [part, particles, position] : found) {
        if (particles >= limit) continue;
        std::ostringstream text;
        text.precision(3);
        text << part->name.value << ": a gap at its edge near " << position_text(position) << " that "
             << std::max(0.0, particles) << " particles fit into, less than " << fewest_;
        said.push_back(text.str());
    }
    return said;
}

}  // namespace dmp::mesher
