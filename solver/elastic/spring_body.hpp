// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/vec.hpp"
#include "models/elastic/solid_break.hpp"
#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/elastic/body_parts.hpp"
#include "solver/elastic/self_contact.hpp"
#include "solver/state/archive.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// A cell of an elastic solid is pressed to almost nothing or turned inside out.
class CrushedCell : public DivergenceError {
  public:
    using DivergenceError::DivergenceError;
};

/// Impulses on elastic bodies from outside [N s].
struct SpringImpulses {
    std::array<double, 3> of_anchors{};  ///< by the supports of fixed nodes
    std::array<double, 3> of_drag{};     ///< by lab-frame drag
};

/// The surface of an elastic solid in front of one of its particles, and how the solid moves there.
struct PresentSurface {
    SolidSurface surface{};
    Eigen::Matrix3d velocity_gradient = Eigen::Matrix3d::Zero();  ///< [a][b] = dv_a/dx_b [1/s]
};

/// A point of the material as the body's unknowns carry it: x = SUM share_k x_k + shift. Shares add up to one, and a
/// uniform deformation carries it exactly.
struct CarriedPoint {
    struct Share {
        int unknown = 0;
        double share = 0;
    };
    std::vector<Share> shares;
    Vec shift = Vec::Zero();  ///< whole periods [m]
};

/// One connected piece of an elastic solid, as an interface for the rest of the solver, in 2-D (z = 0) or in 3-D.
class SpringBody {
  public:
    SpringBody(const SpringBody&) = delete;
    SpringBody& operator=(const SpringBody&) = delete;
    virtual ~SpringBody() = default;

    /// The body of this number, with the springs between its nodes. Throws InputError for a body with dihedrals in
    /// 2-D.
    static std::unique_ptr<SpringBody> make(const ParticleSet& set, const Part& part, int body,
                                            const SpringContact& contact = {});
    /// The body that consists of these parts, with a name.
    static std::unique_ptr<SpringBody> make(const BodyParts& parts, const std::string& name, const ParticleSpace& space,
                                            const SpringContact& contact);

    /// Whether its particles are cells between nodes, or nodes between springs.
    [[nodiscard]] virtual bool consists_of_cells() const { return false; }

    /// Its parts in their current state.
    [[nodiscard]] virtual BodyParts parts() const = 0;

    /// Kicks the nodes by external forces [N] and by contact of the body with itself; then advances them by dt under
    /// the springs' forces: in `substeps` equal explicit steps, or in one implicit step (0).
    virtual SpringImpulses advance(std::span<const Vec> force, double dt, int substeps) = 0;

    /// The advances between these two are parts of one step: what is before is before the first of them.
    virtual void start_parts() = 0;
    virtual void end_parts() = 0;

    /// What the body's equations are solved for (ViscousNodes): its nodes. They are its particles, but where it
    /// consists of cells, whose particles move with the nodes at their corners.
    [[nodiscard]] virtual std::size_t unknowns() const { return nodes(); }
    [[nodiscard]] virtual double unknown_mass(std::size_t unknown) const { return mass(unknown); }  ///< [kg]
    /// Velocities of the particles, from those of the unknowns.
    [[nodiscard]] virtual std::vector<Vec> of_particles(std::span<const Vec> of_unknowns) const {
        return {of_unknowns.begin(), of_unknowns.end()};
    }
    /// Forces, or drag by axis, on the unknowns, from those on the particles; 0 where an unknown is held.
    [[nodiscard]] virtual std::vector<Vec> on_unknowns(std::span<const Vec> on_particles) const;
    /// Velocities from which a solution is looked for: those of the particles, or of the nodes that move them.
    [[nodiscard]] virtual std::vector<Vec> unknown_velocities(std::span<const Vec> of_particles) const {
        return {of_particles.begin(), of_particles.end()};
    }

    [[nodiscard]] virtual Vec unknown_position(std::size_t unknown) const { return position(unknown); }  ///< [m]
    /// At the end of the last advance, not the mean over it [m/s].
    [[nodiscard]] virtual Vec unknown_velocity(std::size_t unknown) const { return velocity(unknown); }
    [[nodiscard]] virtual bool unknown_fixed(std::size_t unknown) const { return fixed(unknown); }
    /// The point of the material that is at `at_rest` [m] when the body is; it may lie a little outside. `near`: some
    /// of its particles near there, the nearest first.
    [[nodiscard]] virtual CarriedPoint carry(const Vec& at_rest, std::span<const int> near,
                                             const ParticleSpace& space) const = 0;
    /// Changes velocities by dt F / m, with the forces F on the unknowns [N]. Returns the impulse of the supports
    /// [N s].
    virtual Vec kick(std::span<const Vec> on_unknowns, double dt) = 0;
    /// Forces on the unknowns that act all through the next implicit advance, along with the body's own [N]; a kick at
    /// its start would set off vibrations that its long step does not resolve.
    virtual void press(std::span<const Vec> on_unknowns) = 0;

    /// Residual for implicit viscosity (ViscousNodes) of unknowns with mean velocity w over the next dt: half the
    /// springs' forces and drag, minus the force needed to reach w, F/2 - m / dt (w - v) [N]; 0 where they are held.
    [[nodiscard]] virtual std::vector<Vec> balance(std::span<const Vec> w, double dt) const = 0;
    /// Computes minus the derivative of the balance with respect to w, near this w (Gauss-Newton form), and
    /// factorises its sum with `drag`, the drag of the nodes in the fluid by axis [kg/s].
    virtual void prepare_in_fluid(std::span<const Vec> w, std::span<const Vec> drag, double dt) = 0;
    /// Likewise without a fluid. Takes the factors of the body's own steps if they are for this dt and not `anew`.
    virtual void prepare_alone(std::span<const Vec> w, double dt, bool anew) = 0;
    /// Multiplies the values by this derivative, in place; 0 for fixed nodes.
    virtual void multiply_in_fluid(std::span<Vec> values) const = 0;
    /// Solves with the factors, in place; 0 for fixed nodes.
    virtual void solve_in_fluid(std::span<Vec> values) const = 0;
    /// Adds the lower triangle of the matrix that was factorised, drag included [kg/s]: the row of an unknown is its
    /// number times the dimension plus the axis, and `first`. None where it is held.
    virtual void add_prepared(int first, std::vector<Eigen::Triplet<double>>& entries) const = 0;
    /// Sets the nodes' mean velocities for the next implicit step, from a solution coupled with the fluid: for a
    /// light body, the step has no solution without the fluid's drag.
    virtual void expect(std::span<const Vec> w) = 0;

    [[nodiscard]] virtual Vec position(std::size_t node) const = 0;         ///< current [m]
    [[nodiscard]] virtual Vec position_before(std::size_t node) const = 0;  ///< before the last advance [m]
    [[nodiscard]] virtual Vec rest_position(std::size_t node) const = 0;    ///< initial [m]

    [[nodiscard]] virtual double free_mass() const = 0;    ///< of the free nodes [kg]
    [[nodiscard]] virtual Vec total_momentum() const = 0;  ///< of the free nodes [kg m/s]
    [[nodiscard]] virtual double energy() const = 0;       ///< of all springs at present [J]
    /// Largest stable explicit step of the initial body [s].
    [[nodiscard]] virtual double step_limit() const = 0;

    /// Upper bound of the square of the highest frequency of contact with itself, at the current positions [1/s^2].
    [[nodiscard]] virtual double self_contact_rate() const = 0;

    /// Virial SUM F (x) r of each node, symmetric part: xx, yy, zz, xy, yz, xz [J]. For each spring, F is the force
    /// on the end of an arm and r the arm, summed over its arms and divided equally among its nodes (Thompson,
    /// Plimpton & Mattson 2009). Elastic forces only, no dashpots; no kinetic part.
    [[nodiscard]] virtual std::vector<std::array<double, 6>> virial() const = 0;

    /// Of the particle, at present [m/s].
    [[nodiscard]] virtual Vec velocity(std::size_t node) const = 0;

    /// By particle: the surface in front of it (CarriedSurface), and the gradient of the solid's mean velocity over the
    /// last advance, of dt; 0: of the present velocity. Particles that are farther than `reach` from the surface are
    /// left out: no fluid sees them [m].
    [[nodiscard]] virtual std::vector<PresentSurface> surfaces(double dt, double reach) const = 0;
    /// Whether a node is clamped, or a wall particle to which the body is bonded.
    [[nodiscard]] virtual bool is_clamped() const {
        return std::ranges::any_of(fixed_, [](auto f) { return f != 0; });
    }

    /// Cauchy's stress at the corners of the particle's solid: xx, yy, zz, xy, yz, xz [Pa]; none where it consists of
    /// springs.
    [[nodiscard]] virtual std::vector<std::array<double, 6>> surface_stresses(std::size_t /*node*/) const { return {}; }

    /// Of the particle, over its volume at rest; 1 where it consists of springs.
    [[nodiscard]] virtual double volume_ratio(std::size_t /*node*/) const { return 1; }

    /// Least and largest principal strain of the particle (Green's) [-]; none where it consists of springs.
    [[nodiscard]] virtual std::optional<std::array<double, 2>> strains(std::size_t /*node*/) const { return {}; }

    /// Ids of the two cells between which a face breaks now: of those of this origin that are beyond the law's limit
    /// the one with the highest rank, of equals the one with the lowest ids. None where it consists of springs.
    [[nodiscard]] virtual std::optional<std::array<int, 2>> overloaded_face(const SolidBreak& /*law*/,
                                                                            int /*origin*/) const {
        return {};
    }

    virtual void archive(Archive& file, const std::string& name) = 0;

    [[nodiscard]] const std::string& part() const { return part_; }
    [[nodiscard]] const std::vector<int>& ids() const { return ids_; }  ///< particle ids of the nodes
    /// A bond between nodes of the body, numbered as they are here.
    struct OwnBond : Bond {
        Vec shift;  ///< BodyParts::Spring::shift [m]
    };
    [[nodiscard]] const std::vector<OwnBond>& bonds() const { return bond_list_; }
    /// The origin of a node or bond (body_names).
    [[nodiscard]] int origin(std::size_t node) const { return origin_[node]; }
    [[nodiscard]] int bond_origin(std::size_t bond) const { return bond_origin_[bond]; }
    /// True if the node is a wall particle to which the body is bonded.
    [[nodiscard]] bool of_wall(std::size_t node) const { return of_wall_[node] != 0; }
    [[nodiscard]] std::size_t nodes() const { return ids_.size(); }
    [[nodiscard]] bool fixed(std::size_t node) const { return fixed_[node] != 0; }
    [[nodiscard]] double mass(std::size_t node) const { return mass_[node]; }  ///< [kg]
    /// From the initial position [m].
    [[nodiscard]] Vec displacement(std::size_t node) const { return position(node) - rest_position(node); }
    /// Current length of a bond of this body minus its rest length [m].
    [[nodiscard]] double stretch(const OwnBond& bond) const {
        return (position(bond.a) - position(bond.b) + bond.shift).norm() - bond.rest_length;
    }

  protected:
    explicit SpringBody(std::string part) : part_(std::move(part)) {}
    SpringBody(SpringBody&&) noexcept = default;
    SpringBody& operator=(SpringBody&&) noexcept = default;

    std::string part_;
    std::vector<int> ids_;
    std::vector<OwnBond> bond_list_;
    std::vector<std::uint8_t> fixed_, of_wall_;
    std::vector<double> mass_, drag_;
    std::vector<int> origin_, bond_origin_;
};

}  // namespace dmp::solver
