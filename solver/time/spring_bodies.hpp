// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
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

    struct Impulses {
        Vector<double, 2> of_anchors{};  ///< given to the free nodes by the anchored ones [N s]
        Vector<double, 2> of_drag{};     ///< by lab-frame drag [N s]
    };

    /// Moves the nodes over dt in `substeps` equal drift-kick-drift steps, from the velocities in the store.
    Impulses advance(ParticleStore& particles, double dt, int substeps);

    /// Largest stable step 2 / omega_max of the drawn lattice [s], omega_max by power iteration on its stiffness.
    [[nodiscard]] double step_limit() const;

    /// Bond and hinge energy now [J].
    [[nodiscard]] double energy() const;

    /// Spring forces (dashpots included) at the present positions and velocities [N], by node.
    [[nodiscard]] const std::vector<Vector<double, 2>>& spring_forces();

    [[nodiscard]] const std::vector<int>& ids() const { return ids_; }
    [[nodiscard]] const std::vector<Vector<double, 2>>& positions() const { return position_; }
    std::vector<Vector<double, 2>>& positions() { return position_; }

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

    void add_forces(const Vectors& position, const Vectors& velocity, Vectors& force) const;
    void drift(double h);

    std::vector<int> ids_;  ///< particle ids of the nodes
    std::vector<std::uint8_t> fixed_;
    std::vector<double> mass_;
    std::vector<LocalBond> bonds_;
    std::vector<LocalHinge> hinges_;
    double drag_;
    Vectors position_, velocity_, force_;  ///< positions never wrap: bodies may cross periodic borders
};

/// All spring bodies of a scene, sub-cycled under the fluid step.
class SpringBodies {
  public:
    SpringBodies(const ParticleSet& set, const Scene& scene);

    /// Largest stable spring step by part name [s].
    struct PartLimit {
        std::string part;
        double dt;
    };
    [[nodiscard]] const std::vector<PartLimit>& step_limits() const { return limits_; }
    /// Spring steps that cover dt; 0 without bodies.
    [[nodiscard]] int substeps(double dt) const;

    SpringBody::Impulses advance(ParticleStore& particles, double dt, int threads);

    [[nodiscard]] bool empty() const { return bodies_.empty(); }
    [[nodiscard]] const std::vector<SpringBody>& bodies() const { return bodies_; }

  private:
    std::vector<SpringBody> bodies_;
    std::vector<PartLimit> limits_;
    double largest_step_ = 0;  ///< the shortest limit times the scene's spring_step_factor [s]
};

}  // namespace dmp
