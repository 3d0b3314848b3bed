// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "models/contact/contact_stiffness.hpp"
#include "scene/scene.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/forcing/body_force.hpp"
#include "solver/forcing/driving.hpp"
#include "solver/forcing/wall_motion.hpp"
#include "solver/implicit/implicit_viscosity.hpp"
#include "solver/neighbours/neighbours.hpp"
#include "solver/species/species_transport.hpp"
#include "solver/sweeps/fluid_passes.hpp"
#include "solver/sweeps/pair_sweeps.hpp"
#include "solver/time/fluid_reference.hpp"
#include "solver/time/outside_impulses.hpp"
#include "solver/time/stage_timer.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

class SurfaceContact;
struct ContactImpulses;

/// The state of the fluid after a step, as the step-size controller and the watch want it.
struct FluidExtremes {
    double largest_speed = 0;                  ///< [m/s]; not finite when any velocity is not
    double density_low = 0, density_high = 0;  ///< relative to each particle's rest density [-]
};

/// One step of weakly compressible flow with spring bodies, drift-kick-drift:
///   positions and densities half a step; forces there; velocities a whole step; positions the second half; gradients
///   and density rates at the end of the step with the new velocities; shifting, which takes velocity and density
///   along by their gradients; densities the second half (the corrected scheme; the plain one takes the rates at the
///   middle of the step). The sound waves' two halves of the step are then a staggered (symplectic) pair; viscosity is
///   explicit, or solved for just before the kick (ImplicitViscosity).
/// Spring bodies live at the middles of the steps: kicked by the fluid there, they move under their own forces to the
/// next middle before the density rates are taken, so that the fluid feels exactly the displacement they will make.
/// After `advance` they stand half a step ahead of the fluid. Where nothing moves (is_at_rest), only species are
/// stepped.
class FluidStep {
  public:
    FluidStep(const Scene& scene, const ParticleSet& set, ParticleStore& particles, const PairSettings& settings,
              std::vector<LiquidState> state_of_part, const Ranks& ranks);

    ~FluidStep();
    FluidStep(const FluidStep&) = delete;
    FluidStep& operator=(const FluidStep&) = delete;

    /// From time t to t + dt. The fluid's extremes after it, which cost nothing on the way.
    FluidExtremes advance(double t, double dt);
    /// Of the corrected scheme, before the first step: the gradients of the initial state and the level of its
    /// pressure. Neighbours must be up to date.
    void take_initial_gradients(double t);

    /// Of the corrected scheme: looks for closed chambers of the fluid, each of which then keeps its volume. At times
    /// that follow from the number of the step alone. Neighbours must have been up to date in the last step.
    void find_chambers();

    /// Surfaces touch from now on, with a stiffness for this step, the longest that all else allows [s].
    void start_surface_contact(const Scene& scene, const ParticleSet& set, double longest_step);
    /// Null where particles repel each other.
    [[nodiscard]] const SurfaceContact* surface_contact() const { return surface_contact_.get(); }

    /// Steps since the start or the resumption whose contact was not solved to the tolerance.
    [[nodiscard]] int unsolved_contacts() const { return unsolved_contacts_; }

    /// Takes note of how fast the fluid is; for one that starts in motion.
    void take_speed() { largest_speed_ = extremes().largest_speed; }
    /// Takes note of how stiff the contacts of spring bodies are where they were drawn. Neighbours must be up to date.
    void update_contact_rate();
    /// Largest stable step of those contacts [s], as of the middle of the last step (or the start).
    [[nodiscard]] double contact_step_limit() const { return solver::contact_step_limit(contact_rate_); }
    /// Makes the neighbour list and the copies fit the present positions.
    void refresh_neighbours();
    /// Brings pressure (and volume) up to the present density, of copies too.
    void update_pressure();

    /// Liquid turns solid, bonds are made and break. New nodes that are no walls' are particles of the liquid still.
    /// Pressures, neighbours and copies must be up to date, and are afterwards.
    void change_bodies(const BodyChange& change);
    /// By how much the nodes of spring bodies are ahead of the liquid [s].
    [[nodiscard]] double bodies_ahead() const { return bodies_ahead_; }

    /// Sets the walls' velocities to 0, until the next step takes them from the scene.
    void forget_wall_motion();

    /// All that the next steps depend on besides the particles.
    void archive(Archive& file);

    /// Of the fluid of all ranks, as it is now.
    [[nodiscard]] FluidExtremes extremes() const;
    [[nodiscard]] const OutsideImpulses& impulses() const { return impulses_; }
    [[nodiscard]] const StageTimer& timer() const { return timer_; }
    [[nodiscard]] const Neighbours& neighbours() const { return neighbours_; }
    [[nodiscard]] const PairSweeps& sweeps() const { return *sweeps_; }
    [[nodiscard]] const SpringBodies& springs() const { return springs_; }
    [[nodiscard]] int threads() const { return settings_.threads; }
    /// Null where viscosity is explicit.
    [[nodiscard]] const ViscousSolves* viscous_solves() const { return viscosity_ ? &viscosity_->solves() : nullptr; }
    [[nodiscard]] const WallMotion& walls() const { return walls_; }
    /// Null where the scene has no species.
    [[nodiscard]] const SpeciesTransport* species() const { return species_ ? &*species_ : nullptr; }
    [[nodiscard]] const Driving& driving() const { return driving_; }
    [[nodiscard]] const BodyForce& body_force() const { return body_force_; }
    [[nodiscard]] const FluidReference& reference() const { return reference_; }

  private:
    void archive_accounts(Archive& file);
    void check_chambers() const;
    void renew_list();
    void prune_list();
    void sweep(const char* stage, const FieldList& fields, const std::function<void(ClusterChoice)>& over);
    void sum_densities();
    void sum_corrections();
    FluidExtremes advance_corrected(double t, double dt);
    FluidExtremes advance_plain(double t, double dt);
    FluidExtremes advance_species(double t, double dt);
    void sum_gradients(double t, double dt);
    void drift_to_end_of_step(double dt);
    FluidExtremes shift_particles(double dt);
    double show_bodies();
    void subtract_reference(double t);
    [[nodiscard]] VolumeSums volumes_here() const;
    [[nodiscard]] VolumeSums volumes_of_all_ranks() const;
    /// Where shifting goes by the fluid's quartic mean speed.
    [[nodiscard]] bool shifts_by_speed() const {
        return settings_.shifting > 0 && (!settings_.corrected || settings_.free_surface);
    }
    [[nodiscard]] double particle_volume() const;
    [[nodiscard]] bool has_dry_bodies() const { return settings_.dry_bodies; }
    void sum_forces(double t, double dt);
    void add_outside_forces(double t, double dt);
    void touch(double t, double dt);
    void count_contact(const ContactImpulses& given);
    void solve_viscous_forces(double t, double dt);
    void sum_density_rates(double t, double dt);
    void advance_elastic(double t, double dt);
    [[nodiscard]] ShiftStep shift_step(double dt) const;
    void exchange(const FieldList& fields);
    void kick(double t, double dt);
    void drift_to_middle(double dt);
    FluidExtremes drift_to_end(double dt);
    /// What all ranks' particles add up to after the kick, in one message: impulses, and the mean speed.
    void add_up(double t, double dt, const ExactSum& fourth_powers_of_speeds);

    ParticleStore& particles_;
    PairSettings settings_;
    const Ranks& ranks_;
    std::unique_ptr<PairSweeps> sweeps_;
    std::vector<double> rest_density_;  ///< by part number [kg/m^3]
    /// Of copies, that forces need.
    FieldList force_fields_{Field::position, Field::pressure, Field::volume, Field::density};
    FluidPasses passes_;
    std::optional<ImplicitViscosity> viscosity_;
    SpringBodies springs_;
    WallMotion walls_;
    std::unique_ptr<SurfaceContact> surface_contact_;
    int contact_parts_ = 1;   ///< of the present step
    bool may_touch_ = false;  ///< in the present step, with implicit contact
    int unsolved_contacts_ = 0;
    std::optional<SpeciesTransport> species_;
    Driving driving_;
    Neighbours neighbours_;
    BodyForce body_force_;
    FluidReference reference_;
    std::optional<FluidExtremes> at_rest_;  ///< of a fluid that nothing moves
    double driven_mass_;                    ///< of liquid and elastic solids, of all ranks [kg]
    bool by_volume_ = false;                ///< whether pressures that are not summed over pairs act in this step
    ExactSum driven_volume_;                ///< on which they act, of this rank [m^3]
    double bodies_ahead_ = 0;
    double bodies_shown_ = 1;  ///< share of the bodies' last displacement that the store's positions include [-]
    double largest_speed_ = 0;
    /// Of the fluid at the last kick, <v^4>^(1/4); only where shifting goes by it [m/s].
    double quartic_mean_speed_ = 0;
    double contact_rate_ = 0;  ///< bound of the square of the contacts' highest frequency [1/s^2]
    OutsideImpulses impulses_;
    StageTimer timer_;
};

}  // namespace dmp::solver
