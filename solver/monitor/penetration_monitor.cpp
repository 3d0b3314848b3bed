// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/monitor/penetration_monitor.hpp"

#include <algorithm>
#include <limits>

#include "base/number_text.hpp"
#include "solver/output/fluid_fields.hpp"

namespace dmp::solver {

namespace {

Vec vector_of(const ParticleGroup& group, Field field, std::size_t i) {
    Vec value = Vec::Zero();
    for (int axis = 0; axis < group.dimension(); ++axis) value[axis] = group.data(field, axis)[i];
    return value;
}

struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    const ParticleGroup* group = nullptr;
    std::size_t index = 0;
};

/// Calls visit(node, nearest) for each owned elastic particle, with the nearest particle of another body or wall;
/// `other_parts`: of another part.
template <class Visit>
void for_each_nearest(const ParticleStore& particles, const ClusterList& list, bool other_parts, const Visit& visit) {
    const ParticleGroup& nodes = particles.of(PartKind::elastic);
    const auto clusters = list.clusters(PartKind::elastic);
    for (std::size_t number = 0; number < clusters.size(); ++number) {
        const Cluster& cluster = clusters[number];
        for (std::int32_t node = cluster.first; node < cluster.first + cluster.count; ++node) {
            const auto i = static_cast<std::size_t>(node);
            if (i >= nodes.owned()) continue;
            const Vec place = vector_of(nodes, Field::position, i);
            Nearest nearest;
            for (const PartKind kind : {PartKind::rigid, PartKind::elastic}) {
                const ParticleGroup& others = particles.of(kind);
                for (const std::int32_t index : list.neighbours(PartKind::elastic, number, kind)) {
                    const auto j = static_cast<std::size_t>(index);
                    if (other_parts && others.tags()[j].part == nodes.tags()[i].part) continue;
                    const double distance = (vector_of(others, Field::position, j) - place).norm();
                    if (distance < nearest.distance) nearest = {distance, &others, j};
                }
            }
            if (nearest.group != nullptr) visit(i, nearest);
        }
    }
}

/// How far a place is behind the surface that particle j shows [m]; 0 for sheets thinner than a spacing, and where
/// there is none: in scenes without a liquid, of round particles.
double depth_behind(const ParticleGroup& solid, std::size_t j, const Vec& place, double spacing) {
    if (!solid.has(Field::wall_normal)) return 0;
    const Vec normal = vector_of(solid, Field::wall_normal, j);
    const double depth = solid.data(Field::wall_distance)[j];
    if (normal.isZero()) return 0;
    if (solid.kind() == PartKind::elastic && depth + solid.data(Field::opposite_distance)[j] < spacing) return 0;
    return depth - (place - vector_of(solid, Field::position, j)).dot(normal);
}

/// Distance to which the repulsion never lets particles of different solids come, if it is strong enough [m].
double too_near(const Scene& scene) { return std::min(0.4, 0.57 * scene.contact.range) * scene.particles.spacing; }

}  // namespace

void PenetrationMonitor::start(const ParticleStore& particles, const ClusterList& list, const Ranks& ranks) {
    const double beside = 1.2 * scene_.particles.spacing;
    beside_.clear();
    for_each_nearest(particles, list, scene_.changes_bodies(), [&](std::size_t i, const Nearest& nearest) {
        if (nearest.distance < beside)
            beside_.push_back(static_cast<double>(particles.of(PartKind::elastic).tags()[i].id));
    });
    beside_ = ranks.all_gather<double>(beside_);
    std::ranges::sort(beside_);
}

std::optional<Warning> PenetrationMonitor::look(const ParticleStore& particles, const ClusterList& list,
                                                const Ranks& ranks, double t) {
    if (particle_ >= 0) return {};
    struct Found {
        double depth, distance;
        std::int64_t particle, part, other;
        std::array<double, 3> place;
    };
    const double spacing = scene_.particles.spacing;
    const ParticleGroup& nodes = particles.of(PartKind::elastic);
    std::vector<Found> deepest;  // of this rank: one, or none
    const auto is_before = [](const Found& a, const Found& b) {
        if (a.depth != b.depth) return a.depth > b.depth;
        return a.distance != b.distance ? a.distance < b.distance : a.particle < b.particle;
    };
    for_each_nearest(particles, list, scene_.changes_bodies(), [&](std::size_t i, const Nearest& nearest) {
        // Any place in a solid is nearer than that to one of its particles.
        if (nearest.distance > 0.9 * spacing) return;
        double behind = depth_behind(*nearest.group, nearest.index, vector_of(nodes, Field::position, i), spacing);
        if (behind < 0.5 * spacing) behind = 0;
        const ParticleTag& tag = nodes.tags()[i];
        if (behind == 0 && nearest.distance > too_near(scene_)) return;
        if (std::ranges::binary_search(beside_, static_cast<double>(tag.id))) return;
        const Vec place = shown_place(nodes, particles.space(), i);
        const std::int64_t other = nearest.group->tags()[nearest.index].part;
        const Found here{behind, nearest.distance, tag.id, tag.part, other, {place[0], place[1], place[2]}};
        if (deepest.empty())
            deepest.push_back(here);
        else if (is_before(here, deepest.front()))
            deepest.front() = here;
    });
    deepest = ranks.all_gather<Found>(deepest);
    if (deepest.empty()) return {};
    const Found& found = *std::ranges::min_element(deepest, is_before);
    const auto name = [&](std::int64_t part) { return particles.space().parts[static_cast<std::size_t>(part)].name; };
    particle_ = found.particle;
    part_ = name(found.part);
    other_ = name(found.other);
    time_ = t;
    depth_ = found.depth;
    distance_ = found.distance;
    place_ = found.place;
    return warning();
}

std::optional<Warning> PenetrationMonitor::warning() const {
    if (particle_ < 0) return {};
    std::string place;
    for (int axis = 0; axis < scene_.dimension; ++axis)
        place += (axis > 0 ? ", " : "") + number_text(place_[axis], 4) + " m";
    Warning warning;
    warning.key = "contact.strength";
    warning.location = scene_.contact.strength.location;
    warning.problem = "of " + number_text(strength_, 3) + " J is too low for what presses the solids together: by " +
                      number_text(time_, 4) + " s particle " + std::to_string(particle_) + " of '" + part_ +
                      "' had passed into '" + other_ + "', " +
                      number_text((depth_ > 0 ? depth_ : distance_) / scene_.particles.spacing, 2) +
                      (depth_ > 0 ? " spacings behind its surface" : " spacings from one of its particles") + ", at (" +
                      place + "). What the run gives of these solids from then on is wrong";
    warning.what_to_do = strength_ > 0 ? "give a contact.strength of " + number_text(10 * strength_, 2) + " to " +
                                             number_text(100 * strength_, 2) + " J, and look at the frames"
                                       : "give one in J, and look at the frames";
    return warning;
}

void PenetrationMonitor::archive(Archive& file) {
    file("penetration/beside", beside_);
    file("penetration/particle", particle_);
    file("penetration/part", part_);
    file("penetration/other", other_);
    file("penetration/time", time_);
    file("penetration/depth", depth_);
    file("penetration/distance", distance_);
    file("penetration/place", place_);
}

}  // namespace dmp::solver
