// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/monitor/penetration_monitor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/number_text.hpp"
#include "solver/contact/surface_contact.hpp"
#include "solver/output/fluid_fields.hpp"

namespace dmp::solver {

namespace {

/// Distances of a place in a solid to the nearest of its particles, and to those of the layers around it, at most; in
/// spacings.
constexpr double to_nearest_inside = 0.9, to_layers_around = 1.2;

class SolidFields {
  public:
    explicit SolidFields(const ParticleGroup& group)
        : group_(group),
          shows_surface_(group.has(Field::wall_normal)),
          has_far_side_(group.kind() == PartKind::elastic) {
        for (int axis = 0; axis < group.dimension(); ++axis) position_[axis] = group.data(Field::position, axis);
    }
    [[nodiscard]] Vec position(std::size_t i) const {
        Vec place = Vec::Zero();
        for (int axis = 0; axis < group_.dimension(); ++axis) place[axis] = position_[axis][i];
        return place;
    }
    [[nodiscard]] double distance_square(std::size_t i, const Vec& place) const {
        double square = 0;
        for (int axis = 0; axis < group_.dimension(); ++axis) {
            const double apart = position_[axis][i] - place[axis];
            square += apart * apart;
        }
        return square;
    }
    [[nodiscard]] Vec normal(std::size_t i) const {
        Vec normal = Vec::Zero();
        for (int axis = 0; shows_surface_ && axis < group_.dimension(); ++axis)
            normal[axis] = group_.data(Field::wall_normal, axis)[i];
        return normal;
    }
    /// How far a place, `from_particle` i, is behind the surface that i shows [m]; infinite where it shows none.
    [[nodiscard]] double behind(std::size_t i, const Vec& from_particle) const {
        const Vec n = normal(i);
        if (n.isZero()) return std::numeric_limits<double>::infinity();
        const double height = from_particle.dot(n);
        const double depth = group_.data(Field::wall_distance)[i] - height;
        return has_far_side_ ? std::min(depth, group_.data(Field::opposite_distance)[i] + height) : depth;
    }
    /// To which contact keeps a particle from others, of walls or of bodies [m].
    [[nodiscard]] double range(std::size_t i, Field field, double usual) const {
        return group_.has(field) ? group_.data(field)[i] : usual;
    }
    [[nodiscard]] const ParticleTag& tag(std::size_t i) const { return group_.tags()[i]; }

  private:
    const ParticleGroup& group_;
    bool shows_surface_, has_far_side_;
    std::array<const double*, 3> position_{};
};

/// The particles of one solid that are near a place: a wall's part, or an elastic body.
struct NearSolid {
    PartKind kind = PartKind::rigid;
    std::int32_t part = 0, body = -1;
    double square = std::numeric_limits<double>::infinity();  ///< of the nearest distance [m^2]
    std::int64_t id = 0;                                      ///< of the nearest
    Vec normal = Vec::Zero();                                 ///< of the nearest
    double behind = std::numeric_limits<double>::infinity();  ///< the surface, by the particle that says least [m]
    std::vector<Vec> apart;                                   ///< to its particles [m]

    void add(const SolidFields& of, std::size_t j, double distance_square, const Vec& from_particle) {
        behind = std::min(behind, of.behind(j, from_particle));
        apart.push_back(-from_particle);
        if (std::pair(distance_square, of.tag(j).id) >= std::pair(square, id)) return;
        square = distance_square;
        id = of.tag(j).id;
        normal = of.normal(j);
    }
    /// Whether there are particles deeper in than the place: it is not on the far side of a thin sheet.
    [[nodiscard]] bool goes_on() const {
        return std::ranges::any_of(apart, [&](const Vec& to) { return to.dot(normal) < 0; });
    }
};

/// The entry of a particle's solid, which begins with the first particle.
NearSolid& solid_of(std::vector<NearSolid>& solids, PartKind kind, const ParticleTag& tag) {
    const std::int32_t body = kind == PartKind::rigid ? -1 : tag.body;
    const auto found = std::ranges::find_if(
        solids, [&](const NearSolid& each) { return each.kind == kind && each.part == tag.part && each.body == body; });
    if (found != solids.end()) return *found;
    NearSolid& made = solids.emplace_back();
    made.kind = kind;
    made.part = tag.part;
    made.body = body;
    return made;
}

/// Calls visit(node, near) for each solid near each owned elastic particle; in scenes where bodies change, without the
/// other bodies of its own part.
template <class Visit>
void for_each_near(const Scene& scene, const ParticleStore& particles, const ClusterList& list, const Visit& visit) {
    const double farthest = to_layers_around * scene.particles.spacing;
    const ParticleGroup& elastic = particles.of(PartKind::elastic);
    const SolidFields nodes(elastic), walls(particles.of(PartKind::rigid));
    std::vector<NearSolid> solids;
    const auto add = [&](std::size_t i, const Vec& place, PartKind kind, std::size_t j) {
        const SolidFields& others = kind == PartKind::rigid ? walls : nodes;
        const double square = others.distance_square(j, place);
        if (square >= farthest * farthest) return;
        if (scene.changes_bodies() && others.tag(j).part == nodes.tag(i).part) return;
        solid_of(solids, kind, others.tag(j)).add(others, j, square, place - others.position(j));
    };
    const auto clusters = list.clusters(PartKind::elastic);
    for (std::size_t number = 0; number < clusters.size(); ++number) {
        const auto first = static_cast<std::size_t>(clusters[number].first);
        const std::size_t end = std::min(first + static_cast<std::size_t>(clusters[number].count), elastic.owned());
        for (std::size_t i = first; i < end; ++i) {
            const Vec place = nodes.position(i);
            solids.clear();
            for (const PartKind kind : {PartKind::rigid, PartKind::elastic})
                for (const std::int32_t j : list.neighbours(PartKind::elastic, number, kind))
                    add(i, place, kind, static_cast<std::size_t>(j));
            for (const NearSolid& near : solids) visit(i, near);
        }
    }
}

struct Penetration {
    double depth;  ///< behind the surface; 0: not known [m]
    double distance;
};

/// Whether an elastic particle has passed into the solid.
std::optional<Penetration> penetration(const Scene& scene, const SolidFields& nodes, std::size_t i,
                                       const NearSolid& near) {
    const double spacing = scene.particles.spacing, distance = std::sqrt(near.square);
    if (distance > to_nearest_inside * spacing) return {};
    const bool is_wall = near.kind == PartKind::rigid;
    const double range =
        nodes.range(i, is_wall ? Field::wall_contact_range : Field::contact_range, scene.contact.range * spacing);
    if (range == 0) return {};  // drawn against the wall, or solidified there
    // New surfaces of torn bodies are not known.
    const bool knows_surface = is_wall || !scene.changes_bodies();
    if (knows_surface && std::isfinite(near.behind) && near.behind > 0.5 * spacing && near.goes_on())
        return Penetration{near.behind, distance};
    // The repulsion never lets them come so near if it is strong enough.
    if (distance < std::min(0.4 * spacing, 0.57 * range)) return Penetration{0, distance};
    return {};
}

}  // namespace

void PenetrationMonitor::start(const ParticleStore& particles, const ClusterList& list, const Ranks& ranks) {
    const SolidFields nodes(particles.of(PartKind::elastic));
    beside_.clear();
    for_each_near(scene_, particles, list, [&](std::size_t i, const NearSolid& near) {
        if (near.kind == PartKind::rigid || penetration(scene_, nodes, i, near))
            beside_.push_back(static_cast<double>(nodes.tag(i).id));
    });
    beside_ = ranks.all_gather<double>(beside_);
    std::ranges::sort(beside_);
}

std::optional<Warning> PenetrationMonitor::look(const ParticleStore& particles, const ClusterList& list,
                                                const SurfaceContact* surfaces, const Ranks& ranks, double t) {
    if (!part_.empty()) return {};
    const auto name = [&](std::int64_t part) { return particles.space().parts[static_cast<std::size_t>(part)].name; };
    if (surfaces != nullptr) {
        const SurfaceContact::Deepest touched = surfaces->deepest(), passed = surfaces->passed();
        const SurfaceContact::Deepest& deepest = touched.depth > passed.depth ? touched : passed;
        if (!(deepest.depth > 0.5 * scene_.particles.spacing)) return {};
        part_ = name(deepest.parts[0]);
        other_ = name(deepest.parts[1]);
        time_ = deepest.time;
        depth_ = deepest.depth;
        place_ = {deepest.place[0], deepest.place[1], deepest.place[2]};
        return warning(surfaces);
    }
    struct Found {
        double depth, distance;
        std::int64_t particle, part, other;
        std::array<double, 3> place;
    };
    const ParticleGroup& elastic = particles.of(PartKind::elastic);
    const SolidFields nodes(elastic);
    std::vector<Found> deepest;  // of this rank: one, or none
    const auto is_before = [](const Found& a, const Found& b) {
        if (a.depth != b.depth) return a.depth > b.depth;
        if (a.distance != b.distance) return a.distance < b.distance;
        return std::pair(a.particle, a.other) < std::pair(b.particle, b.other);
    };
    for_each_near(scene_, particles, list, [&](std::size_t i, const NearSolid& near) {
        const std::optional<Penetration> passed = penetration(scene_, nodes, i, near);
        const ParticleTag& tag = nodes.tag(i);
        if (!passed || std::ranges::binary_search(beside_, static_cast<double>(tag.id))) return;
        const Vec place = shown_place(elastic, particles.space(), i);
        const Found here{passed->depth, passed->distance, tag.id, tag.part, near.part, {place[0], place[1], place[2]}};
        if (deepest.empty())
            deepest.push_back(here);
        else if (is_before(here, deepest.front()))
            deepest.front() = here;
    });
    deepest = ranks.all_gather<Found>(deepest);
    if (deepest.empty()) return {};
    const Found& found = *std::ranges::min_element(deepest, is_before);
    particle_ = found.particle;
    part_ = name(found.part);
    other_ = name(found.other);
    time_ = t;
    depth_ = found.depth;
    distance_ = found.distance;
    place_ = found.place;
    return warning(surfaces);
}

/// A strength that suits the material of the stiffest part, 0.002 E r*^2 on a depth of 1 m or r* [J]; 0: it is not
/// given by a modulus.
double PenetrationMonitor::strength_by_material() const {
    const double range = scene_.contact.range * scene_.particles.spacing;
    double modulus = 0;
    for (const Part* part : scene_.parts_of(PartKind::elastic)) modulus = std::max(modulus, part->youngs_modulus.value);
    return 0.002 * modulus * range * range * (scene_.dimension == 3 ? range : 1);
}

std::optional<Warning> PenetrationMonitor::warning(const SurfaceContact* surfaces) const {
    if (part_.empty()) return {};
    std::string place;
    for (int axis = 0; axis < scene_.dimension; ++axis)
        place += (axis > 0 ? ", " : "") + number_text(place_[axis], 4) + " m";
    Warning warning;
    give_advice(warning, surfaces);
    warning.problem += " is too low for what presses the solids together: by " + number_text(time_, 4) + " s " +
                       (particle_ < 0 ? "" : "particle " + std::to_string(particle_) + " of ") + "'" + part_ +
                       "' had passed into '" + other_ + "', " +
                       number_text((depth_ > 0 ? depth_ : distance_) / scene_.particles.spacing, 2) +
                       (depth_ > 0 ? " spacings behind its surface" : " spacings from one of its particles") +
                       ", at (" + place + "). What the run gives of these solids from then on is wrong";
    return warning;
}

/// The key, what it is, and what to give in its place.
void PenetrationMonitor::give_advice(Warning& warning, const SurfaceContact* surfaces) const {
    const auto between = [](double low, const std::string& unit) {
        return number_text(10 * low, 2) + " to " + number_text(100 * low, 2) + " " + unit + ", and look at the frames";
    };
    if (surfaces != nullptr) {
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [part, stiffness] : surfaces->stiffness_of_parts()) least = std::min(least, stiffness);
        warning.key = "contact.stiffness";
        warning.location = scene_.contact.stiffness.location;
        warning.problem = "of " + number_text(least, 3) + " Pa/m";
        warning.what_to_do = "refine particles.spacing, or give a contact.stiffness of " + between(least, "Pa/m");
        return;
    }
    warning.key = "contact.strength";
    warning.location = scene_.contact.strength.location;
    warning.problem = "of " + number_text(strength_, 3) + " J";
    const double by_material = strength_by_material();
    warning.what_to_do = strength_ > 0 ? "give a contact.strength of " + between(strength_, "J")
                                       : (by_material > 0 ? "give one of about " + number_text(by_material, 2) + " J"
                                                          : std::string("give one in J")) +
                                             ", and look at the frames";
}

void PenetrationMonitor::archive_start(Archive& file) { file("penetration/beside", beside_); }

void PenetrationMonitor::archive(Archive& file) {
    file("penetration/particle", particle_);
    file("penetration/part", part_);
    file("penetration/other", other_);
    file("penetration/time", time_);
    file("penetration/depth", depth_);
    file("penetration/distance", distance_);
    file("penetration/place", place_);
}

}  // namespace dmp::solver
