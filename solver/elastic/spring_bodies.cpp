// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic/spring_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/unlisted_value.hpp"
#include "solver/parallel/each_of.hpp"
#include "solver/parallel/exact_sum.hpp"
#include "solver/state/loaded_groups.hpp"

namespace dmp::solver {

namespace {

bool is_implicit(SpringStepping stepping) {
    switch (stepping) {
        case SpringStepping::implicit:
            return true;
        case SpringStepping::subcycled:
            return false;
    }
    unlisted_value(stepping);
}

}  // namespace

SpringBodies::SpringBodies(const ParticleSet& set, const Scene& scene, const Ranks& ranks, const SpringContact& contact,
                           double liquid_density)
    : ranks_(ranks),
      dimension_(set.dimension),
      space_(static_cast<const ParticleSpace&>(set)),
      contact_(contact),
      names_(body_names(scene)),
      tally_(names_.size()),
      changes_(scene.changes_bodies()),
      implicit_(is_implicit(scene.numerics.spring_stepping)),
      step_factor_(scene.numerics.spring_step_factor) {
    const int count = set.body.empty() ? 0 : *std::max_element(set.body.begin(), set.body.end()) + 1;
    const InitialSprings drawn(set, scene, liquid_density);
    const double range = contact.of_itself() ? contact.range : 0;
    const std::vector<bool> of_cells = bodies_of_cells(set);
    for (int body = 0; body < count; ++body)
        bodies_.push_back(
            made_of(of_cells[body] ? initial_cells(set, drawn, body, range) : initial_body(set, drawn, body, range)));
    note_step_limits();
    number_nodes();
}

/// Named after the first of names() among the origins of its nodes: an elastic solid, if there is one.
std::unique_ptr<SpringBody> SpringBodies::made_of(const BodyParts& parts) const {
    std::size_t origin = names_.size();
    for (const BodyParts::Node& node : parts.nodes)
        if (!node.of_wall) origin = std::min(origin, static_cast<std::size_t>(node.origin));
    return SpringBody::make(parts, names_.at(origin), space_, contact_);
}

void SpringBodies::number_nodes() {
    by_id_.clear();
    first_node_.assign(1, 0);
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
        const auto& ids = bodies_[body]->ids();
        for (std::size_t n = 0; n < ids.size(); ++n) by_id_[ids[n]] = {static_cast<int>(body), static_cast<int>(n)};
        first_node_.push_back(first_node_.back() + ids.size());
    }
}

void SpringBodies::note_step_limits() {
    limits_.clear();
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& body : bodies_) {
        const double limit = body->step_limit();
        shortest = std::min(shortest, limit);
        const auto known =
            std::find_if(limits_.begin(), limits_.end(), [&](const PartLimit& l) { return l.part == body->part(); });
        if (known == limits_.end()) {
            limits_.push_back({body->part(), limit});
        } else {
            known->dt = std::min(known->dt, limit);
        }
    }
    largest_step_ = shortest * step_factor_;
}

void SpringBodies::change(const BodyChange& change, const ParticleSpace& space) {
    std::set<std::size_t> touched;
    const auto touch = [&](int id) {
        if (const auto found = by_id_.find(id); found != by_id_.end()) touched.insert(found->second.body);
    };
    for (const BodyChange::Bond& bond : change.bonds) {
        touch(bond.a);
        touch(bond.b);
    }
    for (const auto& ends : change.broken) touch(ends[0]);
    std::vector<BodyParts> before;
    before.reserve(touched.size());
    for (const std::size_t body : touched) before.push_back(bodies_[body]->parts());
    const ChangedBodies changed = change_bodies(before, change, space);

    std::vector<std::unique_ptr<SpringBody>> all;
    for (std::size_t body = 0; body < bodies_.size(); ++body)
        if (!touched.contains(body)) all.push_back(std::move(bodies_[body]));
    for (const BodyParts& parts : changed.bodies) all.push_back(made_of(parts));
    std::ranges::sort(all, {}, [](const auto& body) { return body->ids().front(); });
    bodies_ = std::move(all);
    for (const int origin : changed.made) ++tally_[origin].made;
    for (const int origin : changed.broken) ++tally_[origin].broken;
    number_nodes();
    if (!implicit_) note_step_limits();
}

void SpringBodies::number_particles(ParticleStore& particles) const {
    for (ParticleTag& tag : particles.of(PartKind::elastic).tags()) tag.body = by_id_.at(tag.id).body;
}

double SpringBodies::mass() const {
    ExactSum sum;
    for (const auto& body : bodies_)
        for (std::size_t n = 0; n < body->nodes(); ++n)
            if (!body->of_wall(n)) sum.add(body->mass(n));
    return sum.value();
}

int SpringBodies::substeps(double dt) const {
    if (empty()) return 0;
    return implicit_ ? 1 : std::max(1, static_cast<int>(std::ceil(dt / largest_step_)));
}

void SpringBodies::archive_parts(Archive& file) {
    std::vector<BodyParts> parts;
    for (const auto& body : bodies_) parts.push_back(body->parts());
    solver::archive(file, "springs/bodies", parts);
    for (std::size_t k = 0; k < names_.size(); ++k) {
        file("springs/bonds_made_" + names_[k], tally_[k].made);
        file("springs/bonds_broken_" + names_[k], tally_[k].broken);
    }
    if (!file.loading()) return;
    const auto known = [&](const auto& each) {
        return each.origin >= 0 && static_cast<std::size_t>(each.origin) < names_.size();
    };
    bodies_.clear();
    for (const BodyParts& body : parts) {
        const auto& [nodes, bonds, hinges, dihedrals, cells, faces, held_apart] =
            body;  // all: one more does not compile
        const bool has_own = !std::ranges::all_of(nodes, [](const auto& node) { return node.of_wall; });
        if (!has_own || !std::ranges::all_of(nodes, known) || !std::ranges::all_of(bonds, known) ||
            !std::ranges::all_of(hinges, known) || !std::ranges::all_of(dihedrals, known) ||
            !std::ranges::all_of(cells, known))
            throw unlike_any_run("a body of no solid of the scene");
        bodies_.push_back(made_of(body));
    }
    number_nodes();
    note_step_limits();
}

void SpringBodies::archive(Archive& file) {
    if (changes_) archive_parts(file);
    for (std::size_t body = 0; body < bodies_.size(); ++body)
        bodies_[body]->archive(file, "springs/body_" + std::to_string(body));
}

void SpringBodies::find_nodes(const ParticleStore& particles) {
    nodes_.clear();
    for (const ParticleTag& tag : particles.of(PartKind::elastic).tags()) nodes_.push_back(by_id_.at(tag.id));
}

std::vector<Vec> SpringBodies::collected(const ParticleStore& particles, Field field) const {
    struct OfNode {
        std::size_t node;
        std::array<double, 3> value;
    };
    const ParticleGroup& group = particles.of(PartKind::elastic);
    std::vector<OfNode> owned(group.owned());
    for (std::size_t i = 0; i < owned.size(); ++i) {
        owned[i] = {first_node_[nodes_[i].body] + nodes_[i].index, {}};
        for (int axis = 0; axis < dimension_; ++axis) owned[i].value[axis] = group.data(field, axis)[i];
    }
    std::vector<Vec> values(first_node_.back(), Vec::Zero());
    for (const OfNode& of : ranks_.all_gather(owned)) values[of.node] = Vec(of.value[0], of.value[1], of.value[2]);
    return values;
}

void SpringBodies::show_in(ParticleStore& particles, Field field, const std::vector<Vec>& values) const {
    ParticleGroup& group = particles.of(PartKind::elastic);
    for (std::size_t i = 0; i < group.total(); ++i)
        for (int axis = 0; axis < dimension_; ++axis)
            group.data(field, axis)[i] = values[first_node_[nodes_[i].body] + nodes_[i].index][axis];
}

template <class ValueOf>
void SpringBodies::show(ParticleStore& particles, Field field, const ValueOf& value_of) const {
    ParticleGroup& group = particles.of(PartKind::elastic);
    for (std::size_t i = 0; i < group.total(); ++i) {
        const Vec value = value_of(*bodies_[nodes_[i].body], static_cast<std::size_t>(nodes_[i].index));
        for (int axis = 0; axis < dimension_; ++axis) {
            double& shown = group.data(field, axis)[i];
            shown = field == Field::position ? shown + value[axis] : value[axis];
        }
    }
}

void SpringBodies::show_velocities(ParticleStore& particles) const {
    show(particles, Field::velocity, [](const SpringBody& body, std::size_t node) { return body.velocity(node); });
}

void SpringBodies::show_surfaces(ParticleStore& particles, double dt) const {
    ParticleGroup& group = particles.of(PartKind::elastic);
    if (!group.has(Field::opposite_distance)) return;
    std::vector<std::vector<PresentSurface>> of_bodies;
    std::vector<bool> clamped;
    for (const auto& body : bodies_) {
        of_bodies.push_back(body->surfaces(dt, 4 * particles.space().spacing));
        clamped.push_back(body->is_clamped());
    }
    for (std::size_t i = 0; i < group.total(); ++i) {
        const auto& [surface, gradient] = of_bodies[nodes_[i].body][nodes_[i].index];
        group.data(Field::wall_distance)[i] = surface.depth;
        group.data(Field::opposite_distance)[i] = surface.opposite;
        group.data(Field::held)[i] = clamped[nodes_[i].body] ? 1 : 0;
        for (int a = 0; a < dimension_; ++a) {
            group.data(Field::wall_normal, a)[i] = surface.normal[a];
            for (int b = 0; b < dimension_; ++b)
                group.data(Field::surface_gradient, a * dimension_ + b)[i] = gradient(a, b);
        }
    }
}

SpringImpulses SpringBodies::advance(ParticleStore& particles, double dt, int threads, int parts,
                                     const std::function<void(double)>& contact) {
    const double part = dt / parts;
    const int steps = implicit_ ? 0 : substeps(part);
    const std::vector<Vec> force = collected(particles, Field::force);
    std::vector<SpringImpulses> impulses(bodies_.size());
    SpringImpulses sum;
    if (parts > 1)
        for (const auto& body : bodies_) body->start_parts();
    for (int k = 0; k < parts; ++k) {
        if (contact) contact(part);
        each_of(static_cast<std::ptrdiff_t>(bodies_.size()), threads, [&](std::ptrdiff_t b) {
            impulses[b] = bodies_[b]->advance(std::span(force).subspan(first_node_[b]), part, steps);
        });
        for (const auto& impulse : impulses)
            for (int axis = 0; axis < 3; ++axis) {
                sum.of_anchors[axis] += impulse.of_anchors[axis];
                sum.of_drag[axis] += impulse.of_drag[axis];
            }
    }
    if (parts > 1)
        for (const auto& body : bodies_) body->end_parts();
    show(particles, Field::velocity, [dt](const SpringBody& body, std::size_t node) {
        return Vec((1 / dt) * (body.position(node) - body.position_before(node)));
    });
    show_surfaces(particles, dt);
    return sum;
}

double SpringBodies::show_positions(ParticleStore& particles, double from, double to) const {
    const PositionQuantum& quantum = particles.quantum();
    double farthest = 0;
    // The store's positions may have been moved by whole periods, so add the displacement.
    show(particles, Field::position, [&](const SpringBody& body, std::size_t node) {
        const Vec now = body.position(node), before = body.position_before(node);
        const auto at = [&](double share, int axis) {
            if (share == 0) return quantum.round(before[axis]);
            if (share == 1) return quantum.round(now[axis]);
            return quantum.round(before[axis] + share * (now[axis] - before[axis]));
        };
        Vec way = Vec::Zero();
        for (int axis = 0; axis < dimension_; ++axis) way[axis] = at(to, axis) - at(from, axis);
        return way;
    });
    for (const auto& body : bodies_)
        for (std::size_t node = 0; node < body->nodes(); ++node)
            farthest = std::max(farthest, (body->position(node) - body->position_before(node)).squaredNorm());
    return (to - from) * std::sqrt(farthest);
}

}  // namespace dmp::solver
