// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "base/errors.hpp"
#include "solver/time/implicit_system.hpp"

namespace dmp {

std::unique_ptr<SpringBody> SpringBody::make(const ParticleSet& set, const Part& part, int body,
                                             const SpringContact& contact) {
    if (set.dimension == 3) return std::make_unique<SpringNetwork<3>>(set, part, body, contact);
    return std::make_unique<SpringNetwork<2>>(set, part, body, contact);
}

template <int D>
SpringNetwork<D>::SpringNetwork(const ParticleSet& set, const Part& part, int body, const SpringContact& contact)
    : SpringBody(part.name), drag_(part.drag), spacing_(set.spacing) {
    std::unordered_map<int, int> local;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.body[i] != body) continue;
        local[static_cast<int>(i)] = static_cast<int>(ids_.size());
        ids_.push_back(static_cast<int>(i));
        fixed_.push_back(set.fixed[i]);
        mass_.push_back(set.mass[i]);
        position_.push_back(of_space(set.position[i]));
    }
    velocity_.assign(ids_.size(), {});
    force_.assign(ids_.size(), {});
    position_before_ = position_at_rest_ = position_;

    const double damping = part.bond_damping;
    const auto reduced = [](double a, double b) { return a * b / (a + b); };
    for (const Bond& bond : set.bonds) {
        if (set.body[bond.a] != body) continue;
        const std::array<int, 2> nodes{local.at(bond.a), local.at(bond.b)};
        bonds_.push_back({nodes, BondForce<D>(bond.rest_length, bond.stiffness, damping,
                                              reduced(set.mass[bond.a], set.mass[bond.b]))});
        drawn_bonds_.push_back({nodes[0], nodes[1], bond.rest_length, bond.stiffness});
    }
    for (const Hinge& hinge : set.hinges) {
        if (set.body[hinge.centre] != body) continue;
        const auto inertia = [&](int end) {
            return set.mass[end] * (set.position[end] - set.position[hinge.centre]).squaredNorm();
        };
        hinges_.push_back(
            {{local.at(hinge.a), local.at(hinge.centre), local.at(hinge.b)},
             HingeForce<D>(hinge.rest_angle, hinge.stiffness, damping, reduced(inertia(hinge.a), inertia(hinge.b)))});
    }
    for (const Dihedral& dihedral : set.dihedrals) {
        if (set.body[dihedral.b] != body) continue;
        if constexpr (D == 3) {
            const Vec axis = (set.position[dihedral.c] - set.position[dihedral.b]).normalized();
            const auto inertia = [&](int end) {
                return set.mass[end] * axis.cross(set.position[end] - set.position[dihedral.b]).squaredNorm();
            };
            dihedrals_.push_back(
                {{local.at(dihedral.a), local.at(dihedral.b), local.at(dihedral.c), local.at(dihedral.d)},
                 DihedralForce(dihedral.rest_angle, dihedral.stiffness, damping,
                               reduced(inertia(dihedral.a), inertia(dihedral.d)))});
        } else {
            throw InputError("'" + part.name.value + "' has dihedrals, and there are none in the plane",
                             "write dimension = 3, or leave them out");
        }
    }
    if (!contact.on()) return;
    double longest = 0;
    for (const Bond& bond : drawn_bonds_) longest = std::max(longest, bond.rest_length);
    self_contact_ = std::make_unique<SelfContact<D>>(contact, position_at_rest_,
                                                     SelfContact<D>::neighbourhood(contact.range, longest));
}

template <int D>
void SpringNetwork<D>::add_forces(const Vectors& position, const Vectors& velocity, Vectors& force) const {
    for_each_spring([&](const auto& spring) {
        const auto from_rest = spring.law.deviation(spring.arms(position));
        const double tension = spring.law.tension(from_rest, spring.arms(velocity));
        spring.for_each_node(from_rest.gradient, [&](int node, double sign, const Point& slope) {
            force[node] += (-sign * tension) * slope;
        });
    });
}

template <int D>
SpringImpulses SpringNetwork<D>::advance(std::span<const Vec> force, double dt, int substeps) {
    Vectors on_nodes(ids_.size());
    for (std::size_t n = 0; n < ids_.size(); ++n) on_nodes[n] = of_space(force[n]);
    if (self_contact_) self_contact_->add_forces(position_, on_nodes);
    const Point of_holders = kick_from_outside(on_nodes, dt);
    Impulses given = substeps > 0 ? advance_subcycled(dt, substeps) : advance_implicit(dt);
    given.of_anchors += of_holders;
    SpringImpulses impulses;
    for (int axis = 0; axis < D; ++axis) {
        impulses.of_anchors[axis] = given.of_anchors[axis];
        impulses.of_drag[axis] = given.of_drag[axis];
    }
    return impulses;
}

template <int D>
void SpringNetwork<D>::drift(double h) {
    for (std::size_t n = 0; n < ids_.size(); ++n)
        if (!fixed_[n]) position_[n] += h * velocity_[n];
}

template <int D>
typename SpringNetwork<D>::Point SpringNetwork<D>::kick_from_outside(std::span<const Point> force, double dt) {
    Point of_holders{};
    for (std::size_t n = 0; n < ids_.size(); ++n) {
        if (fixed_[n]) {
            of_holders -= dt * force[n];
        } else {
            velocity_[n] += (dt / mass_[n]) * force[n];
        }
    }
    return of_holders;
}

template <int D>
double SpringNetwork<D>::free_mass() const {
    double mass = 0;
    for (std::size_t n = 0; n < ids_.size(); ++n) mass += fixed_[n] ? 0 : mass_[n];
    return mass;
}

template <int D>
typename SpringNetwork<D>::Point SpringNetwork<D>::momentum() const {
    Point sum{};
    for (std::size_t n = 0; n < ids_.size(); ++n)
        if (!fixed_[n]) sum += mass_[n] * velocity_[n];
    return sum;
}

template <int D>
void SpringNetwork<D>::kick(double h, const Vectors& force, const Vectors& drag_velocity, Impulses& impulses) {
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

template <int D>
typename SpringNetwork<D>::Impulses SpringNetwork<D>::advance_subcycled(double dt, int substeps) {
    position_before_ = position_;
    Impulses impulses{};
    const double h = dt / substeps;
    drift(h / 2);
    for (int step = 0; step < substeps; ++step) {
        std::fill(force_.begin(), force_.end(), Point{});
        add_forces(position_, velocity_, force_);
        kick(h, force_, velocity_, impulses);
        drift(step + 1 < substeps ? h : h / 2);
    }
    return impulses;
}

template <int D>
double SpringNetwork<D>::step_limit() const {
    const double longest = bonds_.empty() ? 1 : bonds_.front().law.rest_length;
    const double small = 1e-6 * longest;
    const Vectors at_rest(ids_.size(), Point{});
    Vectors mode(ids_.size());
    for (std::size_t n = 0; n < ids_.size(); ++n)  // any start that is no eigenvector of a smooth mode
        for (int axis = 0; axis < D; ++axis)
            mode[n][axis] = std::sin((12.9898 + 65.2432 * axis) * static_cast<double>(n + 1) + 1.5708 * axis);

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
        Vectors force_ahead(ids_.size(), Point{}), force_behind = force_ahead;
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

template <int D>
double SpringNetwork<D>::energy() const {
    double energy = 0;
    for_each_spring(
        [&](const auto& spring) { energy += spring.law.energy(spring.law.deviation(spring.arms(position_)).value); });
    return energy;
}

template <int D>
typename SpringNetwork<D>::Vectors SpringNetwork<D>::forces(const Vectors& position, const Vectors& velocity) const {
    Vectors force(ids_.size(), Point{});
    add_forces(position, velocity, force);
    return force;
}

template class SpringNetwork<2>;
template class SpringNetwork<3>;

}  // namespace dmp
