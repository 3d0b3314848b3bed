// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/models/springs/bond_force.hpp"
#include "solver/models/springs/hinge_force.hpp"
#include "solver/store/particle_store.hpp"

namespace dmp {

/// One connected piece of a springs part: its nodes, bonds and hinges, moved by its own forces alone.
class SpringBody {
  public:
    SpringBody(const ParticleSet& set, const Part& part, int body);
    ~SpringBody();
    SpringBody(SpringBody&&) noexcept;
    SpringBody& operator=(SpringBody&&) noexcept;

    struct Impulses {
        Vector<double, 2> of_anchors{};  ///< given to the free nodes by the anchored ones [N s]
        Vector<double, 2> of_drag{};     ///< by lab-frame drag [N s]
    };

    /// Velocities change by dt F / m, F the forces of the fluid and of contact in the store.
    void kick_from_outside(const ParticleStore& particles, double dt);

    /// Moves the nodes over dt under the body's own forces, in `substeps` equal drift-kick-drift steps.
    Impulses advance_subcycled(double dt, int substeps);

    /// Moves the nodes over dt in one implicit midpoint step: stable for any dt, and free of the resonance between
    /// kicks of the fluid and spring modes that sub-cycling has (Stern & Grinspun 2009: "IMEX").
    /// A step whose equations cannot be solved is halved, and halved again; throws DivergenceError when that is in
    /// vain.
    Impulses advance_implicit(double dt);

    /// What the fluid is to see of the last advance: the nodes' mean velocity, displacement over dt, before they are
    /// moved (fast vibration of the springs is none of the fluid's business) ...
    void show_mean_velocity(ParticleStore& particles, double dt) const;
    /// ... and then where they went.
    void show_position(ParticleStore& particles) const;

    /// Of the free nodes [kg m/s].
    [[nodiscard]] Vector<double, 2> momentum() const;

    /// Largest stable step 2 / omega_max of the drawn lattice [s], omega_max by power iteration on its stiffness.
    [[nodiscard]] double step_limit() const;

    /// Bond and hinge energy now [J].
    [[nodiscard]] double energy() const;

    [[nodiscard]] const std::vector<int>& ids() const { return ids_; }
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
    /// v += h F / m on free nodes; adds up what anchors and drag gave.
    void kick(double h, const Vectors& force, const Vectors& drag_velocity, Impulses& impulses);

    std::vector<int> ids_;  ///< particle ids of the nodes
    std::vector<std::uint8_t> fixed_;
    std::vector<double> mass_;
    std::vector<LocalBond> bonds_;
    std::vector<LocalHinge> hinges_;
    double drag_;
    double spacing_;                       ///< scale of the nodes' distances [m]
    Vectors position_, velocity_, force_;  ///< positions never wrap: bodies may cross periodic borders
    Vectors position_before_;              ///< before the last advance
    std::unique_ptr<ImplicitSystem> system_;
};

/// All spring bodies of a scene.
class SpringBodies {
  public:
    SpringBodies(const ParticleSet& set, const Scene& scene);

    /// Largest stable explicit step by part name [s].
    struct PartLimit {
        std::string part;
        double dt;
    };
    [[nodiscard]] const std::vector<PartLimit>& step_limits() const { return limits_; }
    /// Spring steps that cover dt: one when implicit, 0 without bodies.
    [[nodiscard]] int substeps(double dt) const;
    [[nodiscard]] bool implicit() const { return implicit_; }

    /// Kicks all bodies by the forces in the store, then moves them over dt; the store sees their mean velocities.
    SpringBody::Impulses advance(ParticleStore& particles, double dt, int threads);
    /// Hands the positions after the last advance to the store.
    void show_positions(ParticleStore& particles) const;

    [[nodiscard]] bool empty() const { return bodies_.empty(); }
    [[nodiscard]] const std::vector<SpringBody>& bodies() const { return bodies_; }

  private:
    std::vector<SpringBody> bodies_;
    std::vector<PartLimit> limits_;
    bool implicit_;
    double largest_step_ = 0;  ///< explicit: the shortest limit times the scene's spring_step_factor [s]
};

}  // namespace dmp
