// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/parallel/exact_sum.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/sweeps/reproducible_sum.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Two drives of all that moves. The body acceleration g of flow.acceleration acts on mass: formulas of t, and of x, y,
/// z where they depend on position. The mean pressure gradient of flow.pressure_gradient acts on the volume V of liquid
/// and of elastic solids in it, with the force -V grad p: formulas of t, along periodic axes.
class BodyForce {
  public:
    using Momentum = std::array<double, 3>;  ///< of all ranks [N]

    BodyForce(const Scene& scene, const ParticleSet& set, const ParticleStore& particles);

    /// g at time t along the axes on which it is uniform, 0 along the others [m/s^2].
    [[nodiscard]] std::array<double, 3> uniform(double t) const;
    /// The same without periodic axes, along which no pressure can build up.
    [[nodiscard]] std::array<double, 3> hydrostatic(double t) const;
    [[nodiscard]] bool depends_on_position() const { return depends_on_position_; }

    [[nodiscard]] bool has_gradient() const { return has_gradient_; }
    /// -grad p of flow.pressure_gradient at time t [N/m^3].
    [[nodiscard]] std::array<double, 3> force_density(double t) const;

    /// What continues the pressure in walls: g where it is uniform, and -grad p over the liquids' mean density [m/s^2].
    [[nodiscard]] std::array<double, 3> in_walls(double t) const;
    /// Acceleration of the lightest liquid by both, at most; without axes on which g depends on position [m/s^2].
    [[nodiscard]] double largest(double t) const;

    /// Adds dt g to the velocities of the fluid, along the axes on which g depends on position. Returns the force on
    /// all fluid along them. All ranks take part.
    Momentum kick_fluid(ParticleStore& particles, const Ranks& ranks, double t, double dt) const;

    /// Adds m g to the forces on the nodes of elastic bodies, m being their own mass; held nodes hand it to what holds
    /// them. Returns the force along the axes on which g depends on position. All ranks take part.
    Momentum add_weights(ParticleStore& particles, const SpringBodies& springs, const Ranks& ranks, double t) const;

    /// Adds V times a force density [N/m^3], such as -grad p, to the forces on liquid and elastic solids, V being the
    /// present volume of each particle. Not to solids that border on nothing: on these a pressure acts where they are
    /// wet alone. Returns the sum of V on this rank [m^3].
    [[nodiscard]] ExactSum add_pressure_forces(ParticleStore& particles, const std::array<double, 3>& force_density,
                                               int threads) const;

  private:
    /// A coordinate as formulas have it: inside the periodic box, and on this side of a plane of symmetry.
    [[nodiscard]] double in_box(double x, int axis) const;
    /// The component of g for particle i, which depends on position; beyond a plane of symmetry, of its mirror image.
    [[nodiscard]] double at_particle(const ParticleGroup& group, std::size_t i, int axis, double t) const;

    std::array<Expression, 3> acceleration_, pressure_gradient_;
    bool depends_on_position_, has_gradient_;
    double mean_density_, least_density_;  ///< of the liquids [kg/m^3]
    ReproducibleSum rounded_;              ///< of volumes, so that their sum is exact
    const ParticleSpace& space_;
};

}  // namespace dmp::solver
