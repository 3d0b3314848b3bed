// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>

#include "solver/implicit/conjugate_gradients.hpp"
#include "solver/implicit/viscous_nodes.hpp"
#include "solver/neighbours/cluster_list.hpp"
#include "solver/sweeps/pair_sweeps.hpp"

namespace dmp::solver {

/// The equations of one step's implicit viscosity (ImplicitViscosity), as conjugate_gradients wants them. Vectors are
/// fields of the store. All sums are exact or order-free: results are the same bits on any number of threads and ranks.
class ViscousSystem {
  public:
    struct Around {
        ParticleStore& particles;
        const ClusterList& list;
        SpringBodies& springs;
        SurfaceContact* contact;  ///< null where nothing may touch
        const PairSweeps& sweeps;
        const Ranks& ranks;
        const std::function<void(const FieldList&, const std::function<void(ClusterChoice)>&)>& sweep;
        int threads;
    };

    /// From the present velocities, forces and body acceleration `g`.
    ViscousSystem(const Around& around, double dt, const std::array<double, 3>& g);

    /// Largest eigenvalue of the preconditioned matrix over its smallest, by Gershgorin's circles, at most.
    [[nodiscard]] double condition() const { return condition_; }
    /// Works out the residual of the present velocities. Returns its error, sqrt(SUM m (dt r / m)^2) [kg^1/2 m/s].
    double true_error();
    /// What errors are compared with: sqrt(SUM m v^2) before or after viscosity acts, or with the walls' largest speed,
    /// whichever is largest.
    [[nodiscard]] double velocity_scale() const { return velocity_scale_; }

    Residual start();
    double curvature();
    Residual step(double alpha);
    void turn(double beta);

    /// `force` += the viscous forces that true_error last found.
    void add_forces();

  private:
    [[nodiscard]] Residual residual_sums() const;
    void sweep_forces(Field velocity, double of_walls, double fastest);
    [[nodiscard]] double largest(const ParticleGroup& group, Field field) const;

    Around on_;
    ParticleGroup& fluid_;
    ViscousNodes nodes_;
    double dt_;
    std::array<double, 3> g_;
    double condition_ = 1;
    double largest_diagonal_ = 0;   ///< [kg/s]
    double fastest_wall_ = 0;       ///< [m/s]
    double fastest_direction_ = 0;  ///< largest component of viscous_direction [m/s]
    double mass_ = 0;               ///< of the fluid of all ranks [kg]
    double velocity_scale_ = 0;
};

}  // namespace dmp::solver
