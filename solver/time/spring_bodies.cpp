// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "solver/time/implicit_system.hpp"

namespace dmp {

SpringBodies::SpringBodies(const ParticleSet& set, const Scene& scene)
    : implicit_(scene.accuracy.spring_stepping.value == SpringStepping::implicit) {
    const int count = set.body.empty() ? 0 : *std::max_element(set.body.begin(), set.body.end()) + 1;
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
}

int SpringBodies::substeps(double dt) const {
    if (empty()) return 0;
    return implicit_ ? 1 : std::max(1, static_cast<int>(std::ceil(dt / largest_step_)));
}

SpringBody::Impulses SpringBodies::advance(ParticleStore& particles, double dt, int threads) {
    const int steps = substeps(dt);
    std::vector<SpringBody::Impulses> impulses(bodies_.size());
    std::vector<std::exception_ptr> errors(bodies_.size());  // must not leave the parallel loop
    const auto count = static_cast<std::ptrdiff_t>(bodies_.size());
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (std::ptrdiff_t b = 0; b < count; ++b) {
        try {
            SpringBody& body = bodies_[b];
            body.kick_from_outside(particles, dt);
            impulses[b] = implicit_ ? body.advance_implicit(dt) : body.advance_subcycled(dt, steps);
            body.show_mean_velocity(particles, dt);
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
    return sum;
}

void SpringBodies::show_positions(ParticleStore& particles) const {
    for (const SpringBody& body : bodies_) body.show_position(particles);
}

}  // namespace dmp
