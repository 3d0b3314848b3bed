// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/time/fluid_step.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "solver/contact/surface_contact.hpp"
#include "solver/elastic/node_mass.hpp"
#include "solver/elastic/turn_solid.hpp"
#include "solver/elastic/whole_pressure.hpp"
#include "solver/forcing/driven.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

/// Sum over the owned particles of a group. Forces of one sweep are multiples of its quantum: some of them add up
/// exactly in a double, which is faster than one by one.
ExactSum total_force(const ParticleGroup& group, int axis, bool of_one_sweep, Field field = Field::force) {
    const std::size_t at_a_time = of_one_sweep ? 32 : 1;
    const double* force = group.data(field, axis);
    ExactSum total;
    for (std::size_t begin = 0; begin < group.owned(); begin += at_a_time) {
        double some = 0;
        for (std::size_t i = begin; i < std::min(begin + at_a_time, group.owned()); ++i) some += force[i];
        total.add(some);
    }
    return total;
}

std::vector<double> rest_densities_of(const std::vector<LiquidState>& state_of_part) {
    std::vector<double> densities;
    densities.reserve(state_of_part.size());
    for (const LiquidState& state : state_of_part) densities.push_back(state.rest_density);
    return densities;
}

}  // namespace

FluidStep::FluidStep(const Scene& scene, const ParticleSet& set, ParticleStore& particles, const PairSettings& settings,
                     std::vector<LiquidState> state_of_part, const Ranks& ranks)
    : particles_(particles),
      settings_(settings),
      ranks_(ranks),
      sweeps_(make_pair_sweeps(settings, particles)),
      rest_density_(rest_densities_of(state_of_part)),
      passes_(std::move(state_of_part), settings.threads),
      springs_(
          set, scene, ranks,
          {{settings.repulsion_strength}, scene.contact.range * scene.particles.spacing, !settings.surface_contact},
          liquid_in_leaflets(settings)),
      walls_(scene, set, particles),
      driving_(scene, set, particles.space()),
      neighbours_(ranks, particles.space(), settings.support, settings.threads),
      body_force_(scene, set, particles),
      reference_({settings.subtracts_level, settings.keeps_volume,
                  VoidClosing::time(settings.support, settings.sound_speed), settings.chambers},
                 rest_density_, particles, ranks) {
    if (settings.gradient_correction)
        force_fields_.insert(force_fields_.end(), {Field::correction, Field::correction_off_diagonal});
    if (settings.corrected)
        force_fields_ = {Field::position,        Field::reduced_pressure,  Field::volume,  Field::density,
                         Field::mean_correction, Field::velocity_gradient, Field::velocity};
    if (settings.transport_velocity) force_fields_.push_back(Field::transport_velocity);
    driven_mass_ = reference_.mass() + springs_.mass();  // every rank has all bodies
    if (settings.viscosity.implicit)
        viscosity_.emplace(*sweeps_, ranks_, scene.numerics.viscosity_tolerance, settings.threads);
    if (!scene.species.empty()) {
        species_.emplace(scene, set, particles, settings, rest_density_, ranks);
        if (species_->conducts_in_solids()) neighbours_.list_within_solids();
    }
    springs_.find_nodes(particles_);
    if (elastic_solids_start_moving(scene)) springs_.show_velocities(particles_);
    springs_.show_surfaces(particles_, 0);
    if (is_at_rest(scene)) at_rest_ = FluidExtremes{0, 1, 1};
}

FluidStep::~FluidStep() = default;

FluidExtremes FluidStep::advance(double t, double dt) {
    if (at_rest_) return advance_species(t, dt);
    return settings_.corrected ? advance_corrected(t, dt) : advance_plain(t, dt);
}

/// Diffusion alone: particles, densities and neighbours stay as they are.
FluidExtremes FluidStep::advance_species(double t, double dt) {
    timer_.timed("species", [&] { species_->start(particles_, t + dt, dt); });
    timer_.timed("halo", [&] { exchange({Field::position, Field::concentration}); });
    timer_.timed("species",
                 [&] { species_->advance(particles_, neighbours_, *sweeps_, dt, ShiftStep{}, std::nullopt); });
    return *at_rest_;
}

FluidExtremes FluidStep::advance_corrected(double t, double dt) {
    const double middle = t + dt / 2;
    walls_.start_step(t, dt);
    subtract_reference(middle);

    timer_.timed("drift", [&] { drift_to_middle(dt); });
    timer_.timed("neighbours", [&] { renew_list(); });
    sum_forces(middle, dt);
    timer_.timed("kick", [&] { add_outside_forces(middle, dt); });
    if (viscosity_) solve_viscous_forces(middle, dt);
    timer_.timed("kick", [&] { kick(middle, dt); });
    timer_.timed("elastic", [&] { advance_elastic(middle, dt); });
    timer_.timed("drift", [&] { drift_to_end_of_step(dt); });
    timer_.timed("neighbours", [&] { renew_list(); });
    sum_gradients(t + dt, dt);
    FluidExtremes extremes;
    timer_.timed("shift", [&] { extremes = shift_particles(dt); });

    bodies_ahead_ = dt / 2;
    return extremes;
}

FluidExtremes FluidStep::advance_plain(double t, double dt) {
    const double middle = t + dt / 2;
    walls_.start_step(t, dt);

    timer_.timed("drift", [&] { drift_to_middle(dt); });
    timer_.timed("neighbours", [&] { renew_list(); });
    sum_densities();
    sum_corrections();
    sum_forces(middle, dt);
    timer_.timed("kick", [&] { add_outside_forces(middle, dt); });
    if (viscosity_) solve_viscous_forces(middle, dt);
    timer_.timed("kick", [&] { kick(middle, dt); });
    timer_.timed("elastic", [&] { advance_elastic(middle, dt); });
    sum_density_rates(middle, dt);
    FluidExtremes extremes;
    timer_.timed("drift", [&] { extremes = drift_to_end(dt); });

    bodies_ahead_ = dt / 2;
    return extremes;
}

/// Gradients and density rates at the end of the step with the new velocities, and the diffusion of species.
void FluidStep::sum_gradients(double t, double dt) {
    FieldList fields = walls_.show_velocities(particles_);
    fields.insert(fields.end(), {Field::position, Field::velocity, Field::density_gradient});
    if (species_ && dt > 0) {
        timer_.timed("species", [&] { species_->start(particles_, t, dt); });
        fields.push_back(Field::concentration);
    }
    sweep("density", fields, [&, g = body_force_.hydrostatic(t)](ClusterChoice clusters) {
        sweeps_->gradients(particles_, neighbours_.list(), g, clusters);
    });
    if (species_ && dt > 0)
        timer_.timed("species",
                     [&] { species_->advance(particles_, neighbours_, *sweeps_, dt, shift_step(dt), std::nullopt); });
}

void FluidStep::take_initial_gradients(double t) {
    if (!settings_.corrected) return;
    ParticleGroup& fluid = particles_.fluid();
    subtract_reference(t);
    update_pressure();
    sum_gradients(t, 0);
    for (int axis = 0; axis < particles_.dimension(); ++axis)
        std::copy_n(fluid.data(Field::next_density_gradient, axis), fluid.owned(),
                    fluid.data(Field::density_gradient, axis));
    if (reference_.subtracts()) reference_.start(volumes_of_all_ranks());
}

void FluidStep::find_chambers() {
    if (!settings_.chambers || at_rest_) return;
    std::vector<bool> moves;
    for (const auto& body : springs_.bodies()) moves.push_back(body->free_mass() > 0);
    reference_.take_chambers(solver::find_chambers(particles_, neighbours_, settings_.spacing, moves), particles_,
                             ranks_);
}

/// The reference of the next sums: the hydrostatic slope of now, and the level that is known.
void FluidStep::subtract_reference(double t) {
    passes_.subtract(reference_.pressure(particles_, body_force_.hydrostatic(t)));
}

VolumeSums FluidStep::volumes_here() const {
    const double largest_pressure = 0.1 * settings_.density.largest * settings_.sound_speed * settings_.sound_speed;
    return passes_.volume_sums(particles_.fluid(), 2 * particle_volume(), largest_pressure);
}

VolumeSums FluidStep::volumes_of_all_ranks() const {
    const VolumeSums here = volumes_here();
    std::vector<ExactSum> sums{here.volume, here.pressure, here.square, here.beside_voids};
    ranks_.sum(sums);
    return {sums[0], sums[1], sums[2], sums[3]};
}

double FluidStep::particle_volume() const { return std::pow(settings_.spacing, particles_.dimension()); }

void FluidStep::sum_forces(double t, double dt) {
    FieldList fields = force_fields_;
    for (const Field field : walls_.show_surfaces(particles_)) fields.push_back(field);
    sweep("forces", fields,
          [&, sums = ForceSums{body_force_.in_walls(t), passes_.subtracted().slope, dt}](ClusterChoice clusters) {
              sweeps_->forces(particles_, neighbours_.list(), sums, clusters);
              if (has_dry_bodies())
                  sweeps_->level_forces(particles_, neighbours_.list(), passes_.subtracted(), clusters);
          });
    if (!springs_.empty()) timer_.timed("elastic", [&] { update_contact_rate(); });
}

/// Forces that depend on time and position alone: body forces but for the liquid's uniform acceleration, which its kick
/// adds; forces on parts; moving shapes.
void FluidStep::add_outside_forces(double t, double dt) {
    const auto count = [&](const std::array<double, 3>& force) {
        for (std::size_t axis = 0; axis < 3; ++axis) impulses_.of_body_forces.at(axis) += dt * force.at(axis);
    };
    if (!springs_.empty()) count(body_force_.add_weights(particles_, springs_, ranks_, t));
    const auto gradient = body_force_.force_density(t), slope = passes_.subtracted().slope;
    std::array<double, 3> by_volume{};
    for (int axis = 0; axis < 3; ++axis) by_volume[axis] = gradient[axis] - slope[axis];
    by_volume_ = by_volume != std::array<double, 3>{};
    if (by_volume_) driven_volume_ = body_force_.add_pressure_forces(particles_, by_volume, settings_.threads);
    if (body_force_.depends_on_position()) count(body_force_.kick_fluid(particles_, ranks_, t, dt));
    if (!driving_.empty()) count(driving_.add_forces(particles_, springs_, ranks_, t, settings_.threads));
    if (surface_contact_) touch(t, dt);
}

/// Density rates with the new velocities, and the diffusion of species: in the same sweep where that is possible.
void FluidStep::sum_density_rates(double t, double dt) {
    FieldList fields = walls_.show_velocities(particles_);
    fields.push_back(Field::velocity);
    std::optional<SpeciesSums> fused;
    if (species_) {
        timer_.timed("species", [&] { species_->start(particles_, t, dt); });
        fields.push_back(Field::concentration);
        fused = species_->along(*sweeps_, dt, shift_step(dt));
    }
    sweep("density", fields, [&, g = body_force_.hydrostatic(t)](ClusterChoice clusters) {
        sweeps_->density_rates(particles_, neighbours_.list(), g, clusters, fused ? &*fused : nullptr);
    });
    if (species_)
        timer_.timed("species",
                     [&] { species_->advance(particles_, neighbours_, *sweeps_, dt, shift_step(dt), fused); });
}

/// A sweep over pairs that needs copies' present values of `fields`. What is near no copies is swept while they are on
/// their way.
void FluidStep::sweep(const char* stage, const FieldList& fields, const std::function<void(ClusterChoice)>& over) {
    timer_.timed("halo", [&] { neighbours_.start_exchange(particles_, fields); });
    const bool at_once = ranks_.size() == 1 || neighbours_.pruned_list_outdated(particles_);
    if (!at_once) timer_.timed(stage, [&] { over(ClusterChoice::inner); });
    timer_.timed("halo", [&] { neighbours_.finish_exchange(particles_); });
    timer_.timed("pruning", [&] { prune_list(); });
    timer_.timed(stage, [&] { over(at_once ? ClusterChoice::all : ClusterChoice::border); });
}

void FluidStep::sum_densities() {
    if (!settings_.density.by_summation) return;
    sweep("density", {Field::position}, [this](ClusterChoice clusters) {
        sweeps_->densities(particles_, neighbours_.list(), rest_density_, clusters);
    });
    passes_.update_pressure(particles_);
}

void FluidStep::sum_corrections() {
    if (!settings_.gradient_correction) return;
    sweep("correction", {Field::position, Field::volume},
          [this](ClusterChoice clusters) { sweeps_->corrections(particles_, neighbours_.list(), clusters); });
}

void FluidStep::update_pressure() {
    passes_.update_pressure(particles_);
    exchange({Field::position, Field::velocity, Field::pressure, Field::volume, Field::density});
}

void FluidStep::exchange(const FieldList& fields) { neighbours_.exchange(particles_, fields); }

void FluidStep::refresh_neighbours() {
    renew_list();
    if (!neighbours_.pruned_list_outdated(particles_)) return;
    exchange({Field::position});
    prune_list();
}

void FluidStep::update_contact_rate() {
    contact_rate_ = springs_.largest_contact_rate(particles_, neighbours_.list(), settings_.threads);
}

void FluidStep::prune_list() {
    neighbours_.prune_list(particles_,
                           [this](ClusterList& list, double reach) { sweeps_->prune(particles_, list, reach); });
}

void FluidStep::renew_list() {
    if (!neighbours_.outdated(particles_)) return;
    neighbours_.renew(particles_);
    springs_.find_nodes(particles_);
    passes_.update_pressure(particles_);
}

void FluidStep::change_bodies(const BodyChange& change) {
    (void)show_bodies();
    std::vector<std::int64_t> turning;
    for (const BodyParts::Node& node : change.nodes)
        if (!node.of_wall) turning.push_back(node.id);
    std::ranges::sort(turning);
    if (!turning.empty()) solidify_particles(particles_, turning, bodies_ahead_, neighbours_.list());
    springs_.change(change, particles_.space());
    if (surface_contact_) surface_contact_->find_bodies(springs_);
    springs_.number_particles(particles_);
    spread_whole_pressure(particles_, springs_.bodies().size(), ranks_);
    reference_.count(particles_, ranks_);
    neighbours_.forget();
    refresh_neighbours();
    springs_.show_surfaces(particles_, 0);
}

void FluidStep::kick(double t, double dt) {
    const auto g = body_force_.uniform(t);
    const double expected_speed = shifts_by_speed() ? largest_speed_ : 0;
    SpeedSums speeds = passes_.kick(particles_.fluid(), dt, g, expected_speed);
    largest_speed_ = ranks_.largest(speeds.largest);
    if (shifts_by_speed() && !FluidPasses::sum_alike(expected_speed, largest_speed_))
        speeds.fourth_powers = passes_.fourth_powers_of_speeds(particles_.fluid(), largest_speed_);
    add_up(t, dt, speeds.fourth_powers);
}

void FluidStep::add_up(double t, double dt, const ExactSum& fourth_powers_of_speeds) {
    const auto axes = static_cast<std::size_t>(particles_.dimension());
    std::vector<ExactSum> sums;
    for (std::size_t axis = 0; axis < axes; ++axis)
        sums.push_back(total_force(particles_.of(PartKind::rigid), static_cast<int>(axis), !viscosity_));
    if (reference_.subtracts()) {
        const VolumeSums volumes = volumes_here();
        sums.insert(sums.end(), {volumes.volume, volumes.pressure, volumes.square, volumes.beside_voids});
    } else if (shifts_by_speed()) {
        sums.push_back(fourth_powers_of_speeds);
        sums.emplace_back().add(static_cast<double>(particles_.fluid().owned()));
    }
    const std::size_t by_chamber = sums.size(), chambers = reference_.chamber_excess().size();
    if (chambers > 0)
        std::ranges::move(FluidPasses::chamber_volumes(particles_.fluid(), chambers, 2 * particle_volume()),
                          std::back_inserter(sums));
    const std::size_t by_level = sums.size();
    for (std::size_t axis = 0; has_dry_bodies() && axis < axes; ++axis)
        sums.push_back(total_force(particles_.of(PartKind::elastic), static_cast<int>(axis), true, Field::level_force));
    if (by_volume_) sums.push_back(driven_volume_);
    ranks_.sum(sums);
    const auto g = body_force_.uniform(t), pressure = body_force_.force_density(t);
    const double volume = by_volume_ ? sums.back().value() : 0;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        impulses_.of_body_forces[axis] += dt * (g[axis] * driven_mass_ + pressure[axis] * volume);
        // The walls hold what the reference pressure exerts on fluid and bodies.
        impulses_.of_fixed[axis] -= dt * (sums[axis].value() + passes_.subtracted().slope[axis] * volume);
        if (has_dry_bodies()) impulses_.of_fixed[axis] += dt * sums[by_level + axis].value();
    }
    if (reference_.subtracts())
        reference_.update({sums[axes], sums[axes + 1], sums[axes + 2], sums[axes + 3]}, dt,
                          std::span(sums).subspan(by_chamber, chambers));
    if (shifts_by_speed())
        quartic_mean_speed_ = std::sqrt(std::sqrt(sums[axes].value() / std::max(1.0, sums[axes + 1].value())));
}

void FluidStep::drift_to_middle(double dt) {
    passes_.drift_to_middle(particles_, dt / 2);
    const double bodies_moved = show_bodies();
    neighbours_.moved(std::max({dt / 2 * largest_speed_, bodies_moved, walls_.move_to_middle(particles_)}));
}

/// Moves the nodes of elastic bodies in the store to where the bodies are. Returns the largest displacement [m].
double FluidStep::show_bodies() {
    if (bodies_shown_ == 1) return 0;
    return springs_.show_positions(particles_, std::exchange(bodies_shown_, 1), 1);
}

/// Positions alone; bodies half of the way to their next middle.
void FluidStep::drift_to_end_of_step(double dt) {
    passes_.drift(particles_, dt / 2);
    double bodies_moved = 0;
    if (!springs_.empty()) {
        bodies_shown_ = 0.5;
        bodies_moved = springs_.show_positions(particles_, 0, bodies_shown_);
    }
    neighbours_.moved(std::max({dt / 2 * largest_speed_, bodies_moved, walls_.move_to_end(particles_)}));
}

FluidExtremes FluidStep::shift_particles(double dt) {
    ParticleGroup& fluid = particles_.fluid();
    const double largest_momentum = settings_.density.largest * particle_volume() * largest_speed_;
    auto shifted = passes_.shift(particles_, dt / 2, shift_step(dt), largest_momentum, reference_.density_excess(),
                                 reference_.chamber_excess());
    std::array<double, 3> largest{shifted.extremes.longest_shift, -shifted.extremes.density_low,
                                  shifted.extremes.density_high};
    ranks_.largest(largest);
    if (settings_.shifting > 0 && reference_.mass() > 0) {  // velocities interpolated anew keep the fluid's momentum
        ranks_.sum(shifted.momentum);
        std::array<double, 3> change{};
        for (int axis = 0; axis < 3; ++axis) change[axis] = -shifted.momentum[axis].value() / reference_.mass();
        passes_.add_to_velocities(fluid, change);
    }
    neighbours_.moved_besides(largest[0]);
    return {largest_speed_, -largest[1], largest[2]};
}

ShiftStep FluidStep::shift_step(double dt) const {
    if (settings_.shifting == 0 && !settings_.transport_velocity) return {};
    return {sweeps_->shift_step(quartic_mean_speed_, largest_speed_, dt), sweeps_->longest_shift()};
}

FluidExtremes FluidStep::drift_to_end(double dt) {
    const bool transports = settings_.transport_velocity;
    const ShiftStep shift = shift_step(dt);
    const PassExtremes here = passes_.drift_to_end(particles_, dt / 2, shift);
    std::array<double, 3> largest{here.longest_shift, -here.density_low, here.density_high};
    ranks_.largest(largest);
    const double shifted = largest[0];
    if (transports) passes_.note_transport(particles_.fluid(), dt, shift);
    const double bodies_moved = springs_.show_positions(particles_), walls_moved = walls_.move_to_end(particles_);
    neighbours_.moved(std::max({dt / 2 * largest_speed_ + shifted, bodies_moved, walls_moved}));
    return {largest_speed_, -largest[1], largest[2]};
}

void FluidStep::forget_wall_motion() {
    ParticleGroup& walls = particles_.of(PartKind::rigid);
    for (const Field field : {Field::velocity, Field::wall_motion, Field::surface_gradient, Field::wall_acceleration})
        for (int axis = 0; walls.has(field) && axis < walls.axes(field); ++axis)
            std::fill_n(walls.data(field, axis), walls.owned(), 0.0);
}

FluidExtremes FluidStep::extremes() const {
    const PassExtremes here = passes_.extremes(particles_.fluid());
    std::array<double, 3> largest{here.largest_speed, -here.density_low, here.density_high};
    ranks_.largest(largest);
    FluidExtremes all{largest[0], -largest[1], largest[2]};
    if (all.density_low > all.density_high) all.density_low = all.density_high = 1;  // no fluid at all
    return all;
}

}  // namespace dmp::solver
