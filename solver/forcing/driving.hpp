// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "models/forcing/part_force.hpp"
#include "models/forcing/schedule_window.hpp"
#include "models/forcing/soft_shape.hpp"
#include "scene/scene.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/parallel/exact_sum.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/state/archive.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// What the scene pushes with from outside besides a body acceleration: forces on parts and shapes that parts feel. It
/// depends on time and place alone, forces on elastic parts also on where a particle was in the initial state; along
/// periodic axes places are those in the box, and of a shape the image that is nearest counts.
class Driving {
  public:
    /// @param set   for the parts' masses and numbers of particles
    /// @param space whose box the particles are kept in: periods of whole position quanta
    Driving(const Scene& scene, const ParticleSet& set, const ParticleSpace& space);

    [[nodiscard]] bool empty() const { return forces_.empty() && shapes_.empty(); }

    /// All of it on one particle of the part at the place x [m] at time t [N], but for what asks for initial places.
    [[nodiscard]] Vec force(int part, const Vec& x, double t) const;
    [[nodiscard]] bool pushes(int part) const;
    /// Of the shapes [J].
    [[nodiscard]] double energy(int part, const Vec& x, double t) const;

    /// Adds it to the owned particles' Field::force, of fluid and elastic solids, and takes note of the largest
    /// acceleration. `springs` knows where solids' particles were. Returns its sum over all ranks' particles [N].
    std::array<double, 3> add_forces(ParticleStore& particles, const SpringBodies& springs, const Ranks& ranks,
                                     double t, int threads);

    /// For particles that are kept elsewhere: their forces by `force`, and the largest acceleration among them [m/s^2].
    void update_max(double largest_acceleration) { largest_acceleration_ = largest_acceleration; }

    /// Longest step at time t, by the accelerations of then and of the last forces added, and by the shapes' softness,
    /// of particles that see over `length` [m]; infinite where nothing limits it [s].
    [[nodiscard]] double step_limit(double length, double t) const;
    /// The next time after t at which a force starts or ends [s].
    [[nodiscard]] double next_change(double t) const;

    void archive(Archive& file);

  private:
    struct OnPart {
        int part = 0;
        std::array<Expression, 3> force;  ///< [N]
        PartForce law;
        ScheduleWindow window;
        bool by_mass = false;  ///< each particle has its share of a total force (mass_over_mean_)
        bool depends_on_position = false, depends_on_initial_position = false;
        [[nodiscard]] bool is_uniform() const {
            return !by_mass && !depends_on_position && !depends_on_initial_position;
        }
        [[nodiscard]] Vec at(double t, const Vec& x, const Vec& at_start) const;
    };
    struct Shape {
        std::vector<std::uint8_t> felt_by;   ///< by part
        std::array<Expression, 3> position;  ///< of the vertex or centre [m]
        std::variant<ParabolaArc, Circle> curve;
        SoftRepulsion law;
        double lightest = 0;  ///< of the particles that feel it [kg]
        ScheduleWindow window;
    };

    /// Whether a part's particles differ in mass; their masses over the mean are then known.
    bool share_by_mass(const ParticleSet& set, int part);
    [[nodiscard]] FromShape from(const Shape& shape, const Vec& x, double t) const;
    /// The part of the force that is the same for any particle; what depends on it or its present place; what asks for
    /// the initial one.
    [[nodiscard]] Vec uniform(int part, double t) const;
    /// `share`: mass of the particle over the mean of its part.
    [[nodiscard]] Vec by_position(int part, const Vec& x, double t, double share = 1) const;
    [[nodiscard]] Vec by_initial_position(int part, const Vec& x, const Vec& at_start, double t, double share) const;
    [[nodiscard]] bool is_uniform(int part) const;
    [[nodiscard]] Vec in_box(const Vec& x) const;
    void add_uniform(ParticleGroup& group, int part, const Vec& force, int threads) const;
    void add_by_position(ParticleGroup& group, const SpringBodies& springs, double t, std::array<ExactSum, 3>& sum);

    ParticleSpace space_;
    std::vector<OnPart> forces_;
    std::vector<Shape> shapes_;
    std::vector<double> lightest_;     ///< particle of each part that has any [kg]
    std::vector<std::size_t> counts_;  ///< particles of each part, of all ranks
    /// By id, a particle's mass over the mean of its part; 1 where all are alike. Empty: no force asks for it.
    std::vector<double> mass_over_mean_;
    /// When forces were last added, of those that depend on place; all of them for particles kept elsewhere [m/s^2].
    double largest_acceleration_ = 0;
};

}  // namespace dmp::solver
