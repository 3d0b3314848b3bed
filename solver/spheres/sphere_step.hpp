// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "solver/forcing/driving.hpp"
#include "solver/parallel/resources.hpp"
#include "solver/spheres/sphere_neighbours.hpp"
#include "solver/time/outside_impulses.hpp"
#include "solver/time/stage_timer.hpp"

namespace dmp::solver {

/// One step of spheres in contact, velocity Verlet: velocities and spins half a step, places a whole one, contact
/// forces there, velocities and spins the second half. Contacts see the velocities of the middle of the step, with
/// which they also carry on friction's displacement (ContactKernel).
class SphereStep {
  public:
    /// `space` has whole periods.
    SphereStep(const Scene& scene, const ParticleSet& set, const ParticleSpace& space, ParticleGroup& group,
               const SphereSetup& setup, const Resources& resources);

    /// Brings lists about; at the start (then forces of the start too, without time passing) and after a checkpoint.
    void start(bool with_forces, double t);
    /// From time t to t + dt.
    void advance(double t, double dt);
    /// The group's fields hold the present state.
    void give_state() { rows_.give(group_); }
    /// All that the next steps depend on besides the group.
    void archive(Archive& file);

    /// Of all ranks [m/s].
    [[nodiscard]] double largest_speed() const { return largest_speed_; }
    /// The same, or that of walls at time t where it is more.
    [[nodiscard]] double speed_for_limits(double t) const {
        return std::max(largest_speed_, walls_.largest_speed_at(t));
    }
    [[nodiscard]] const OutsideImpulses& impulses() const { return impulses_; }
    [[nodiscard]] const StageTimer& timer() const { return timer_; }
    [[nodiscard]] const SphereNeighbours& neighbours() const { return neighbours_; }
    [[nodiscard]] const SphereWalls& walls() const { return walls_; }
    [[nodiscard]] const Driving& driving() const { return driving_; }
    /// Spheres in free flight have been brought to where they are.
    [[nodiscard]] const SphereRows& rows() const {
        rows_.land();
        return rows_;
    }
    [[nodiscard]] const ParticleGroup& group() const { return group_; }
    [[nodiscard]] const SphereSetup& setup() const { return setup_; }
    [[nodiscard]] const std::vector<bool>& fixed() const { return fixed_; }
    [[nodiscard]] int threads() const { return threads_; }
    [[nodiscard]] std::size_t bytes() const { return rows_.bytes() + neighbours_.bytes(); }

  private:
    using Three = std::array<double, 3>;
    [[nodiscard]] Three acceleration_at(double t) const;
    /// Largest squares: of speeds [m^2/s^2], and of speeds in the frame of the lists, in skins [1/s^2].
    struct Fastest {
        double speed = 0, wide = 0, narrow = 0;
        void update_max(const Fastest& other) {
            speed = std::max(speed, other.speed);
            wide = std::max(wide, other.wide);
            narrow = std::max(narrow, other.narrow);
        }
        /// Skins as 1 / skin^2 [1/m^2].
        void update_max(const SphereMotion& sphere, const Three& frame, float of_wide, float of_narrow);
    };
    void choose_who_flies();
    void kick(double t, double half);
    void kick_by_position(double t, double half);
    void drive(double t, double half);
    void kick_and_drift(double t, double dt);
    void find_forces(double dt);
    void sweep_contacts(const ContactTime& time);
    double sweep_contacts_of(int thread, const ContactTime& time, const ReproducibleSum& force_rounding,
                             const ReproducibleSum& torque_rounding);
    [[nodiscard]] double expected_force(double dt) const;
    void add_impulses(double t, double half);

    const ParticleSpace& space_;
    ParticleGroup& group_;
    const SphereSetup& setup_;
    PositionQuantum quantum_;
    Ranks ranks_;
    int threads_;
    std::vector<bool> fixed_;  ///< by id
    bool any_fixed_ = false;
    std::array<Expression, 3> acceleration_;
    bool depends_on_position_;
    bool may_fly_;  ///< nothing accelerates all
    Driving driving_;
    std::vector<std::uint8_t> driven_;  ///< by part: whether something drives it
    double free_mass_ = 0;              ///< of all ranks [kg]
    std::vector<ContactSweep> sweeps_;  ///< by kind
    mutable SphereRows rows_;           ///< landing changes nothing that can be seen from outside
    SphereWalls walls_;
    SphereNeighbours neighbours_;
    std::vector<std::vector<DeferredLoad>> deferred_;  ///< by thread
    std::vector<std::size_t> deferred_count_;
    std::vector<std::uint8_t> acted_on_;            ///< by row
    Fastest flying_;                                ///< of spheres in free flight
    double largest_speed_ = 0, largest_force_ = 0;  ///< of the last step, of all ranks [m/s], [N]
    double moved_to_walls_ = 0, wall_skin_ = 0;     ///< since walls were listed; then they are listed anew [m]
    Three wall_force_{};                            ///< of walls and fixed spheres on all ranks' free ones [N]
    OutsideImpulses impulses_;
    StageTimer timer_;
};

}  // namespace dmp::solver
