// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "solver/time/implicit_system.hpp"

namespace dmp {

SpringBody::SpringBody(const ParticleSet& set, const Part& part, int body)
    : part_(part.name), drag_(part.drag), spacing_(set.spacing) {
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
    position_before_ = position_at_rest_ = position_;
    for (const Bond& bond : set.bonds) {
        if (set.body[bond.a] != body) continue;
        const double reduced = set.mass[bond.a] * set.mass[bond.b] / (set.mass[bond.a] + set.mass[bond.b]);
        bonds_.push_back({local.at(bond.a), local.at(bond.b),
                          BondForce<2>(bond.rest_length, bond.stiffness, part.bond_damping, reduced)});
        drawn_bonds_.push_back({local.at(bond.a), local.at(bond.b), bond.rest_length, bond.stiffness});
    }
    for (const Hinge& hinge : set.hinges) {
        if (set.body[hinge.centre] != body) continue;
        const auto inertia = [&](int end) {
            return set.mass[end] * (set.position[end] - set.position[hinge.centre]).squaredNorm();
        };
        const double reduced = inertia(hinge.a) * inertia(hinge.b) / (inertia(hinge.a) + inertia(hinge.b));
        hinges_.push_back({local.at(hinge.a), local.at(hinge.centre), local.at(hinge.b),
                           HingeForce(hinge.rest_angle, hinge.stiffness, part.bond_damping, reduced)});
    }
}

void SpringBody::add_forces(const Vectors& position, const Vectors& velocity, Vectors& force) const {
    for (const LocalBond& bond : bonds_) {
        const auto f = bond.force.law(position[bond.a] - position[bond.b], velocity[bond.a] - velocity[bond.b]);
        force[bond.a] += f;
        force[bond.b] -= f;
    }
    for (const LocalHinge& hinge : hinges_) {
        const auto arm = [&](int end) {
            return HingeForce::Arm{position[end] - position[hinge.centre], velocity[end] - velocity[hinge.centre]};
        };
        const auto f = hinge.force.law(arm(hinge.a), arm(hinge.b));
        force[hinge.a] += f.on_a;
        force[hinge.b] += f.on_b;
        force[hinge.centre] -= f.on_a + f.on_b;
    }
}

void SpringBody::drift(double h) {
    for (std::size_t n = 0; n < ids_.size(); ++n)
        if (!fixed_[n]) position_[n] += h * velocity_[n];
}

Vector<double, 2> SpringBody::kick_from_outside(std::span<const Vector<double, 2>> force, double dt) {
    Vector<double, 2> of_holders{};
    for (std::size_t n = 0; n < ids_.size(); ++n) {
        if (fixed_[n]) {
            of_holders -= dt * force[n];
        } else {
            velocity_[n] += (dt / mass_[n]) * force[n];
        }
    }
    return of_holders;
}

double SpringBody::free_mass() const {
    double mass = 0;
    for (std::size_t n = 0; n < ids_.size(); ++n) mass += fixed_[n] ? 0 : mass_[n];
    return mass;
}

Vector<double, 2> SpringBody::momentum() const {
    Vector<double, 2> sum{};
    for (std::size_t n = 0; n < ids_.size(); ++n)
        if (!fixed_[n]) sum += mass_[n] * velocity_[n];
    return sum;
}

void SpringBody::kick(double h, const Vectors& force, const Vectors& drag_velocity, Impulses& impulses) {
    for (std::size_t n = 0; n < ids_.size(); ++n) {
        if (fixed_[n]) {
            impulses.of_anchors -= h * force[n];
            continue;
        }
        const auto drag = -drag_ * drag_velocity[n];
        impulses.of_drag += h * drag;
        velocity_[n] += (h / mass_[n]) * (force[n] + drag);
    }
}

SpringBody::Impulses SpringBody::advance_subcycled(double dt, int substeps) {
    position_before_ = position_;
    Impulses impulses{};
    const double h = dt / substeps;
    drift(h / 2);
    for (int step = 0; step < substeps; ++step) {
        std::fill(force_.begin(), force_.end(), Vector<double, 2>{});
        add_forces(position_, velocity_, force_);
        kick(h, force_, velocity_, impulses);
        drift(step + 1 < substeps ? h : h / 2);
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
        Vectors ahead = position_, behind = position_;
        Vectors force_ahead(ids_.size(), Vector<double, 2>{}), force_behind = force_ahead;
        for (std::size_t n = 0; n < ids_.size(); ++n) {
            mode[n] = (1 / norm) * mode[n];
            ahead[n] += small * mode[n];
            behind[n] -= small * mode[n];
        }
        add_forces(ahead, at_rest, force_ahead);
        add_forces(behind, at_rest, force_behind);
        omega_square = 0;
        for (std::size_t n = 0; n < ids_.size(); ++n) {
            const auto image = (-0.5 / (small * mass_[n])) * (force_ahead[n] - force_behind[n]);
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
        energy += hinge.force.energy(position_[hinge.a] - position_[hinge.centre],
                                     position_[hinge.b] - position_[hinge.centre]);
    return energy;
}

std::vector<Vector<double, 2>> SpringBody::forces(const Vectors& position, const Vectors& velocity) const {
    Vectors force(ids_.size(), Vector<double, 2>{});
    add_forces(position, velocity, force);
    return force;
}

}  // namespace dmp
