// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/solidify/solidification.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "base/errors.hpp"
#include "solver/solidify/conditions.hpp"
#include "solver/state/loaded_groups.hpp"

namespace dmp::solver {

namespace {

constexpr int any_number = std::numeric_limits<int>::max() / 2;

Vec vec(const std::array<double, 3>& of) { return {of[0], of[1], of[2]}; }

/// Along periodic axes, less than half a period.
void need_short_reach(const Solidify& rule, const ParticleSpace& space) {
    for (int axis = 0; axis < space.dimension; ++axis)
        if (space.periodic[axis] && !(2 * rule.reach < space.box.high[axis] - space.box.low[axis]))
            throw InputError(rule.reach.location,
                             "reach of solidify '" + *rule.name + "' is half the period along " + "xyz"[axis] +
                                 " or more: a seed would find the same liquid on both sides",
                             "lower it; neighbours are about a spacing away");
}

void need_liquid_in_seed_region(const Scene& scene, const Solidify& rule, const ParticleSet& set, int liquid_part) {
    if (rule.seed_region->empty() || rule.seed_stress_above > 0 || rule.seed_residence_above > 0) return;
    const SolidifyRegion region(scene, rule.seed_region, set);
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.part[i] == liquid_part && region.contains(set.position[i])) return;
    throw InputError(rule.seed_region.location,
                     "seed_region of solidify '" + *rule.name + "': there is no particle of '" + *rule.liquid +
                         "' in the region '" + *rule.seed_region + "'",
                     "move the region into the liquid, or make it as large as a few spacings");
}

/// Where the store has a node.
Vec shown_position(const SpringBody& body, std::size_t node, const ParticleStore& particles) {
    return body.position(node).unaryExpr([&](double x) { return particles.quantum().round(x); });
}

}  // namespace

Solidification::Solidification(const Scene& scene, int number, const ParticleSet& set, const Ranks& ranks)
    : scene_(scene),
      rule_(scene.solidify[static_cast<std::size_t>(number)]),
      ranks_(ranks),
      space_(with_whole_periods(set, PositionQuantum(set))),
      number_(number),
      origin_(static_cast<int>(scene.parts_of(PartKind::elastic).size()) + number),
      liquid_part_(set.part_named(rule_.liquid)),
      activity_{*rule_.active, std::max<std::int64_t>(1, *rule_.one_in)},
      most_bonds_(rule_.most_bonds > 0 ? rule_.most_bonds.value : any_number) {
    need_short_reach(rule_, set);
    need_liquid_in_seed_region(scene, rule_, set, liquid_part_);
    if (rule_.seed_part->empty()) return;
    const PositionQuantum quantum(set);
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.parts[set.part[i]].name != *rule_.seed_part) continue;
        const auto id = static_cast<std::int64_t>(i);
        if (set.kind(i) == PartKind::elastic)
            since_[id] = 0;
        else if (set.wall_distance[i] < rule_.reach)  // others are out of the liquid's reach
            walls_[id] = {{id, set.position[i].unaryExpr([&](double x) { return quantum.round(x); })}, set.mass[i]};
    }
}

Solidification::SolidifyingParticle Solidification::turning(const ParticleStore& particles, std::size_t i,
                                                            double ahead) const {
    const ParticleGroup& fluid = particles.fluid();
    SolidifyingParticle of{fluid.tags()[i].id, fluid.data(Field::mass)[i], {}, {}, particles.space().spacing / 2};
    for (int axis = 0; axis < fluid.dimension(); ++axis) {
        of.velocity[axis] = fluid.data(Field::velocity, axis)[i];
        of.position[axis] = fluid.data(Field::position, axis)[i] + particles.quantum().round(ahead * of.velocity[axis]);
    }
    return of;
}

std::vector<Solidification::SolidifyingParticle> Solidification::from_all(std::vector<SolidifyingParticle> own) const {
    std::vector<SolidifyingParticle> all = ranks_.all_gather(own);
    std::ranges::sort(all, {}, &SolidifyingParticle::id);
    return all;
}

std::unordered_map<std::int64_t, int> Solidification::room(const SpringBodies& springs) const {
    std::unordered_map<std::int64_t, int> room;
    for (const auto& body : springs.bodies())
        for (std::size_t b = 0; b < body->bonds().size(); ++b) {
            if (body->bond_origin(b) != origin_) continue;
            for (const int end : {body->bonds()[b].a, body->bonds()[b].b})
                --room.try_emplace(body->ids()[end], most_bonds_).first->second;
        }
    return room;
}

std::vector<ParticlePosition> Solidification::acting_seeds(std::int64_t event, const ParticleStore& particles,
                                                           const FluidStep& fluid,
                                                           const std::vector<SolidifyingParticle>& new_seeds) const {
    const auto left = room(fluid.springs());
    const auto has_room = [&](std::int64_t id) {
        const auto found = left.find(id);
        return found == left.end() || found->second > 0;
    };
    std::vector<ParticlePosition> seeds;
    if (activity_.acts_at(event))
        for (const auto& [id, wall] : walls_)
            if (has_room(id)) seeds.push_back(wall.particle);
    for (const auto& [id, since] : since_) {
        if (!activity_.acts_at(event - since) || !has_room(id)) continue;
        const auto [body, node] = fluid.springs().node_of(id);
        seeds.push_back({id, shown_position(*body, node, particles)});
    }
    for (const SolidifyingParticle& seed : new_seeds) seeds.push_back({seed.id, vec(seed.position)});
    return seeds;
}

void Solidification::add_node(BodyChange& change, const SolidifyingParticle& turned) const {
    BodyParts::Node node;
    node.id = static_cast<int>(turned.id);
    node.origin = origin_;
    node.mass = turned.mass;
    node.position = node.position_before = node.rest_position = vec(turned.position);
    node.velocity = vec(turned.velocity);
    node.surface.depth = node.surface.opposite = turned.radius;
    change.nodes.push_back(node);
}

void Solidification::add_bond(BodyChange& change, const SpringBodies& springs, int a, int b) const {
    for (const int end : {a, b}) {
        const auto wall = walls_.find(end);
        const bool known = wall == walls_.end() || springs.holds(end) ||
                           std::ranges::any_of(change.nodes, [end](const auto& node) { return node.id == end; });
        if (known) continue;
        BodyParts::Node node;
        node.id = end;
        node.fixed = node.of_wall = true;
        node.origin = origin_;
        node.mass = wall->second.mass;
        node.position = node.position_before = node.rest_position = wall->second.particle.position;
        change.nodes.push_back(node);
    }
    change.bonds.push_back({a, b, rule_.rest_length, rule_.bond_stiffness, rule_.bond_damping, origin_});
}

/// What turned solid is bonded to all of the aggregate within reach, other new particles among it.
void Solidification::bond_to_neighbours(BodyChange& change, const std::vector<SolidifyingParticle>& turned,
                                        const ParticleStore& particles, const SpringBodies& springs) const {
    std::vector<ParticlePosition> solids, fresh;
    for (const auto& body : springs.bodies())
        for (std::size_t node = 0; node < body->nodes(); ++node) {
            const std::int64_t id = body->ids()[node];
            if (body->of_wall(node) || (body->origin(node) != origin_ && !since_.contains(id))) continue;
            solids.push_back({id, shown_position(*body, node, particles)});
        }
    for (const auto& [id, wall] : walls_) solids.push_back(wall.particle);
    for (const SolidifyingParticle& one : turned) fresh.push_back({one.id, vec(one.position)});
    solids.insert(solids.end(), fresh.begin(), fresh.end());

    auto left = room(springs);
    std::set<std::pair<std::int64_t, std::int64_t>> bonded;
    for (const BodyChange::Bond& bond : change.bonds) {
        bonded.emplace(std::min(bond.a, bond.b), std::max(bond.a, bond.b));
        for (const int end : {bond.a, bond.b}) --left.try_emplace(end, most_bonds_).first->second;
    }
    auto near = find_bond_candidates(solids, fresh, rule_.reach, space_);
    find_nearest(near, rule_.reach);
    for (const BondCandidate& pair : near) {
        if (pair.seed == pair.liquid) continue;
        if (!bonded.emplace(std::min(pair.seed, pair.liquid), std::max(pair.seed, pair.liquid)).second) continue;
        int& of_seed = left.try_emplace(pair.seed, most_bonds_).first->second;
        int& of_fresh = left.try_emplace(pair.liquid, most_bonds_).first->second;
        if (of_seed <= 0 || of_fresh <= 0) continue;
        --of_seed;
        --of_fresh;
        add_bond(change, springs, static_cast<int>(pair.seed), static_cast<int>(pair.liquid));
    }
}

void Solidification::act(std::int64_t event, const ParticleStore& particles, FluidStep& fluid) {
    const SpringBodies& springs = fluid.springs();
    const double ahead = fluid.bodies_ahead();
    const SolidifyConditions conditions(scene_, rule_, liquid_part_, particles, fluid);

    std::vector<SolidifyingParticle> new_seeds;
    std::vector<std::size_t> liquid;
    std::vector<ParticlePosition> placed;
    for (std::size_t i = 0; i < particles.fluid().owned(); ++i) {
        if (!conditions.is_liquid(i)) continue;
        if (conditions.becomes_seed(i, event)) {
            new_seeds.push_back(turning(particles, i, ahead));
        } else if (conditions.may_turn(i)) {
            liquid.push_back(i);
            const SolidifyingParticle as_solid = turning(particles, i, ahead);
            placed.push_back({as_solid.id, vec(as_solid.position)});
        }
    }
    new_seeds = from_all(std::move(new_seeds));
    const auto seeds = acting_seeds(event, particles, fluid, new_seeds);
    auto candidates = ranks_.all_gather(find_bond_candidates(seeds, placed, rule_.reach, space_));
    find_nearest(candidates, rule_.reach);
    const RandomTrial trial{static_cast<std::uint64_t>(*rule_.seed), static_cast<std::uint64_t>(number_),
                            static_cast<std::uint64_t>(event)};
    const auto bonds =
        binding_ones(candidates, binding_rule(rule_.rule, rule_.probability), trial, room(springs), most_bonds_);

    std::set<std::int64_t> bound;
    for (const BondCandidate& bond : bonds) bound.insert(bond.liquid);
    std::vector<SolidifyingParticle> turned;
    for (const std::size_t i : liquid)
        if (bound.contains(particles.fluid().tags()[i].id)) turned.push_back(turning(particles, i, ahead));
    turned = from_all(std::move(turned));

    BodyChange change;
    for (const SolidifyingParticle& seed : new_seeds) {
        add_node(change, seed);
        since_[seed.id] = event;
    }
    for (const SolidifyingParticle& one : turned) {
        add_node(change, one);
        if (rule_.spreads) since_[one.id] = event + 1;
    }
    for (const BondCandidate& bond : bonds)
        add_bond(change, springs, static_cast<int>(bond.seed), static_cast<int>(bond.liquid));
    switch (*rule_.bond_to) {
        case BondTo::seed:
            break;
        case BondTo::neighbours: {
            std::vector<SolidifyingParticle> fresh = new_seeds;
            fresh.insert(fresh.end(), turned.begin(), turned.end());
            bond_to_neighbours(change, fresh, particles, springs);
        }
    }
    if (!change.empty()) fluid.change_bodies(change);
}

void Solidification::archive(Archive& file) {
    const std::string name = "solidify/" + *rule_.name;
    std::vector<double> ids, events;
    for (const auto& [id, event] : since_) {
        ids.push_back(static_cast<double>(id));
        events.push_back(static_cast<double>(event));
    }
    file(name + "/seeds", ids);
    file(name + "/since", events);
    if (!file.loading()) return;
    if (ids.size() != events.size()) throw unlike_any_run("seeds without the event that made them");
    since_.clear();
    constexpr std::int64_t most = 1LL << 53;
    for (std::size_t k = 0; k < ids.size(); ++k)
        since_[loaded_whole(ids[k], 0, most, "a seed")] = loaded_whole(events[k], 0, most, "an event");
}

}  // namespace dmp::solver
