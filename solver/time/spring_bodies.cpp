// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "solver/time/implicit_system.hpp"

namespace dmp {

SpringBodies::SpringBodies(const ParticleSet& set, const Scene& scene, const Ranks& ranks)
    : ranks_(ranks), implicit_(scene.accuracy.spring_stepping.value == SpringStepping::implicit) {
    const int count = set.body.empty() ? 0 : *std::max_element(set.body.begin(), set.body.end()) + 1;
    if (count > 0 && set.dimension != 2)
        throw InputError("the particles have spring bodies in 3-D",
                         "Springs are plane for now: leave these parts out.");
    double shortest = std::numeric_limits<double>::infinity();
    for (int body = 0; body < count; ++body) {
        const auto node = std::find(set.body.begin(), set.body.end(), body) - set.body.begin();
        const std::string& name = set.parts[set.part[node]].name;
        const auto parts = scene.parts_of(PartKind::springs);
        const auto part =
            std::find_if(parts.begin(), parts.end(), [&](const Part* p) { return p->name.value == name; });
        if (part == parts.end())
            throw InputError("the particles have a springs part '" + name + "' that the scene does not know",
                             "mesh the scene again");
        bodies_.emplace_back(set, **part, body);
        const double limit = bodies_.back().step_limit();
        shortest = std::min(shortest, limit);
        const auto known =
            std::find_if(limits_.begin(), limits_.end(), [&](const PartLimit& l) { return l.part == name; });
        if (known == limits_.end()) {
            limits_.push_back({name, limit});
        } else {
            known->dt = std::min(known->dt, limit);
        }
    }
    largest_step_ = shortest * scene.accuracy.spring_step_factor;
    first_node_.push_back(0);
    for (int body = 0; body < count; ++body) {
        const auto& ids = bodies_[body].ids();
        for (std::size_t n = 0; n < ids.size(); ++n) by_id_[ids[n]] = {body, static_cast<int>(n)};
        first_node_.push_back(first_node_.back() + ids.size());
    }
}

int SpringBodies::substeps(double dt) const {
    if (empty()) return 0;
    return implicit_ ? 1 : std::max(1, static_cast<int>(std::ceil(dt / largest_step_)));
}

void SpringBodies::archive(Archive& file) {
    for (std::size_t body = 0; body < bodies_.size(); ++body)
        bodies_[body].archive(file, "springs/body_" + std::to_string(body));
}

void SpringBodies::find_nodes(const ParticleStore& particles) {
    nodes_.clear();
    for (const ParticleTag& tag : particles.of(ParticleKind::springs).tags()) nodes_.push_back(by_id_.at(tag.id));
}

std::vector<Vector<double, 2>> SpringBodies::collected(const ParticleStore& particles, Field field) const {
    struct OfNode {
        std::size_t node;
        Vector<double, 2> value;
    };
    const ParticleGroup& group = particles.of(ParticleKind::springs);
    std::vector<OfNode> owned(group.owned());
    for (std::size_t i = 0; i < owned.size(); ++i)
        owned[i] = {first_node_[nodes_[i].body] + nodes_[i].index,
                    {{group.data(field, 0)[i], group.data(field, 1)[i]}}};
    Vectors values(first_node_.back());
    for (const OfNode& of : ranks_.all_gather(owned)) values[of.node] = of.value;
    return values;
}

void SpringBodies::show_in(ParticleStore& particles, Field field, const std::vector<Vector<double, 2>>& values) const {
    ParticleGroup& group = particles.of(ParticleKind::springs);
    for (std::size_t i = 0; i < group.total(); ++i)
        for (int axis = 0; axis < 2; ++axis)
            group.data(field, axis)[i] = values[first_node_[nodes_[i].body] + nodes_[i].index][axis];
}

template <class ValueOf>
void SpringBodies::show(ParticleStore& particles, Field field, const ValueOf& value_of) const {
    ParticleGroup& group = particles.of(ParticleKind::springs);
    for (std::size_t i = 0; i < group.total(); ++i) {
        const auto value = value_of(bodies_[nodes_[i].body], static_cast<std::size_t>(nodes_[i].index));
        for (int axis = 0; axis < 2; ++axis) {
            double& shown = group.data(field, axis)[i];
            shown = field == Field::position ? shown + value[axis] : value[axis];
        }
    }
}

SpringBody::Impulses SpringBodies::advance(ParticleStore& particles, double dt, int threads) {
    const int steps = substeps(dt);
    const Vectors force = collected(particles, Field::force);
    std::vector<SpringBody::Impulses> impulses(bodies_.size());
    std::vector<std::exception_ptr> errors(bodies_.size());  // must not leave the parallel loop
    const auto count = static_cast<std::ptrdiff_t>(bodies_.size());
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (std::ptrdiff_t b = 0; b < count; ++b) {
        try {
            SpringBody& body = bodies_[b];
            const auto of_holders = body.kick_from_outside(std::span(force).subspan(first_node_[b]), dt);
            impulses[b] = implicit_ ? body.advance_implicit(dt) : body.advance_subcycled(dt, steps);
            impulses[b].of_anchors += of_holders;
        } catch (...) {
            errors[b] = std::current_exception();
        }
    }
    for (const auto& error : errors)
        if (error) std::rethrow_exception(error);
    SpringBody::Impulses sum{};
    for (const auto& impulse : impulses) {
        sum.of_anchors += impulse.of_anchors;
        sum.of_drag += impulse.of_drag;
    }
    show(particles, Field::velocity,
         [dt](const SpringBody& body, std::size_t node) { return body.mean_velocity(node, dt); });
    return sum;
}

double SpringBodies::show_positions(ParticleStore& particles) const {
    const PositionQuantum& quantum = particles.quantum();
    double farthest = 0;
    // The store's positions may have been moved by whole periods: hand on the displacement.
    show(particles, Field::position, [&](const SpringBody& body, std::size_t node) {
        Vector<double, 2> way{};
        for (int axis = 0; axis < 2; ++axis)
            way[axis] =
                quantum.round(body.positions()[node][axis]) - quantum.round(body.positions_before()[node][axis]);
        return way;
    });
    for (const SpringBody& body : bodies_)
        for (std::size_t node = 0; node < body.ids().size(); ++node) {
            const auto way = body.positions()[node] - body.positions_before()[node];
            farthest = std::max(farthest, dot(way, way));
        }
    return std::sqrt(farthest);
}

}  // namespace dmp
