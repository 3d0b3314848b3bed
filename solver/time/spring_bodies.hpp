// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/models/springs/bond_force.hpp"
#include "solver/models/springs/hinge_force.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/state/archive.hpp"
#include "solver/store/particle_store.hpp"

namespace dmp {

/// One connected piece of a springs part: its nodes, bonds and hinges, moved by its own forces alone.
class SpringBody {
  public:
    SpringBody(const ParticleSet& set, const Part& part, int body);
    ~SpringBody();
    SpringBody(SpringBody&& other) noexcept;
    SpringBody& operator=(SpringBody&& other) noexcept;
    SpringBody(const SpringBody&) = delete;
    SpringBody& operator=(const SpringBody&) = delete;

    struct Impulses {
        Vector<double, 2> of_anchors{};  ///< given to the free nodes by the anchored ones [N s]
        Vector<double, 2> of_drag{};     ///< by lab-frame drag [N s]
    };

    /// Velocities change by dt F / m, F the forces of the fluid and of contact on the nodes. Returns the impulse that
    /// the fixed nodes' holders give [N s].
    Vector<double, 2> kick_from_outside(std::span<const Vector<double, 2>> force, double dt);

    /// Moves the nodes over dt under the body's own forces, in `substeps` equal drift-kick-drift steps.
    Impulses advance_subcycled(double dt, int substeps);

    /// Moves the nodes over dt in one implicit midpoint step: stable for any dt, and free of the resonance between
    /// kicks of the fluid and spring modes that sub-cycling has (Stern & Grinspun 2009: "IMEX").
    /// A step whose equations cannot be solved is halved, and halved again; throws DivergenceError when that is in
    /// vain.
    Impulses advance_implicit(double dt);

    /// What the fluid is to see of the last advance: a node's mean velocity, displacement over dt (fast vibration of
    /// the springs is none of the fluid's business) ...
    [[nodiscard]] Vector<double, 2> mean_velocity(std::size_t node, double dt) const {
        return (1 / dt) * (position_[node] - position_before_[node]);
    }
    /// ... and where it was.
    [[nodiscard]] const std::vector<Vector<double, 2>>& positions_before() const { return position_before_; }
    /// Where nodes were drawn.
    [[nodiscard]] const std::vector<Vector<double, 2>>& positions_at_rest() const { return position_at_rest_; }

    /// Of the free nodes [kg m/s].
    [[nodiscard]] Vector<double, 2> momentum() const;

    /// Largest stable step 2 / omega_max of the drawn lattice [s], omega_max by power iteration on its stiffness.
    [[nodiscard]] double step_limit() const;

    void archive(Archive& file, const std::string& name);

    /// In implicit viscosity (ViscousNodes), of nodes that would move with mean velocity w over the next dt: half the
    /// springs' forces and drag, less what changing to w takes, F/2 - m / dt (w - v) [N].
    [[nodiscard]] std::vector<Vector<double, 2>> balance(std::span<const Vector<double, 2>> w, double dt) const;
    /// The negative derivative of the balance with respect to w, near this w (Gauss-Newton form), and the factors of
    /// its sum with the nodes' `drag` by axis in the liquid [kg/s].
    void prepare_in_fluid(std::span<const Vector<double, 2>> w, std::span<const Vector<double, 2>> drag, double dt);
    /// The derivative times the values, in place; 0 for fixed nodes.
    void multiply_in_fluid(std::span<Vector<double, 2>> values) const;
    /// Solves with the factors, in place; 0 for fixed nodes.
    void solve_in_fluid(std::span<Vector<double, 2>> values) const;
    /// The next implicit step moves the nodes with these mean velocities, which it was solved for together with the
    /// liquid: without its drag a light body's step has no solution to be found.
    void expect(std::span<const Vector<double, 2>> w) { expected_.assign(w.begin(), w.end()); }
    [[nodiscard]] bool fixed(std::size_t node) const { return fixed_[node] != 0; }
    [[nodiscard]] double mass(std::size_t node) const { return mass_[node]; }  ///< [kg]

    /// Bond and hinge energy now [J].
    [[nodiscard]] double energy() const;

    [[nodiscard]] const std::string& part() const { return part_; }
    [[nodiscard]] const std::vector<int>& ids() const { return ids_; }
    [[nodiscard]] const std::vector<Bond>& bonds() const { return drawn_bonds_; }
    [[nodiscard]] double free_mass() const;  ///< of the free nodes [kg]
    [[nodiscard]] const std::vector<Vector<double, 2>>& positions() const { return position_; }
    /// For tests and static solves: nodes may be put anywhere.
    std::vector<Vector<double, 2>>& positions() { return position_; }
    /// Spring forces (dashpots included) of nodes at these places and velocities [N].
    [[nodiscard]] std::vector<Vector<double, 2>> forces(const std::vector<Vector<double, 2>>& position,
                                                        const std::vector<Vector<double, 2>>& velocity) const;

  private:
    using Vectors = std::vector<Vector<double, 2>>;
    struct LocalBond {
        int a, b;
        BondForce<2> force;
    };
    struct LocalHinge {
        int a, centre, b;
        HingeForce force;
    };
    class ImplicitSystem;

    void add_forces(const Vectors& position, const Vectors& velocity, Vectors& force) const;
    void drift(double h);
    void advance_in_parts(double dt, int halvings_left, Impulses& impulses);
    /// One implicit midpoint step; false, and nothing changed, when Newton finds no solution.
    bool solve_step(double dt, Impulses& impulses);
    Impulses advance_as_expected(double dt);
    /// v += h F / m on free nodes; adds up what anchors and drag gave.
    void kick(double h, const Vectors& force, const Vectors& drag_velocity, Impulses& impulses);

    std::string part_;
    std::vector<int> ids_;           ///< particle ids of the nodes
    std::vector<Bond> drawn_bonds_;  ///< as in the particle set, by node of this body
    std::vector<std::uint8_t> fixed_;
    std::vector<double> mass_;
    std::vector<LocalBond> bonds_;
    std::vector<LocalHinge> hinges_;
    double drag_;
    double spacing_;                       ///< scale of the nodes' distances [m]
    Vectors position_, velocity_, force_;  ///< positions never wrap: bodies may cross periodic borders
    Vectors position_before_;              ///< before the last advance
    Vectors position_at_rest_;             ///< as drawn
    Vectors expected_;                     ///< mean velocities of the next step, where they are known
    std::unique_ptr<ImplicitSystem> system_, in_fluid_;
    double in_fluid_step_ = 0;  ///< that the latter was made for [s]
};

/// All spring bodies of a scene.
class SpringBodies {
  public:
    /// Every rank holds all bodies and moves them alike: they are few, and no rank then waits for another.
    SpringBodies(const ParticleSet& set, const Scene& scene, const Ranks& ranks);

    /// Largest stable explicit step by part name [s].
    struct PartLimit {
        std::string part;
        double dt;
    };
    [[nodiscard]] const std::vector<PartLimit>& step_limits() const { return limits_; }
    /// Spring steps that cover dt: one when implicit, 0 without bodies.
    [[nodiscard]] int substeps(double dt) const;
    [[nodiscard]] bool implicit() const { return implicit_; }

    /// Finds which particles of the store are which nodes. Needed when the store was sorted.
    void find_nodes(const ParticleStore& particles);
    /// Kicks all bodies by the forces in the store, then moves them over dt; the store sees their mean velocities.
    SpringBody::Impulses advance(ParticleStore& particles, double dt, int threads);
    /// Hands the positions after the last advance to the store. Returns the longest way a node went [m].
    double show_positions(ParticleStore& particles) const;

    void archive(Archive& file);

    [[nodiscard]] bool empty() const { return bodies_.empty(); }
    [[nodiscard]] const std::vector<SpringBody>& bodies() const { return bodies_; }
    [[nodiscard]] std::vector<SpringBody>& bodies() { return bodies_; }

    /// A vector field of all nodes of all bodies, one body after another, as the ranks that own them have it.
    [[nodiscard]] std::vector<Vector<double, 2>> collected(const ParticleStore& particles, Field field) const;
    /// Hands such values to the store, to copies too.
    void show_in(ParticleStore& particles, Field field, const std::vector<Vector<double, 2>>& values) const;

  private:
    using Vectors = std::vector<Vector<double, 2>>;
    template <class ValueOf>
    void show(ParticleStore& particles, Field field, const ValueOf& value_of) const;

    struct Node {
        int body, index;  ///< index in its body
    };
    const Ranks& ranks_;
    std::vector<SpringBody> bodies_;
    std::vector<std::size_t> first_node_;  ///< of each body in the numbering of all nodes; and how many
    std::unordered_map<std::int64_t, Node> by_id_;
    std::vector<Node> nodes_;  ///< by index in the store's group, copies too
    std::vector<PartLimit> limits_;
    bool implicit_;
    double largest_step_ = 0;  ///< explicit: the shortest limit times the scene's spring_step_factor [s]
};

}  // namespace dmp
