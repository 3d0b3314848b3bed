// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/fluid_run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "base/number_text.hpp"
#include "particles/apart.hpp"
#include "solver/contact/surface_contact.hpp"
#include "solver/elastic/whole_pressure.hpp"
#include "solver/output/aggregates.hpp"
#include "solver/output/make_frame.hpp"
#include "solver/results/expected_steps.hpp"
#include "solver/run/free_surface.hpp"
#include "solver/run/models_in_use.hpp"
#include "solver/run/sound_speed.hpp"
#include "solver/run/starting_state.hpp"
#include "solver/run/warnings.hpp"
#include "solver/state/loaded_groups.hpp"
#include "solver/state/state_hash.hpp"
#include "solver/time/margins.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

constexpr int steps_between_checks = 50, steps_between_searches = 50;  // searches: for chambers

/// The set itself, in which no two particles have the same position.
const ParticleSet& checked(const ParticleSet& set) {
    check_apart(set);
    return set;
}

std::string text_of(const std::optional<StabilityMonitor::Finding>& finding) {
    return finding ? finding->problem + '\n' + finding->what_to_do : "";
}

/// Nothing where nothing has touched.
std::optional<ContactSummary> contact_summary(const SurfaceContact& contact) {
    const SurfaceContact::Deepest& deepest = contact.deepest();
    if (deepest.depth == 0) return {};
    return ContactSummary{deepest.depth, deepest.time, {deepest.place[0], deepest.place[1], deepest.place[2]}};
}

}  // namespace

FluidRun::FluidRun(Scene s, const ParticleSet& set, const Resources& resources)
    : sound_(choose_sound_speed(s, set)),
      scene_(with_sound_speed(std::move(s), sound_)),
      foreseen_(sound_speed_warnings(scene_, set, sound_)),
      ranks_(resources.ranks),
      settings_(pair_settings(scene_, checked(set), resources)),
      particles_(starting_particles(scene_, set, equations_of_state(scene_, set), ranks_)),
      fluid_(scene_, set, particles_, settings_, equations_of_state(scene_, set), ranks_),
      scales_(step_scales(scene_, set, settings_, fluid_.sweeps().viscous_limit())),
      residence_times_(scene_, particles_),
      mean_displacement_(scene_, fluid_.springs()),
      measures_(scene_, set, settings_, ranks_),
      events_(scene_, set, ranks_),
      monitor_(scene_, particles_.space(), rest_densities(scene_, set), settings_.sound_speed, settings_.support),
      concentrations_(scene_),
      voids_(scene_, {settings_.corrected && !settings_.free_surface, settings_.subtracts_level}),
      penetration_(scene_, settings_.repulsion_strength),
      reached_(scene_, sound_),
      strain_(fluid_.springs()),
      frame_times_(scene_.output.every),
      measure_times_(time_between_rows(scene_)) {
    for (std::size_t i = 0; i < set.size(); ++i) ++count_[to_string(set.kind(i))];
    fill_store(scene_, set, particles_);
    if (settings_.dry_bodies) fill_whole_pressure(dry_bodies(set, settings_.threads), particles_);
    fluid_.take_speed();
    scales_.diffusion_limit = fluid_.sweeps().diffusion_limit();
    if (settings_.surface_contact) {
        fluid_.start_surface_contact(scene_, set,
                                     ruling_limit(fluid_step_limits(scales_, 0, fluid_.body_force().largest(0))).dt);
        if (fluid_.surface_contact()->stepping() == ContactStepping::at_start)
            scales_.surface_contact_limit = fluid_.surface_contact()->step_limit();
    }
    at_start_ = conserved();
}

void FluidRun::start(FrameSink* sink) {
    fluid_.refresh_neighbours();
    if (step_ == 0) fluid_.take_initial_gradients(time_);  // events may read them
    if (step_ == 0) events_.act(time_, particles_, fluid_);
    if (step_ == 0) fluid_.take_initial_gradients(time_);
    if (step_ == 0) fluid_.find_chambers();
    if (step_ == 0) fluid_.update_contact_rate();
    if (watches_contact() && !settings_.surface_contact && step_ == 0)
        penetration_.start(particles_, fluid_.neighbours().list(), ranks_);
    extremes_ = fluid_.extremes();
    if (step_ == 0) write_what_is_due(sink);
    if (starts_from_state() && frames_ == 0) start_from_state(sink);
}

void FluidRun::start_from_state(FrameSink* sink) {
    fluid_.update_contact_rate();  // its strength may have changed
    at_start_ = conserved();
    velocity_change_.start(time_);
    take_measures();
    write_frame(sink);
}

std::vector<Warning> FluidRun::chamber_warnings() const {
    std::vector<Warning> warnings;
    for (const ChamberDrift& chamber : fluid_.reference().chamber_drifts())
        if (const auto warning = chamber_warning(chamber, particles_.dimension())) warnings.push_back(*warning);
    return warnings;
}

std::vector<Warning> FluidRun::new_chamber_warnings() {
    if (warned_of_chambers_ != 0) return {};
    std::vector<Warning> warnings = chamber_warnings();
    warned_of_chambers_ = warnings.empty() ? 0 : 1;
    return warnings;
}

bool FluidRun::watches_contact() const {
    return *scene_.contact.range > 0 && !scene_.parts_of(PartKind::elastic).empty();
}

bool FluidRun::may_change_chambers() const { return scene_.changes_bodies() || !fluid_.springs().empty(); }

Conserved FluidRun::conserved() const {
    const ParticleGroup& liquid = particles_.fluid();
    ExactSum mass;
    std::array<ExactSum, 3> momentum;
    for (std::size_t i = 0; i < liquid.owned(); ++i) {
        const double m = liquid.data(Field::mass)[i];
        mass.add(m);
        for (int axis = 0; axis < liquid.dimension(); ++axis)
            momentum[axis].add(m * liquid.data(Field::velocity, axis)[i]);
    }
    ranks_.sum(mass);
    ranks_.sum(momentum);
    // Every rank holds all bodies.
    Conserved sum;
    for (const auto& body : fluid_.springs().bodies()) {
        mass.add(body->free_mass());
        const Vec of_body = body->total_momentum();
        for (int axis = 0; axis < 3; ++axis) momentum[axis].add(of_body[axis]);
    }
    sum.mass = mass.value();
    for (int axis = 0; axis < 3; ++axis) sum.momentum[axis] = momentum[axis].value();
    return sum;
}

std::vector<StepLimit> FluidRun::limits_now(double largest_speed) const {
    StepScales now = scales_;
    if (now.contact_limit > 0) now.contact_limit = std::min(now.contact_limit, fluid_.contact_step_limit());
    if (scales_.surface_contact_limit > 0) now.surface_contact_limit = fluid_.surface_contact()->step_limit();
    auto limits = fluid_step_limits(now, std::max(largest_speed, fluid_.walls().largest_speed(time_)),
                                    fluid_.body_force().largest(time_));
    add_driving_limit(limits, fluid_.driving(), scales_.support, time_);
    return limits;
}

Run::Step FluidRun::next_step(const RunOptions& /*options*/) {
    const double target = next_change(std::min({frame_times_.next(), measure_times_.next(), events_.next()}));
    const double longest = ruling_limit(limits_now(extremes_.largest_speed)).dt;
    // Equal steps up to the next time something has to be written.
    return {(target - time_) / std::max(1.0, std::ceil((target - time_) / longest * (1 - 1e-12))), target};
}

double FluidRun::next_change(double target) const {
    if (fluid_.driving().empty()) return target;
    // Times that are alike but for their last digits are one.
    const double slack = 1e-6 * ruling_limit(limits_now(extremes_.largest_speed)).dt;
    const double change = fluid_.driving().next_change(time_ + slack);
    return change < target - slack ? change : target;
}

void FluidRun::archive(Archive& file) {
    file("time", time_);
    file("step", step_);
    file.same("sound_speed", settings_.sound_speed, "the speed of sound [m/s]", "numerics.sound_speed", "m/s");
    frame_times_.archive(file, "frames_due", time_);
    measure_times_.archive(file, "measures_due", time_);
    if (!file.starts_run()) archive_accounts(file);
    if (watches_contact()) penetration_.archive_start(file);
    events_.archive(file, time_);
    if (file.loading() && events_.next() * (1 + 1e-9) < time_) throw unlike_any_run("an event that is long due");
    const auto all = [&] { return ranks_.sum(static_cast<std::int64_t>(particles_.owned())); };
    const std::int64_t before = all();
    for (ParticleGroup& group : particles_.groups()) file(std::string(to_string(group.kind())), group);
    if (file.loading()) {
        check_loaded(particles_.groups(), before, particles_.space().parts.size());
        if (all() != before) throw unlike_any_run("more or fewer particles than the run has");
    }
    if (file.starts_run()) {
        fill_by_part(scene_, particles_);
        fluid_.forget_wall_motion();
    }
    fluid_.archive(file);
}

/// What the run has counted and summed up, and what it chose by all of the time that it takes.
void FluidRun::archive_accounts(Archive& file) {
    file.same("drive_time", scales_.drive_time, "the time in which what drives the scene changes [s]");
    file("frames_", frames_);
    file("last_frame_", last_frame_);
    reached_.archive(file);
    velocity_change_.archive(file);
    strain_.archive(file);
    voids_.archive(file);
    if (watches_contact()) penetration_.archive(file);
    if (settings_.chambers) file("warned_of_chambers", warned_of_chambers_);
    file("mass_at_start", at_start_.mass);
    file("momentum_at_start", at_start_.momentum);
    measures_.archive(file);
    mean_displacement_.archive(file);
}

void FluidRun::write_frame(FrameSink* sink) {
    fluid_.update_pressure();
    fluid_.refresh_neighbours();
    write_diverged_frame(sink);
}

void FluidRun::write_diverged_frame(FrameSink* sink) {
    if (frames_ > 0 && time_ <= last_frame_) return;  // no time twice
    if (ranks_.any(sink != nullptr)) {
        const bool in_pieces = ranks_.any(sink != nullptr && sink->takes_pieces());
        const Frame frame =
            make_frame(scene_, particles_, fluid_, mean_displacement_, time_, step_, {frames_ == 0, in_pieces});
        if (sink != nullptr) sink->write(frame);
    }
    ++frames_;
    last_frame_ = time_;
}

void FluidRun::take_measures() {
    fluid_.update_pressure();
    if (measures_.need_neighbours()) fluid_.refresh_neighbours();
    measures_.take(time_, particles_, fluid_);
}

void FluidRun::write_what_is_due(FrameSink* sink) {
    if (measure_times_.due(time_)) take_measures();
    if (frame_times_.due(time_)) write_frame(sink);
}

void FluidRun::stop_if_diverged(FrameSink* sink) {
    monitor_.void_opened(voids_.text());
    stop_on_violation(sink, text_of(monitor_.check(particles_, fluid_, extremes_, time_)));
    stop_if_species_diverged(sink);
}

void FluidRun::stop_if_species_diverged(FrameSink* sink) {
    if (const SpeciesTransport* species = fluid_.species())
        stop_on_violation(sink, concentrations_.check(particles_, *species));
}

void FluidRun::advance(const RunOptions& options, const Step& step) {
    const double dt = step.dt;
    try {
        extremes_ = fluid_.advance(time_, dt);
        residence_times_.add(particles_, dt, settings_.threads);
        mean_displacement_.add(fluid_.springs(), time_, dt);
    } catch (const DivergenceError& error) {
        time_ += dt;
        ++step_;
        // The fluid_ may have gone first; if not, the springs are to blame; other errors say what is wrong.
        extremes_ = fluid_.extremes();
        stop_if_diverged(options.sink);
        if (dynamic_cast<const UnsolvedViscosity*>(&error) == nullptr &&
            dynamic_cast<const UnsolvedSpecies*>(&error) == nullptr &&
            dynamic_cast<const CrushedCell*>(&error) == nullptr)
            stop_on_violation(options.sink,
                              text_of(monitor_.stuck_elastic(particles_, fluid_, error.problem(), time_)));
        diverged(options.sink, error.problem(), error.what_to_do());
    }
    time_ = step.end(time_);
    ++step_;

    monitor_.walls_have_moved(fluid_.walls().farthest());
    std::vector<Warning> warnings = reached_.add(extremes_);
    if (SpringStrain::wants(step_))
        std::ranges::move(strain_.add(fluid_.springs(), scene_), std::back_inserter(warnings));
    if (!monitor_.fluid_is_well(extremes_) || step_ % steps_between_checks == 0) stop_if_diverged(options.sink);
    const bool has_suction = fluid_.reference().suction() > 0;
    if (VoidMonitor::wants(step_) || has_suction)
        if (const auto opened = voids_.look(particles_, ranks_, time_, has_suction)) warnings.push_back(*opened);
    if (watches_contact() && PenetrationMonitor::wants(step_))
        if (const auto passed =
                penetration_.look(particles_, fluid_.neighbours().list(), fluid_.surface_contact(), ranks_, time_))
            warnings.push_back(*passed);
    if (VelocityChange::wants(step_)) velocity_change_.add(particles_, ranks_, time_);
    if (settings_.chambers && step_ % steps_between_checks == 0)
        std::ranges::move(new_chamber_warnings(), std::back_inserter(warnings));
    for (const Warning& warning : warnings)
        if (options.warn) options.warn(time_, warning);
    if (may_change_chambers() && step_ % steps_between_searches == 0) fluid_.find_chambers();
    // The next step follows from what there is after it, as it does after a restart.
    if (events_.act(time_, particles_, fluid_)) extremes_ = fluid_.extremes();
    write_what_is_due(options.sink);
}

RunProgress FluidRun::progress(double until) const {
    return {time_,
            until,
            static_cast<long>(step_),
            ruling_limit(limits_now(extremes_.largest_speed)).dt,
            extremes_.largest_speed,
            static_cast<long>(frames_),
            count_.contains("fluid") ? extremes_.density_low : 0,
            count_.contains("fluid") ? extremes_.density_high : 0};
}

RankShares FluidRun::shares(std::int64_t steps) const {
    const Neighbours& neighbours = fluid_.neighbours();
    const HaloTraffic traffic = neighbours.traffic();
    const auto a_step = [&](std::int64_t all) {
        return ranks_.largest(static_cast<double>(all)) / static_cast<double>(std::max<std::int64_t>(1, steps));
    };
    return {neighbours.imbalance(), neighbours.ghosts_per_owned(particles_), a_step(traffic.messages),
            a_step(traffic.bytes)};
}

RunSummary FluidRun::summary() const {
    RunSummary summary;
    summary.start = at_start_;
    for (const ParticleGroup& group : particles_.groups())
        if (const auto all = ranks_.sum(static_cast<std::int64_t>(group.owned())); all > 0)
            summary.particles[to_string(group.kind())] = static_cast<std::size_t>(all);
    summary.steps = static_cast<long>(step_);
    summary.simulated_s = time_;
    summary.threads = settings_.threads;
    summary.ranks = ranks_.size();
    summary.vector_unit = name_of(chosen_vector_unit(settings_.vector_unit));
    summary.sound_speed = settings_.sound_speed;
    summary.end = conserved();
    const OutsideImpulses& given = fluid_.impulses();
    summary.impulse_of_body_forces = given.of_body_forces;
    summary.impulse_of_fixed = given.of_fixed;
    summary.impulse_of_drag = given.of_drag;
    for (int axis = 0; axis < particles_.dimension(); ++axis)
        // What planes of symmetry take or give is known as the rest.
        if (particles_.space().is_mirrored(axis))
            summary.impulse_of_fixed[axis] = summary.end.momentum[axis] - summary.start.momentum[axis] -
                                             given.of_body_forces[axis] - given.of_drag[axis];
    double residual = 0, scale = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double impulse = given.of_body_forces[axis] + summary.impulse_of_fixed[axis] + given.of_drag[axis];
        residual = std::hypot(residual, summary.end.momentum[axis] - summary.start.momentum[axis] - impulse);
        scale += std::abs(given.of_body_forces[axis]) + std::abs(summary.impulse_of_fixed[axis]) +
                 std::abs(given.of_drag[axis]);
    }
    summary.momentum_residual = scale > 0 ? residual / scale : residual;
    const double rest_density = equations_of_state(scene_, particles_.space()).front().rest_density;
    summary.density_low = reached_.density_low() * rest_density;
    summary.density_high = reached_.density_high() * rest_density;
    summary.largest_speed = reached_.largest_speed();
    summary.warnings = foreseen_;
    std::ranges::move(reached_.warnings(time_ >= scene_.run.duration), std::back_inserter(summary.warnings));
    summary.velocity_change = velocity_change_.value(settings_.spacing);
    std::ranges::move(concentrations_.warnings(ranks_), std::back_inserter(summary.warnings));
    if (const auto coarse = velocity_change_.warning(scene_)) summary.warnings.push_back(*coarse);
    summary.strains = strain_.largest();
    if (const SurfaceContact* contact = fluid_.surface_contact()) summary.contact = contact_summary(*contact);
    std::ranges::move(strain_.warnings(scene_), std::back_inserter(summary.warnings));
    summary.density_drift = fluid_.reference().density_drift();
    summary.chambers = fluid_.reference().chamber_drifts();
    if (const auto opened = voids_.warning()) summary.warnings.push_back(*opened);
    if (const auto passed = penetration_.warning(fluid_.surface_contact())) summary.warnings.push_back(*passed);
    if (const int steps = fluid_.unsolved_contacts(); steps > 0)
        summary.warnings.push_back(
            {"contact.between", scene_.contact.between.location,
             "is surfaces, and in " + std::to_string(steps) + " steps their forces were not found to 1e-6 spacings",
             "look at the solids where they touch; lower numerics.step_factor"});
    std::ranges::move(chamber_warnings(), std::back_inserter(summary.warnings));
    if (const auto drift = drift_warning(summary.density_drift)) summary.warnings.push_back(*drift);
    summary.lost = static_cast<std::size_t>(
        ranks_.sum(static_cast<std::int64_t>(monitor_.lost(particles_, fluid_.neighbours().list()))));
    summary.state_hash = state_hash(particles_, ranks_);
    summary.seconds_by_stage = fluid_.timer().seconds();
    if (fluid_.viscous_solves() != nullptr) summary.viscous_solves = *fluid_.viscous_solves();
    if (const SpeciesTransport* species = fluid_.species()) {
        summary.species = species->balances(particles_);
        summary.species_solves = species->solves();
    }
    summary.measures = measures_.series();
    const SpringBodies& springs = fluid_.springs();
    for (int origin = 0; scene_.changes_bodies() && origin < static_cast<int>(springs.names().size()); ++origin)
        summary.aggregates.push_back(aggregate_of(springs, origin));
    return summary;
}

}  // namespace dmp::solver
