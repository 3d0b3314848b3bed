// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/time/spring_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace dmp {

SpringBody::SpringBody(const ParticleSet& set, const Part& part, int body) : drag_(part.drag) {
    std::unordered_map<int, int> local;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.body[i] != body) continue;
        local[static_cast<int>(i)] = static_cast<int>(ids_.size());
        ids_.push_back(static_cast<int>(i));
        fixed_.push_back(set.fixed[i]);
        mass_.push_back(set.mass[i]);
        position_.push_back({{set.position[i][0], set.position[i][1]}});
    }
    velocity_.assign(ids_.size(), {});
    force_.assign(ids_.size(), {});
    for (const Bond& bond : set.bonds) {
        if (set.body[bond.a] != body) continue;
        const double reduced = set.mass[bond.a] * set.mass[bond.b] / (set.mass[bond.a] + set.mass[bond.b]);
        bonds_.push_back({local.at(bond.a), local.at(bond.b),
                          BondForce<2>(bond.rest_length, bond.stiffness, part.bond_damping, reduced)});
    }
    for (const Hinge& hinge : set.hinges)
        if (set.body[hinge.centre] == body)
            hinges_.push_back({local.at(hinge.a), local.at(hinge.centre), local.at(hinge.b),
                               HingeForce(hinge.rest_angle, hinge.stiffness)});
}

void SpringBody::add_forces(const Vectors& position, const Vectors& velocity, Vectors& force) const {
    for (const LocalBond& bond : bonds_) {
        const auto f = bond.force.law(position[bond.a] - position[bond.b], velocity[bond.a] - velocity[bond.b]);
        force[bond.a] += f;
        force[bond.b] -= f;
    }
    for (const LocalHinge& hinge : hinges_) {
        const auto f = hinge.force.law(position[hinge.a] - position[hinge.centre], position[hinge.b] - position[hinge.centre]);
        force[hinge.a] += f.on_a;
        force[hinge.b] += f.on_b;
        force[hinge.centre] -= f.on_a + f.on_b;
    }
}

void SpringBody::drift(double h) {
    for (std::size_t n = 0; n < ids_.size(); ++n)
        if (!fixed_[n]) position_[n] += h * velocity_[n];
}

SpringBody::Impulses SpringBody::advance(ParticleStore& particles, double dt, int substeps) {
    std::array<double*, 2> x{}, v{};
    for (int axis = 0; axis < 2; ++axis) {
        x[axis] = particles.data(Field::position, axis);
        v[axis] = particles.data(Field::velocity, axis);
    }
    for (std::size_t n = 0; n < ids_.size(); ++n) velocity_[n] = {{v[0][ids_[n]], v[1][ids_[n]]}};
    const Vectors before = position_;

    Impulses impulses{};
    const double h = dt / substeps;
    drift(h / 2);
    for (int step = 0; step < substeps; ++step) {
        std::fill(force_.begin(), force_.end(), Vector<double, 2>{});
        add_forces(position_, velocity_, force_);
        for (std::size_t n = 0; n < ids_.size(); ++n) {
            if (fixed_[n]) {
                impulses.of_anchors -= h * force_[n];
                continue;
            }
            const auto drag = -drag_ * velocity_[n];
            impulses.of_drag += h * drag;
            velocity_[n] += (h / mass_[n]) * (force_[n] + drag);
        }
        drift(step + 1 < substeps ? h : h / 2);
    }

    // The store's positions may have been wrapped by whole periods: hand on the displacement.
    for (std::size_t n = 0; n < ids_.size(); ++n)
        for (int axis = 0; axis < 2; ++axis) {
            x[axis][ids_[n]] += position_[n][axis] - before[n][axis];
            v[axis][ids_[n]] = velocity_[n][axis];
        }
    return impulses;
}

double SpringBody::step_limit() const {
    const double longest = bonds_.empty() ? 1 : bonds_.front().force.rest_length;
    const double small = 1e-6 * longest;
    const Vectors at_rest(ids_.size(), Vector<double, 2>{});
    Vectors mode(ids_.size());
    for (std::size_t n = 0; n < ids_.size(); ++n)  // any start that is no eigenvector of a smooth mode
        mode[n] = {{std::sin(12.9898 * static_cast<double>(n + 1)), std::cos(78.233 * static_cast<double>(n + 1))}};

    double omega_square = 0;
    for (int iteration = 0; iteration < 300; ++iteration) {
        double norm = 0;
        for (std::size_t n = 0; n < ids_.size(); ++n) {
            if (fixed_[n]) mode[n] = {};
            norm += dot(mode[n], mode[n]);
        }
        norm = std::sqrt(norm);
        if (norm == 0) return std::numeric_limits<double>::infinity();
        Vectors plus = position_, minus = position_, force(ids_.size(), Vector<double, 2>{}), opposite = force;
        for (std::size_t n = 0; n < ids_.size(); ++n) {
            mode[n] = (1 / norm) * mode[n];
            plus[n] += small * mode[n];
            minus[n] -= small * mode[n];
        }
        add_forces(plus, at_rest, force);
        add_forces(minus, at_rest, opposite);
        omega_square = 0;
        for (std::size_t n = 0; n < ids_.size(); ++n) {
            const auto image = (-0.5 / (small * mass_[n])) * (force[n] - opposite[n]);
            omega_square += fixed_[n] ? 0 : dot(image, image);
            mode[n] = image;
        }
        omega_square = std::sqrt(omega_square);  // |M^-1 K mode| of a unit mode: approaches omega^2 from below
    }
    return 2 / std::sqrt(1.02 * omega_square);
}

double SpringBody::energy() const {
    double energy = 0;
    for (const LocalBond& bond : bonds_) {
        const auto separation = position_[bond.a] - position_[bond.b];
        energy += bond.force.energy(std::sqrt(dot(separation, separation)));
    }
    for (const LocalHinge& hinge : hinges_)
        energy += hinge.force.energy(position_[hinge.a] - position_[hinge.centre], position_[hinge.b] - position_[hinge.centre]);
    return energy;
}

const std::vector<Vector<double, 2>>& SpringBody::spring_forces() {
    std::fill(force_.begin(), force_.end(), Vector<double, 2>{});
    add_forces(position_, velocity_, force_);
    return force_;
}

SpringBodies::SpringBodies(const ParticleSet& set, const Scene& scene) {
    const int count = set.body.empty() ? 0 : *std::max_element(set.body.begin(), set.body.end()) + 1;
    double shortest = std::numeric_limits<double>::infinity();
    for (int body = 0; body < count; ++body) {
        const auto node = std::find(set.body.begin(), set.body.end(), body) - set.body.begin();
        const std::string& name = set.parts[set.part[node]].name;
        const auto parts = scene.parts_of(PartKind::springs);
        const auto part = std::find_if(parts.begin(), parts.end(), [&](const Part* p) { return p->name.value == name; });
        if (part == parts.end())
            throw InputError("the particles have a springs part '" + name + "' that the scene does not know",
                             "mesh the scene again");
        bodies_.emplace_back(set, **part, body);
        const double limit = bodies_.back().step_limit();
        shortest = std::min(shortest, limit);
        const auto known = std::find_if(limits_.begin(), limits_.end(), [&](const PartLimit& l) { return l.part == name; });
        if (known == limits_.end()) {
            limits_.push_back({name, limit});
        } else {
            known->dt = std::min(known->dt, limit);
        }
    }
    largest_step_ = shortest * scene.accuracy.spring_step_factor;
}

int SpringBodies::substeps(double dt) const {
    return empty() ? 0 : std::max(1, static_cast<int>(std::ceil(dt / largest_step_)));
}

SpringBody::Impulses SpringBodies::advance(ParticleStore& particles, double dt, int threads) {
    const int steps = substeps(dt);
    std::vector<SpringBody::Impulses> impulses(bodies_.size());
    const auto count = static_cast<std::ptrdiff_t>(bodies_.size());
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (std::ptrdiff_t b = 0; b < count; ++b) impulses[b] = bodies_[b].advance(particles, dt, steps);
    SpringBody::Impulses sum{};
    for (const auto& impulse : impulses) {
        sum.of_anchors += impulse.of_anchors;
        sum.of_drag += impulse.of_drag;
    }
    return sum;
}

}  // namespace dmp
