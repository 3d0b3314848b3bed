// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/elastic/body_parts.hpp"
#include "solver/elastic/self_contact.hpp"
#include "solver/state/archive.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// What the surroundings of spring bodies gave them [N s].
struct SpringImpulses {
    std::array<double, 3> of_anchors{};  ///< by holders of the fixed nodes
    std::array<double, 3> of_drag{};     ///< by lab-frame drag
};

/// One connected piece of an elastic solid as the rest of the solver sees it, in 2-D (z = 0) or in 3-D.
class SpringBody {
  public:
    SpringBody(const SpringBody&) = delete;
    SpringBody& operator=(const SpringBody&) = delete;
    virtual ~SpringBody() = default;

    /// The body of this number, with the springs that are among its nodes. Throws InputError for one in 2-D that
    /// has dihedrals.
    static std::unique_ptr<SpringBody> make(const ParticleSet& set, const Part& part, int body,
                                            const SpringContact& contact = {});
    /// The body that is made of these parts, under a name.
    static std::unique_ptr<SpringBody> make(const BodyParts& parts, const std::string& name, const ParticleSpace& space,
                                            const SpringContact& contact);

    /// What it is made of, as it is now.
    [[nodiscard]] virtual BodyParts parts() const = 0;

    /// Kicks the nodes by forces from outside [N] and by contact of the body with itself; then moves them over dt under
    /// the springs' forces: in so many equal explicit steps, or in one implicit one (0).
    virtual SpringImpulses advance(std::span<const Vec> force, double dt, int substeps) = 0;

    /// In implicit viscosity (ViscousNodes), of nodes that would move with mean velocity w over the next dt: half the
    /// springs' forces and drag, less what changing to w takes, F/2 - m / dt (w - v) [N].
    [[nodiscard]] virtual std::vector<Vec> balance(std::span<const Vec> w, double dt) const = 0;
    /// The negative derivative of the balance with respect to w, near this w (Gauss-Newton form), and the factors of
    /// its sum with the nodes' `drag` by axis in the liquid [kg/s].
    virtual void prepare_in_fluid(std::span<const Vec> w, std::span<const Vec> drag, double dt) = 0;
    /// The derivative times the values, in place; 0 for fixed nodes.
    virtual void multiply_in_fluid(std::span<Vec> values) const = 0;
    /// Solves with the factors, in place; 0 for fixed nodes.
    virtual void solve_in_fluid(std::span<Vec> values) const = 0;
    /// The next implicit step moves the nodes with these mean velocities, which it was solved for together with the
    /// liquid: without its drag a light body's step has no solution to be found.
    virtual void expect(std::span<const Vec> w) = 0;

    [[nodiscard]] virtual Vec position(std::size_t node) const = 0;         ///< now [m]
    [[nodiscard]] virtual Vec position_before(std::size_t node) const = 0;  ///< before the last advance [m]
    [[nodiscard]] virtual Vec rest_position(std::size_t node) const = 0;    ///< where it was drawn [m]

    [[nodiscard]] virtual double free_mass() const = 0;    ///< of the free nodes [kg]
    [[nodiscard]] virtual Vec total_momentum() const = 0;  ///< of the free nodes [kg m/s]
    [[nodiscard]] virtual double energy() const = 0;       ///< of all springs now [J]
    /// Largest stable explicit step of the drawn body [s].
    [[nodiscard]] virtual double step_limit() const = 0;

    /// Of contact with itself, as nodes are now: bound of the square of its highest frequency [1/s^2].
    [[nodiscard]] virtual double self_contact_rate() const = 0;

    /// Virial SUM F (x) r of each node, symmetric part: xx, yy, zz, xy, yz, xz [J]. Of each spring, F is the force on
    /// the end of an arm and r the arm, summed over its arms; its nodes share it equally (Thompson, Plimpton & Mattson
    /// 2009). Elastic forces alone, no dashpots; no kinetic part.
    [[nodiscard]] virtual std::vector<std::array<double, 6>> virial() const = 0;

    virtual void archive(Archive& file, const std::string& name) = 0;

    [[nodiscard]] const std::string& part() const { return part_; }
    [[nodiscard]] const std::vector<int>& ids() const { return ids_; }           ///< particle ids of the nodes
    [[nodiscard]] const std::vector<Bond>& bonds() const { return bond_list_; }  ///< by node of this body
    /// What a node, and what a bond came from (body_names).
    [[nodiscard]] int origin(std::size_t node) const { return origin_[node]; }
    [[nodiscard]] int bond_origin(std::size_t bond) const { return bond_origin_[bond]; }
    /// Whether the node is a wall's particle that the body is bonded to.
    [[nodiscard]] bool of_wall(std::size_t node) const { return of_wall_[node] != 0; }
    [[nodiscard]] std::size_t nodes() const { return ids_.size(); }
    [[nodiscard]] bool fixed(std::size_t node) const { return fixed_[node] != 0; }
    [[nodiscard]] double mass(std::size_t node) const { return mass_[node]; }  ///< [kg]
    /// From where it was drawn [m].
    [[nodiscard]] Vec displacement(std::size_t node) const { return position(node) - rest_position(node); }
    /// How much longer a bond of this body is now than at rest [m].
    [[nodiscard]] double stretch(const Bond& bond) const {
        return (position(bond.a) - position(bond.b)).norm() - bond.rest_length;
    }

  protected:
    explicit SpringBody(std::string part) : part_(std::move(part)) {}
    SpringBody(SpringBody&&) noexcept = default;
    SpringBody& operator=(SpringBody&&) noexcept = default;

    std::string part_;
    std::vector<int> ids_;
    std::vector<Bond> bond_list_;
    std::vector<std::uint8_t> fixed_, of_wall_;
    std::vector<double> mass_, drag_;
    std::vector<int> origin_, bond_origin_;
};

}  // namespace dmp::solver
