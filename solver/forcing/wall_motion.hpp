// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "scene/scene.hpp"
#include "solver/state/archive.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// How far a rigid part has come from where it was drawn.
struct WallPose {
    Vec displacement = Vec::Zero();  ///< [m]
    double angle = 0;                ///< about the part's centre [rad]
};

/// Rigid parts with a prescribed motion, and those whose surface slides in itself (a lid, a belt; their particles
/// stay).
///
/// A particle drawn at X stands at c + d + R(theta) (X - c), in whole position quanta: d and theta are integrals of
/// the part's velocity and spin (three-point Gauss rule in each half step), c its centre. So its place depends on
/// nothing but the part's pose, which is part of a checkpoint, and walls keep their shape for any number of steps.
///
/// `velocity` of the walls' particles is that of the nearest point of the surface, for viscosity and the velocity
/// gradient. In the density rate it is how the particles move (`wall_motion`; with the plain scheme `velocity` is that
/// then), so that the end of a lid is no source of liquid. `surface_gradient` is the gradient of the surface's
/// velocity, by which it differs in front of fluid beside a particle. The surface's mean acceleration over a step goes
/// into the pressure behind it. Momentum that the fluid is given is the reaction of the walls' forces, as it is at
/// walls at rest.
///
/// Scenes in 3-D turn about an axis along z.
class WallMotion {
  public:
    /// Declares the fields it needs, none where all walls rest.
    WallMotion(const Scene& scene, const ParticleSet& set, ParticleStore& particles);

    /// Whether any part moves.
    [[nodiscard]] bool moves() const { return !moving_.empty(); }
    [[nodiscard]] bool moves(std::uint16_t part) const;

    /// From t to t + dt: works out where the parts will be.
    void start_step(double t, double dt);
    /// Moves particles and their normals. Return how far one moved at most [m].
    [[nodiscard]] double move_to_middle(ParticleStore& particles);
    [[nodiscard]] double move_to_end(ParticleStore& particles);
    /// The surfaces' velocities at the start of the step and the accelerations, of owned particles. Returns the fields
    /// that copies have yet to be given.
    [[nodiscard]] FieldList show_surfaces(ParticleStore& particles) const;
    /// The velocities of the particles themselves at the end of the step, and with the corrected scheme those of the
    /// surfaces. Returns the fields, beside velocity, that copies have yet to be given.
    [[nodiscard]] FieldList show_velocities(ParticleStore& particles) const;

    /// Where a point of a part is that was drawn at `drawn` [m], as its particles stand.
    [[nodiscard]] Vec carried(std::uint16_t part, const Vec& drawn) const;
    /// Of that point at time t, without what slides [m/s].
    [[nodiscard]] Vec velocity(std::uint16_t part, const Vec& drawn, double t) const;

    /// Of all walls and their surfaces at time t [m/s]; surfaces that slide by formulas of place are left out.
    [[nodiscard]] double largest_speed(double t) const;
    /// How far from its place in the geometry a particle stands at most [m].
    [[nodiscard]] double farthest() const;

    void archive(Archive& file);

  private:
    struct Moving {
        std::uint16_t part = 0;
        std::array<Expression, 3> velocity;
        Expression spin;
        Vec centre;
        double radius = 0;  ///< largest distance of a particle from the centre [m]
        bool turns = false;
        WallPose start, middle, end;  ///< of the step
        WallPose shown;               ///< in which the particles stand

        [[nodiscard]] WallPose after(const WallPose& pose, double t, double dt) const;
        [[nodiscard]] Vec velocity_at(double t) const;
    };
    struct Sliding {
        std::uint16_t part = 0;
        std::array<Expression, 3> velocity;
    };

    [[nodiscard]] double move(ParticleStore& particles, WallPose Moving::*pose);
    void show_surface_velocities(ParticleGroup& walls, WallPose Moving::*pose, double t) const;
    enum class Of { particles, surface };
    void add_motion(Of what, const Moving& part, ParticleGroup& walls, const WallPose& pose, double t, Field to,
                    double factor) const;
    static void add_spin(const Moving& part, ParticleGroup& walls, double spin);
    void add_gradient(const Sliding& part, ParticleGroup& walls, std::size_t i, const Vec& x, double t) const;

    std::vector<Moving> moving_;
    std::vector<Sliding> sliding_;
    double spacing_;
    double t_ = 0, dt_ = 0;  ///< of the step
};

}  // namespace dmp::solver
