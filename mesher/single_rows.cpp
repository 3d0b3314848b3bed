// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/single_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/errors.hpp"
#include "base/length_text.hpp"
#include "mesher/searchable_particles.hpp"

namespace dmp::mesher {

namespace {

/// Walls farther away than this do not count [spacings].
constexpr double beside = 1.5;

}  // namespace

void refuse_single_rows(const ParticleSet& set, const Scene& scene) {
    if (set.count(PartKind::rigid) == 0) return;
    const double spacing = set.spacing, reach = (beside + 1) * spacing;
    const SearchableParticles near(set, reach);
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::fluid) continue;
        struct Seen {
            double distance = std::numeric_limits<double>::infinity(), in_front = 0;
            std::size_t particle = 0;
        };
        Seen nearest;
        double nearest_elastic = nearest.distance;
        std::vector<Seen> walls;
        near.for_each_neighbour(i, [&](std::size_t j, const Vec& from_it) {
            const double distance = from_it.norm();
            if (set.kind(j) == PartKind::elastic) nearest_elastic = std::min(nearest_elastic, distance);
            if (set.kind(j) != PartKind::rigid) return;
            walls.push_back({distance, from_it.dot(set.wall_normal[j]) - set.wall_distance[j], j});
            if (distance < nearest.distance) nearest = walls.back();
        });
        if (nearest.distance > beside * spacing || nearest_elastic < nearest.distance) continue;
        const bool is_in_front = std::ranges::any_of(walls, [&](const Seen& wall) {
            return wall.distance < nearest.distance + spacing && wall.in_front >= -spacing;
        });
        if (is_in_front) continue;
        const auto part = [&](std::size_t particle) {
            return set.parts[static_cast<std::size_t>(set.part[particle])].name;
        };
        const std::string wall = part(nearest.particle);
        throw InputError(
            scene.part_of_particles(wall).name.location,
            "the wall '" + wall + "' has a single row of particles near " +
                position_text(set.position[nearest.particle], set.dimension) + ", with fluid on both sides: '" +
                part(i) + "' at " + position_text(set.position[i], set.dimension) + " is behind its surface",
            "draw it two spacings thick or more, or take a particles.spacing of less than half its thickness");
    }
}

}  // namespace dmp::mesher
