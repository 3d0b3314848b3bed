// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "solver/elastic/cell_body.hpp"
#include "solver/elastic/implicit_system.hpp"

namespace dmp::solver {

namespace {

template <int D, std::size_t K>
Arms<D, K> shift_of(const std::array<Vec, K>& in_space) {
    Arms<D, K> shift{};
    for (std::size_t k = 0; k < K; ++k)
        for (int axis = 0; axis < D; ++axis) shift[k][axis] = in_space[k][axis];
    return shift;
}

template <int D, std::size_t K>
std::array<Vec, K> as_in_space(const Arms<D, K>& shift) {
    auto in_space = BodyParts::no_shift<K>();
    for (std::size_t k = 0; k < K; ++k)
        for (int axis = 0; axis < D; ++axis) in_space[k][axis] = shift[k][axis];
    return in_space;
}

}  // namespace

std::unique_ptr<SpringBody> SpringBody::make(const ParticleSet& set, const Part& part, int body,
                                             const SpringContact& contact) {
    if (set.dimension == 3) return std::make_unique<SpringNetwork<3>>(set, part, body, contact);
    return std::make_unique<SpringNetwork<2>>(set, part, body, contact);
}

std::unique_ptr<SpringBody> SpringBody::make(const BodyParts& parts, const std::string& name,
                                             const ParticleSpace& space, const SpringContact& contact) {
    if (!parts.cells.empty()) {
        if (space.dimension == 3) return std::make_unique<CellBody<3>>(parts, name, space.spacing, contact);
        return std::make_unique<CellBody<2>>(parts, name, space.spacing, contact);
    }
    if (space.dimension == 3) return std::make_unique<SpringNetwork<3>>(parts, name, space.spacing, contact);
    return std::make_unique<SpringNetwork<2>>(parts, name, space.spacing, contact);
}

template <int D>
SpringNetwork<D>::SpringNetwork(const ParticleSet& set, const Part& part, int body, const SpringContact& contact)
    : SpringNetwork(initial_body(set, InitialSprings(set, part), body, contact.of_itself() ? contact.range : 0),
                    part.name, set.spacing, contact) {}

template <int D>
SpringNetwork<D>::SpringNetwork(const BodyParts& parts, const std::string& name, double spacing,
                                const SpringContact& contact)
    : SpringBody(name), spacing_(spacing) {
    const auto& [nodes, bonds, hinges, dihedrals, cells, faces, held_apart] = parts;  // all: one more does not compile
    for (const BodyParts::Node& node : nodes) {
        ids_.push_back(node.id);
        fixed_.push_back(node.fixed ? 1 : 0);
        of_wall_.push_back(node.of_wall ? 1 : 0);
        auto& on_plane = on_plane_.emplace_back();
        for (int axis = 0; axis < D; ++axis) on_plane[axis] = node.on_plane[axis];
        origin_.push_back(node.origin);
        mass_.push_back(node.mass);
        drag_.push_back(node.drag);
        position_.push_back(of_space(node.position));
        velocity_.push_back(of_space(node.velocity));
        position_before_.push_back(of_space(node.position_before));
        position_at_rest_.push_back(of_space(node.rest_position));
        surface_.push_back(node.surface);
    }
    force_.assign(ids_.size(), {});
    for (const auto& bond : bonds) {
        bonds_.push_back({bond.node, BondForce<D>(bond.rest, {bond.stiffness, bond.dashpot}), shift_of<D>(bond.shift)});
        bond_list_.push_back({{bond.node[0], bond.node[1], bond.rest, bond.stiffness}, bond.shift[0]});
        bond_origin_.push_back(bond.origin);
    }
    for (const auto& hinge : hinges)
        hinges_.push_back(
            {hinge.node, HingeForce<D>(hinge.rest, {hinge.stiffness, hinge.dashpot}), shift_of<D>(hinge.shift)});
    if constexpr (D == 3)
        for (const auto& dihedral : dihedrals)
            dihedrals_.push_back({dihedral.node, DihedralForce(dihedral.rest, {dihedral.stiffness, dihedral.dashpot}),
                                  shift_of<D>(dihedral.shift)});
    for (const BodyParts::Cell& cell : cells) cells_.emplace_back(cell);
    if (contact.of_itself()) self_contact_ = std::make_unique<SelfContact<D>>(contact, held_apart, of_wall_);
}

template <int D>
BodyParts SpringNetwork<D>::parts() const {
    BodyParts parts;
    for (std::size_t n = 0; n < ids_.size(); ++n) {
        std::array<bool, 3> on_plane{};
        std::ranges::copy(on_plane_[n], on_plane.begin());
        parts.nodes.push_back({ids_[n], fixed_[n] != 0, of_wall_[n] != 0, on_plane, origin_[n], mass_[n], drag_[n],
                               in_space(position_[n]), in_space(velocity_[n]), in_space(position_before_[n]),
                               in_space(position_at_rest_[n]), surface_[n]});
    }
    for (std::size_t b = 0; b < bonds_.size(); ++b) {
        const auto& law = bonds_[b].law;
        parts.bonds.push_back(
            {bonds_[b].node, law.rest_length, law.stiffness, law.dashpot, bond_origin_[b], {bond_list_[b].shift}});
    }
    const auto add_angle = [](auto& angles, const auto& spring) {
        angles.push_back({spring.node, spring.law.rest_angle, spring.law.stiffness, spring.law.dashpot, 0,
                          as_in_space<D>(spring.shift)});
    };
    for (const auto& hinge : hinges_) add_angle(parts.hinges, hinge);
    if constexpr (D == 3)
        for (const auto& dihedral : dihedrals_) add_angle(parts.dihedrals, dihedral);
    if (self_contact_) parts.held_apart = self_contact_->held_apart();
    return parts;
}

template <int D>
void SpringNetwork<D>::add_forces(const Vectors& position, const Vectors& velocity, Vectors& force) const {
    for_each_spring([&](const auto& spring) {
        const auto from_rest = spring.law.deviation(spring.arms_at(position));
        const double tension = spring.law.tension(from_rest, spring.arms(velocity));
        spring.for_each_node(from_rest.gradient, [&](int node, double sign, const Point& slope) {
            force[node] += (-sign * tension) * slope;
        });
    });
    add_cell_forces(position, velocity, force);
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
double SpringNetwork<D>::self_contact_rate() const {
    if (!self_contact_) return 0;
    std::vector<double> inverse_mass;
    inverse_mass.reserve(ids_.size());
    for (std::size_t n = 0; n < ids_.size(); ++n) inverse_mass.push_back(fixed_[n] ? 0 : 1 / mass_[n]);
    return self_contact_->rate(position_, inverse_mass);
}

template <int D>
void SpringNetwork<D>::drift(double h) {
    for (std::size_t n = 0; n < ids_.size(); ++n)
        if (!fixed_[n]) position_[n] += h * velocity_[n];
}

template <int D>
typename SpringNetwork<D>::Point SpringNetwork<D>::kick_from_outside(std::span<const Point> force, double dt) {
    Point of_holders{};
    for (std::size_t n = 0; n < ids_.size(); ++n) push(n, dt, force[n], of_holders);
    return of_holders;
}

template <int D>
void SpringNetwork<D>::push(std::size_t node, double h, const Point& force, Point& of_holders) {
    for (int axis = 0; axis < D; ++axis) {
        if (is_held(node, axis)) {
            of_holders[axis] -= h * force[axis];
        } else {
            velocity_[node][axis] += (h / mass_[node]) * force[axis];
        }
    }
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
        const auto drag = -drag_[n] * drag_velocity[n];
        impulses.of_drag += h * drag;
        push(n, h, force[n] + drag, impulses.of_anchors);
    }
}

template <int D>
typename SpringNetwork<D>::Impulses SpringNetwork<D>::advance_subcycled(double dt, int substeps) {
    position_before_ = position_;
    crushed_at_.reset();
    Impulses impulses{};
    const double h = dt / substeps;
    drift(h / 2);
    for (int step = 0; step < substeps; ++step) {
        std::fill(force_.begin(), force_.end(), Point{});
        add_forces(position_, velocity_, force_);
        refuse_crushed_cells();
        kick(h, force_, velocity_, impulses);
        drift(step + 1 < substeps ? h : h / 2);
    }
    return impulses;
}

template <int D>
double SpringNetwork<D>::step_limit() const {
    const double longest = bonds_.empty() ? spacing_ : bonds_.front().law.rest_length;
    const double small = 1e-6 * longest;
    const Vectors at_rest(ids_.size(), Point{});
    Vectors mode(ids_.size());
    for (std::size_t n = 0; n < ids_.size(); ++n)  // any start that is not an eigenvector of a smooth mode
        for (int axis = 0; axis < D; ++axis)
            mode[n][axis] = std::sin((12.9898 + 65.2432 * axis) * static_cast<double>(n + 1) + 1.5708 * axis);

    double omega_square = 0;
    for (int iteration = 0; iteration < 300; ++iteration) {
        double norm = 0;
        for (std::size_t n = 0; n < ids_.size(); ++n) {
            for (int axis = 0; axis < D; ++axis)
                if (is_held(n, axis)) mode[n][axis] = 0;
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
            auto image = (-0.5 / (small * mass_[n])) * (force_ahead[n] - force_behind[n]);
            for (int axis = 0; axis < D; ++axis)
                if (is_held(n, axis)) image[axis] = 0;
            omega_square += dot(image, image);
            mode[n] = image;
        }
        omega_square = std::sqrt(omega_square);  // M^-1 K mode| of a unit mode: approaches omega^2 from below
    }
    return 2 / std::sqrt(1.02 * omega_square);
}

template <int D>
double SpringNetwork<D>::energy() const {
    double energy = 0;
    for_each_spring([&](const auto& spring) {
        energy += spring.law.energy(spring.law.deviation(spring.arms_at(position_)).value);
    });
    for (const LocalCell<D>& cell : cells_) energy += cell.energy(cell.at(position_));
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

}  // namespace dmp::solver
