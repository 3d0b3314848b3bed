// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/monitor/stability_monitor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "base/number_text.hpp"
#include "scene/step_margins.hpp"

namespace dmp::solver {

namespace {

constexpr double lowest_density = 0.5, highest_density = 1.5;

double speed_of(const ParticleGroup& group, std::size_t i) {
    double square = 0;
    for (int axis = 0; axis < group.dimension(); ++axis) {
        const double v = group.data(Field::velocity, axis)[i];
        square += v * v;
    }
    return std::sqrt(square);
}

std::string setting(const std::string& key, double value) { return key + " = " + number_text(value); }

/// Largest change of a bond's length over its length at rest; not finite when a node's place is not.
double largest_strain(const SpringBodies& springs) {
    double largest = 0;
    for (const auto& body : springs.bodies())
        for (const SpringBody::OwnBond& bond : body->bonds()) {
            const double strain = std::abs(body->stretch(bond) / bond.rest_length);
            if (!(strain <= largest)) largest = strain;
            if (!std::isfinite(strain)) return std::numeric_limits<double>::infinity();
        }
    return largest;
}

}  // namespace

bool StabilityMonitor::fluid_is_well(const FluidExtremes& extremes) const {
    return extremes.largest_speed < sound_speed_ && extremes.density_low > lowest_density &&
           extremes.density_high < highest_density;
}

std::optional<StabilityMonitor::Finding> StabilityMonitor::check(const ParticleStore& particles, const FluidStep& step,
                                                                 const FluidExtremes& extremes, double t) const {
    std::optional<Violation> found;
    const bool well = fluid_is_well(extremes);
    if (!well) found = worst_of_fluid(particles.fluid());
    if (!found && well) found = worst_of_elastic(particles.of(PartKind::elastic));
    if (!found && well) found = first_that_left(particles, step.neighbours().list());
    if (!found) return std::nullopt;
    return describe(*found, particles, step, t);
}

std::optional<StabilityMonitor::Finding> StabilityMonitor::stuck_elastic(const ParticleStore& particles,
                                                                         const FluidStep& step,
                                                                         const std::string& reason, double t) const {
    const ParticleGroup& springs = particles.of(PartKind::elastic);
    if (springs.owned() == 0) return std::nullopt;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < springs.owned(); ++i)
        if (!(speed_of(springs, i) <= speed_of(springs, worst))) worst = i;
    return describe({&springs, worst, "is the fastest node, and " + reason, false, true}, particles, step, t);
}

std::optional<StabilityMonitor::Violation> StabilityMonitor::worst_of_fluid(const ParticleGroup& fluid) const {
    std::size_t worst = 0;
    double worst_speed = -1;
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        const double speed = speed_of(fluid, i), density = fluid.data(Field::density)[i];
        if (!std::isfinite(speed) || !std::isfinite(density)) return Violation{&fluid, i, "is not finite"};
        const double relative = density / rest_density_[fluid.tags()[i].part];
        if (relative <= lowest_density || relative >= highest_density)
            return Violation{&fluid, i, "has a density outside 0.5 to 1.5 times the rest density"};
        if (speed > worst_speed) {
            worst = i;
            worst_speed = speed;
        }
    }
    if (!(worst_speed >= sound_speed_)) return std::nullopt;  // another rank has it
    return Violation{&fluid, worst, "is faster than sound"};
}

std::optional<StabilityMonitor::Violation> StabilityMonitor::worst_of_elastic(const ParticleGroup& springs) const {
    // Solids alone may go wherever they are pulled.
    const bool has_domain = !scene_.parts_of(PartKind::fluid).empty();
    for (std::size_t i = 0; i < springs.owned(); ++i) {
        const double speed = speed_of(springs, i);
        if (!std::isfinite(speed)) return Violation{&springs, i, "is not finite"};
        if (speed >= sound_speed_) return Violation{&springs, i, "is faster than sound"};
        if (has_domain && outside_box(springs, i)) return Violation{&springs, i, "has left the domain"};
    }
    return std::nullopt;
}

std::optional<StabilityMonitor::Violation> StabilityMonitor::first_that_left(const ParticleStore& particles,
                                                                             const ClusterList& list) const {
    std::optional<Violation> found;
    for_those_that_left(particles, list, [&](std::size_t i, double depth) {
        std::string limit = "has left the domain";
        if (depth > 0)
            limit += ": it is " + number_text(depth) + " m behind the wall's surface, more than the spacing of " +
                     number_text(space_.spacing) + " m";
        found.emplace(Violation{&particles.fluid(), i, limit, true});
        return false;
    });
    return found;
}

StabilityMonitor::Finding StabilityMonitor::describe(const Violation& violation, const ParticleStore& particles,
                                                     const FluidStep& step, double t) const {
    const ParticleGroup& group = *violation.group;
    const std::size_t i = violation.particle;
    const ParticleTag& tag = group.tags()[i];
    std::ostringstream text;
    text << "particle " << tag.id << " of '" << space_.parts[tag.part].name << "' at (";
    for (int axis = 0; axis < group.dimension(); ++axis)
        text << (axis > 0 ? ", " : "") << group.data(Field::position, axis)[i] << " m";
    text << ") " << violation.limit << ": speed " << speed_of(group, i) << " m/s, sound speed " << sound_speed_
         << " m/s";
    if (group.has(Field::density)) text << ", density " << group.data(Field::density)[i] << " kg/m^3";
    return {text.str(), likely_causes(violation, particles.fluid(), step, t)};
}

/// Those that this scene can have, the likeliest first, judged by what was set and by the state of all particles.
std::string StabilityMonitor::likely_causes(const Violation& violation, const ParticleGroup& fluid,
                                            const FluidStep& step, double t) const {
    const SpringBodies& springs = step.springs();
    const auto& numerics = scene_.numerics;
    decltype(Scene::numerics) usual;
    usual.shifting = 4.0;
    double usual_range = 1;
    if (*numerics.scheme == FluidScheme::corrected) {
        usual.step_factor = 0.5;
        usual.shifting = 0.2;
        usual_range = 0.7;
    }
    std::vector<std::pair<double, std::string>> causes;  // with how likely each is
    std::string stated;
    for (const StepMargin& margin : step_margins(scene_)) {
        if (margin.key == "numerics.step_factor") {
            usual.step_factor = std::min(*usual.step_factor, margin.with_least_margin());
            stated = ", its stated limit " + number_text(margin.stated.value, 3);
        } else if (!margin.model.empty() && margin.own.given() && margin.is_small()) {
            causes.emplace_back(5.5, margin.too_large_text());
        }
    }

    // A run that breaks is slow in most places. All of it fast: that is the drive.
    const double expected =
        scene_.flow.largest_speed > 0 ? std::min<double>(scene_.flow.largest_speed, sound_speed_) : sound_speed_ / 10;
    std::size_t fast = 0;
    for (std::size_t i = 0; i < fluid.owned(); ++i)
        if (!(speed_of(fluid, i) <= 1.5 * expected)) ++fast;
    const bool all_fast = 5 * fast > fluid.owned();
    causes.emplace_back(all_fast ? 5 : 1,
                        numerics.sound_speed.given() && *numerics.sound_speed > 0  // not "auto"
                            ? setting("numerics.sound_speed", numerics.sound_speed) +
                                  " m/s is not ten times the speed that the drive produces"
                            : setting("flow.largest_speed", scene_.flow.largest_speed) +
                                  " m/s is below what the drive produces (the sound speed follows it)");

    const auto is_finite = [](const std::array<double, 3>& drive) {
        return std::ranges::all_of(drive, [](double axis) { return std::isfinite(axis); });
    };
    if (!is_finite(step.body_force().uniform(t)))
        causes.emplace_back(8, "flow.acceleration gives no number at that time");
    if (!is_finite(step.body_force().force_density(t)))
        causes.emplace_back(8, "flow.pressure_gradient gives no number at that time");
    for (const Part* part : scene_.parts_of(PartKind::rigid)) {
        const auto at_that_time = [&](const auto& velocity) {
            return std::array{velocity[0](t), velocity[1](t), velocity[2](t)};
        };
        const std::string of_part = "part." + *part->name + ".";
        if (!is_finite(at_that_time(*part->velocity)) || !std::isfinite((*part->spin)(t)))
            causes.emplace_back(8, of_part + "velocity or spin gives no number at that time");
        if (std::ranges::none_of(*part->surface_velocity, &Expression::depends_on_position) &&
            !is_finite(at_that_time(*part->surface_velocity)))
            causes.emplace_back(8, of_part + "surface_velocity gives no number at that time");
    }
    const bool is_outside = violation.left || outside_box(*violation.group, violation.particle);
    if (is_outside && !scene_.parts_of(PartKind::rigid).empty())
        causes.emplace_back(violation.left ? 4 : 2, "a wall there has a hole or is too thin");
    if (is_outside && violation.group->kind() == PartKind::elastic)
        causes.emplace_back(3, "the solid is too soft, or its bonds too weak, for what pulls it");
    if (numerics.step_factor > usual.step_factor)
        causes.emplace_back(!violation.left && numerics.step_factor > 1.5 * usual.step_factor ? 6 : 3,
                            setting("numerics.step_factor", numerics.step_factor) + " is too large; the default is " +
                                number_text(usual.step_factor) + stated);
    if (*numerics.shifting > 0 && (numerics.shifting < usual.shifting / 10 || numerics.shifting > 10 * usual.shifting))
        causes.emplace_back(5.5, setting("numerics.shifting", numerics.shifting) + " is far from the usual " +
                                     number_text(usual.shifting));
    if (*scene_.contact.range > 2 * usual_range)
        causes.emplace_back(5.5, setting("contact.range", scene_.contact.range) +
                                     " spacings makes particles push that do not touch; the default is " +
                                     number_text(usual_range));
    if (violation.stuck) causes.emplace_back(4, "a particle lies all but on that body and pushes it away");
    if (!springs.empty() && !springs.implicit()) {
        const double strain = largest_strain(springs);
        const bool torn = violation.group->kind() == PartKind::elastic || !(strain < 0.5);
        const bool forced = numerics.spring_step_factor > usual.spring_step_factor;
        causes.emplace_back(torn ? (forced ? 7 : 4.5) : 0,
                            setting("numerics.spring_step_factor", numerics.spring_step_factor) +
                                " leaves the springs too large a step for how stiff and how far strained they are");
    }

    if (*numerics.shifting == 0 && *numerics.scheme == FluidScheme::corrected)
        causes.emplace_back(5.5,
                            "numerics.shifting = 0 leaves gaps where the flow pulls particles apart; the default is " +
                                number_text(usual.shifting));

    // What is known to be wrong may have made the void, too.
    if (!void_.empty() && std::ranges::none_of(causes, [](const auto& cause) { return cause.first >= 5; }))
        causes.emplace_back(4.5, void_ + ", which particles could not fill");

    std::stable_sort(causes.begin(), causes.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    // Where something is known to be wrong, what may be wrong in any run says nothing.
    if (causes.front().first >= 5.5) std::erase_if(causes, [](const auto& cause) { return cause.first <= 1; });
    std::string text = causes.size() > 1 ? "likely causes: " : "likely cause: ";
    for (std::size_t k = 0; k < causes.size(); ++k) text += (k > 0 ? "; or " : "") + causes[k].second;
    return text;
}

bool StabilityMonitor::outside_box(const ParticleGroup& group, std::size_t i) const {
    for (int axis = 0; axis < group.dimension(); ++axis) {
        if (space_.periodic[axis]) continue;
        const double x = group.data(Field::position, axis)[i];
        const double margin = support_ + walls_moved_;
        if (x < space_.box.low[axis] - margin || x > space_.box.high[axis] + margin) return true;
    }
    return false;
}

/// How far in front of the walls' surface fluid particle i is [m], less than 0 behind it, 0 where no wall says it. The
/// nearest particle of a wall does; where that says behind, the best of those up to a spacing further away: at the edge
/// of a body the nearest one may belong to another face than the one that the fluid is in front of. Nothing is said
///   where an elastic solid is nearer: it bulges beyond the plane of the wall that it is held by;
///   beyond the support of all walls, in 3-D, and in 2-D by one that the fluid is farther beside than behind: clusters
///   list few of those walls, which may all be of one face.
double StabilityMonitor::in_front_of_walls(const ParticleStore& particles, std::span<const std::int32_t> near,
                                           std::span<const std::int32_t> near_elastic, std::int32_t i) const {
    const ParticleGroup& fluid = particles.fluid();
    const ParticleGroup& walls = particles.of(PartKind::rigid);
    struct Seen {
        double square_of_distance, in_front, square_beside;
    };
    const auto seen = [&](std::int32_t j) {
        double square = 0, along_normal = 0;
        for (int axis = 0; axis < particles.dimension(); ++axis) {
            const double d = fluid.data(Field::position, axis)[i] - walls.data(Field::position, axis)[j];
            square += d * d;
            along_normal += d * walls.data(Field::wall_normal, axis)[j];
        }
        return Seen{square, along_normal - walls.data(Field::wall_distance)[j], square - along_normal * along_normal};
    };
    Seen nearest{std::numeric_limits<double>::infinity(), 0, 0};
    for (const std::int32_t j : near)
        if (const Seen wall = seen(j); wall.square_of_distance < nearest.square_of_distance) nearest = wall;
    // In 3-D clusters list so few of the walls further away than the support that those few may show one face only.
    const bool is_far = nearest.square_of_distance > support_ * support_;
    if (space_.dimension == 3 && is_far) return 0;
    if (nearest.in_front >= -space_.spacing) return nearest.in_front;
    const ParticleGroup& elastic = particles.of(PartKind::elastic);
    for (const std::int32_t j : near_elastic) {
        double square = 0;
        for (int axis = 0; axis < particles.dimension(); ++axis)
            square += std::pow(fluid.data(Field::position, axis)[i] - elastic.data(Field::position, axis)[j], 2);
        if (square < nearest.square_of_distance) return 0;
    }
    const double reach =
        is_far ? std::numeric_limits<double>::infinity() : std::sqrt(nearest.square_of_distance) + space_.spacing;
    double best = nearest.in_front;
    for (const std::int32_t j : near)
        if (const Seen wall = seen(j); wall.square_of_distance < reach * reach) best = std::max(best, wall.in_front);
    return best;
}

template <class Visit>
void StabilityMonitor::for_those_that_left(const ParticleStore& particles, const ClusterList& list,
                                           const Visit& visit) const {
    const ParticleGroup& fluid = particles.fluid();
    const auto clusters = list.clusters(PartKind::fluid);
    for (std::size_t c = 0; c < clusters.size(); ++c)
        for (std::int32_t i = clusters[c].first; i < clusters[c].first + clusters[c].count; ++i) {
            const double in_front = in_front_of_walls(particles, list.neighbours(PartKind::fluid, c, PartKind::rigid),
                                                      list.neighbours(PartKind::fluid, c, PartKind::elastic), i);
            const auto index = static_cast<std::size_t>(i);
            const bool behind = in_front < -space_.spacing;
            if ((behind || outside_box(fluid, index)) && !visit(index, behind ? -in_front : 0.0)) return;
        }
}

std::size_t StabilityMonitor::lost(const ParticleStore& particles, const ClusterList& list) const {
    std::size_t count = 0;
    for_those_that_left(particles, list, [&](std::size_t, double) {
        ++count;
        return true;
    });
    return count;
}

}  // namespace dmp::solver
