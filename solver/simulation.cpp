// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "particles/apart.hpp"
#include "solver/models_in_use.hpp"
#include "solver/output/aggregates.hpp"
#include "solver/output/make_frame.hpp"
#include "solver/output/measures.hpp"
#include "solver/output/residence_times.hpp"
#include "solver/run_loop.hpp"
#include "solver/setup.hpp"
#include "solver/solidify/body_events.hpp"
#include "solver/sound_speed.hpp"
#include "solver/spheres/sphere_run.hpp"
#include "solver/starting_state.hpp"
#include "solver/state/checkpoints.hpp"
#include "solver/state/state_hash.hpp"
#include "solver/state/watch.hpp"
#include "solver/time/fluid_step.hpp"
#include "solver/time/schedule.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

constexpr int steps_between_looks = 50;

/// The set itself, of which no two particles lie at one place.
const ParticleSet& checked(const ParticleSet& set) {
    check_apart(set);
    return set;
}

/// Of the ranks' texts, the lowest rank's that is not empty.
std::string first_that_is_not_empty(const Ranks& ranks, const std::string& text) {
    const std::vector<char> own(text.begin(), text.end());
    const std::int64_t mine = text.empty() ? ranks.size() : ranks.rank();
    const auto speaker = static_cast<std::int64_t>(ranks.smallest(static_cast<double>(mine)));
    const auto all = ranks.all_gather(speaker == ranks.rank() ? own : std::vector<char>());
    return {all.begin(), all.end()};
}

}  // namespace

struct Simulation::State final : Steps {
    State(Scene s, const ParticleSet& set, const Resources& resources)
        : sound(choose_sound_speed(s, set)),
          scene(with_sound_speed(std::move(s), sound)),
          ranks(resources.ranks),
          settings(pair_settings(scene, checked(set), resources)),
          particles(starting_particles(scene, set, equations_of_state(scene, set), ranks)),
          fluid(scene, set, particles, settings, equations_of_state(scene, set), ranks),
          scales(step_scales(scene, set, settings, fluid.sweeps().viscous_limit())),
          residence_times(scene, particles),
          mean_displacement(scene, fluid.springs()),
          measures(scene, set, settings, ranks),
          events(scene, set, ranks),
          watch(scene, particles.space(), rest_densities(scene, set), settings.sound_speed, settings.support),
          frame_times(scene.output.every),
          measure_times(scene.output.measure_every > 0 ? scene.output.measure_every.value : scene.output.every / 4) {
        for (std::size_t i = 0; i < set.size(); ++i) ++count[word(static_cast<PartKind>(set.kind(i)))];
        fill_store(scene, set, particles);
        fluid.take_speed();
        scales.diffusion_limit = fluid.sweeps().diffusion_limit();
        at_start = conserved();
    }

    [[nodiscard]] double time() const override { return time_; }
    [[nodiscard]] std::int64_t step() const override { return step_; }
    void archive(Archive& file) override;
    [[nodiscard]] RunProgress progress(double until) const override;
    [[nodiscard]] RankShares shares(std::int64_t steps) const;

    [[nodiscard]] Conserved conserved() const;
    [[nodiscard]] std::vector<StepLimit> limits_now(double largest_speed) const;
    [[nodiscard]] double next_step(double target, double largest_speed) const;
    /// The time at which what drives the scene changes, if that is before the target, else the target.
    [[nodiscard]] double next_change(double target) const;
    void write_frame(FrameSink* sink) override;
    /// The same for a state that may hold anything: no neighbours are searched.
    void write_as_it_is(FrameSink* sink);
    void write_what_is_due(FrameSink* sink);
    [[noreturn]] void diverged(FrameSink* sink, const std::string& problem, const std::string& what_to_do);
    void stop_if_diverged(FrameSink* sink);
    /// Does nothing where no rank found anything.
    void stop_for_all(FrameSink* sink, const std::optional<Watch::Finding>& finding);
    /// One step, towards `until` or the next time at which something is due.
    void advance(const RunOptions& options, double until) override;
    [[nodiscard]] RunSummary summary() const;

    SoundSpeed sound;
    Scene scene;
    Ranks ranks;
    std::map<std::string, std::size_t> count;  ///< particles of all ranks by kind
    PairSettings settings;                     // before the particles: the search for a free surface takes memory
    ParticleStore particles;
    FluidStep fluid;
    StepScales scales;
    ResidenceTimes residence_times;
    MeanDisplacement mean_displacement;
    Measures measures;
    BodyEvents events;
    Watch watch;

    double time_ = 0;  ///< [s]
    std::int64_t step_ = 0;
    FluidExtremes extremes{};  ///< of the last step
    Schedule frame_times, measure_times;
    std::int64_t frames = 0;
    double last_frame = 0;                                                           ///< time of the last frame [s]
    double density_low = std::numeric_limits<double>::infinity(), density_high = 0;  ///< so far, relative
    Conserved at_start;
};

Conserved Simulation::State::conserved() const {
    const ParticleGroup& liquid = particles.fluid();
    ExactSum mass;
    std::array<ExactSum, 3> momentum;
    for (std::size_t i = 0; i < liquid.owned(); ++i) {
        const double m = liquid.data(Field::mass)[i];
        mass.add(m);
        for (int axis = 0; axis < liquid.dimension(); ++axis)
            momentum[axis].add(m * liquid.data(Field::velocity, axis)[i]);
    }
    ranks.sum(mass);
    ranks.sum(momentum);
    // Every rank holds all bodies.
    Conserved sum;
    for (const auto& body : fluid.springs().bodies()) {
        mass.add(body->free_mass());
        const Vec of_body = body->total_momentum();
        for (int axis = 0; axis < 3; ++axis) momentum[axis].add(of_body[axis]);
    }
    sum.mass = mass.value();
    for (int axis = 0; axis < 3; ++axis) sum.momentum[axis] = momentum[axis].value();
    return sum;
}

std::vector<StepLimit> Simulation::State::limits_now(double largest_speed) const {
    double g = 0;
    for (const double axis : fluid.body_acceleration(time_)) g = std::hypot(g, axis);
    StepScales now = scales;
    if (now.contact_limit > 0) now.contact_limit = std::min(now.contact_limit, fluid.contact_step_limit());
    auto limits = fluid_step_limits(now, std::max(largest_speed, fluid.walls().largest_speed(time_)), g);
    add_driving_limit(limits, fluid.driving(), scales.support, time_);
    return limits;
}

double Simulation::State::next_step(double target, double largest_speed) const {
    const double longest = ruling_limit(limits_now(largest_speed)).dt;
    // Equal steps up to the next time something has to be written.
    return (target - time_) / std::max(1.0, std::ceil((target - time_) / longest * (1 - 1e-12)));
}

double Simulation::State::next_change(double target) const {
    if (fluid.driving().empty()) return target;
    // Times that are alike but for their last digits are one.
    const double slack = 1e-6 * ruling_limit(limits_now(extremes.largest_speed)).dt;
    const double change = fluid.driving().next_change(time_ + slack);
    return change < target - slack ? change : target;
}

void Simulation::State::archive(Archive& file) {
    file("time", time_);
    file("step", step_);
    frame_times.archive(file, "frames_due");
    measure_times.archive(file, "measures_due");
    file("frames", frames);
    file("last_frame", last_frame);
    file("density_low", density_low);
    file("density_high", density_high);
    file("mass_at_start", at_start.mass);
    file("momentum_at_start", at_start.momentum);
    measures.archive(file);
    events.archive(file);
    for (ParticleGroup& group : particles.groups()) file(std::string(word(static_cast<PartKind>(group.kind()))), group);
    fluid.archive(file);
    mean_displacement.archive(file);
}

void Simulation::State::write_frame(FrameSink* sink) {
    fluid.update_pressure();
    fluid.refresh_neighbours();
    write_as_it_is(sink);
}

void Simulation::State::write_as_it_is(FrameSink* sink) {
    if (frames > 0 && time_ <= last_frame) return;  // no time twice
    if (ranks.any(sink != nullptr)) {
        const bool in_pieces = ranks.any(sink != nullptr && sink->takes_pieces());
        const Frame frame =
            make_frame(scene, particles, fluid, mean_displacement, time_, step_, {frames == 0, in_pieces});
        if (sink != nullptr) sink->write(frame);
    }
    ++frames;
    last_frame = time_;
}

void Simulation::State::write_what_is_due(FrameSink* sink) {
    if (measure_times.due(time_)) {
        fluid.update_pressure();
        if (measures.need_neighbours()) fluid.refresh_neighbours();
        measures.take(time_, particles, fluid);
    }
    if (frame_times.due(time_)) write_frame(sink);
}

void Simulation::State::stop_if_diverged(FrameSink* sink) {
    stop_for_all(sink, watch.look(particles, fluid, extremes, time_));
}

void Simulation::State::stop_for_all(FrameSink* sink, const std::optional<Watch::Finding>& finding) {
    // The lowest rank that found something speaks for all.
    const std::string found =
        first_that_is_not_empty(ranks, finding ? finding->problem + '\n' + finding->what_to_do : "");
    if (found.empty()) return;
    const auto end = found.find('\n');
    diverged(sink, found.substr(0, end), found.substr(end + 1));
}

void Simulation::State::diverged(FrameSink* sink, const std::string& problem, const std::string& what_to_do) {
    write_as_it_is(sink);
    throw DivergenceError("the simulation diverged at t = " + std::to_string(time_) + " s, step " +
                              std::to_string(step_) + ": " + problem,
                          what_to_do);
}

Simulation::Simulation(const Scene& scene, const ParticleSet& particles, const Resources& resources) {
    if (particles.has_spheres())
        spheres_ = std::make_unique<SphereRun>(scene, particles, resources);
    else
        state_ = std::make_unique<State>(scene, particles, resources);
}

Simulation::~Simulation() = default;

Plan Simulation::plan() const {
    if (spheres_) return spheres_->plan();
    const State& s = *state_;
    Plan plan;
    plan.particles = s.count;
    plan.bytes_per_particle = s.particles.bytes() / std::max<std::size_t>(1, s.particles.owned());
    plan.sound_speed = s.settings.sound_speed;
    plan.largest_speed = s.scene.flow.largest_speed;
    plan.sound = s.sound;
    double g = 0;  // largest over one run, sampled
    for (int k = 0; k <= 64; ++k) {
        double here = 0;
        for (const double axis : s.fluid.body_acceleration(s.scene.run.duration * k / 64))
            here = std::hypot(here, axis);
        g = std::max(g, here);
    }
    plan.limits = fluid_step_limits(s.scales, plan.largest_speed, g);
    add_driving_limit(plan.limits, s.fluid.driving(), s.scales.support, s.time_);
    const StepLimit ruling = ruling_limit(plan.limits);
    plan.dt = ruling.dt;
    plan.ruling_limit = ruling.model;
    plan.steps = static_cast<long>(std::ceil(s.scene.run.duration / plan.dt));
    plan.spring_substeps = s.fluid.springs().substeps(plan.dt);
    if (s.settings.implicit_viscosity && s.scales.kinematic_viscosity > 0) {
        plan.limits.push_back(viscous_step_limit(s.scales));
        plan.limits.back().formula += "; not binding, stepped implicitly";
    }
    if (s.scales.implicit_species && s.scales.diffusivity > 0) {
        plan.limits.push_back(species_step_limit(s.scales));
        plan.limits.back().formula += "; not binding, stepped implicitly";
    }
    for (const auto& limit : s.fluid.springs().step_limits())
        plan.limits.push_back({"springs (" + limit.part + ")", limit.dt,
                               std::string("2 / omega_max of the drawn lattice; ") +
                                   (s.fluid.springs().implicit() ? "not binding, stepped implicitly" : "sub-cycled")});
    for (const Solidify& rule : s.scene.solidify)
        plan.limits.push_back({"springs (" + *rule.name + ")", new_bond_limit(s.scene, rule),
                               std::string("2 / omega of one new bond alone; ") +
                                   (s.fluid.springs().implicit() ? "not binding, stepped implicitly"
                                                                 : "sub-cycled, by the stiffest body there is")});
    plan.models = models_in_use(s.scene, s.settings, s.fluid.sweeps(), s.fluid.springs());
    plan.warnings = warnings_of(s.scene, s.fluid.springs().bodies().size());
    for (const ParticleGroup& group : s.particles.groups()) {
        if (group.empty()) continue;
        for (const Field field : group.declared()) {
            const auto bytes = static_cast<std::size_t>(group.axes(field)) * sizeof(double);
            plan.fields.push_back(word(static_cast<PartKind>(group.kind())) + std::string(": ") +
                                  std::string(info(field).name) + ", " + std::to_string(bytes) + " bytes");
            const std::string_view owner = info(field).needed_by;
            const auto model = std::ranges::find_if(plan.models, [&](const ModelUse& use) {
                return !owner.empty() && use.model.find(owner) != std::string::npos;
            });
            if (model == plan.models.end()) {
                plan.common_fields.push_back(plan.fields.back());
            } else {
                model->fields.push_back(plan.fields.back());
                model->bytes += bytes;
            }
        }
    }
    return plan;
}

long Simulation::resume(const std::filesystem::path& checkpoint) {
    // The first rank has checked the file's seal before it was chosen.
    const Hdf5Reader file(checkpoint);
    if (spheres_) return spheres_->resume(file);
    State& s = *state_;
    Archive archive(s.ranks, file);
    s.archive(archive);
    return static_cast<long>(s.frames);
}

void Simulation::State::advance(const RunOptions& options, double until) {
    const double target = next_change(std::min({until, frame_times.next(), measure_times.next(), events.next()}));
    const double dt = next_step(target, extremes.largest_speed);
    try {
        extremes = fluid.advance(time_, dt);
        residence_times.add(particles, dt, settings.threads);
        mean_displacement.add(fluid.springs(), time_, dt);
    } catch (const DivergenceError& error) {
        time_ += dt;
        ++step_;
        // The fluid may have gone first; if not, the springs are to blame, or viscosity speaks for itself.
        extremes = fluid.extremes();
        stop_if_diverged(options.sink);
        if (dynamic_cast<const UnsolvedViscosity*>(&error) == nullptr &&
            dynamic_cast<const UnsolvedSpecies*>(&error) == nullptr)
            stop_for_all(options.sink, watch.stuck_springs(particles, fluid, error.problem(), time_));
        diverged(options.sink, error.problem(), error.what_to_do());
    }
    time_ = target - time_ <= 1.5 * dt ? target : time_ + dt;
    ++step_;

    watch.walls_have_moved(fluid.walls().farthest());
    density_low = std::min(density_low, extremes.density_low);
    density_high = std::max(density_high, extremes.density_high);
    if (!watch.fluid_is_well(extremes) || step_ % steps_between_looks == 0) stop_if_diverged(options.sink);
    // The next step follows from what there is after it, as it does after a restart.
    if (events.act(time_, particles, fluid)) extremes = fluid.extremes();
    write_what_is_due(options.sink);
}

RunProgress Simulation::State::progress(double until) const {
    return {time_,
            until,
            static_cast<long>(step_),
            ruling_limit(limits_now(extremes.largest_speed)).dt,
            extremes.largest_speed,
            static_cast<long>(frames)};
}

RunSummary Simulation::run(const RunOptions& options) {
    if (spheres_) return spheres_->run(options);
    State& s = *state_;
    const double until = options.until > 0 ? options.until : s.scene.run.duration.value;
    Checkpoints checkpoints(s.ranks, options.checkpoints);
    const std::int64_t first_step = s.step_;
    s.fluid.refresh_neighbours();
    if (s.step_ == 0) s.events.act(s.time_, s.particles, s.fluid);
    if (s.step_ == 0) s.fluid.look_at_contacts();
    s.extremes = s.fluid.extremes();
    if (s.step_ == 0) s.write_what_is_due(options.sink);
    const RunEnd end = run_steps(s, s.ranks, checkpoints, options, until);
    s.fluid.refresh_neighbours();
    RunSummary summary = s.summary();
    const Plan plan = this->plan();
    summary.limits = plan.limits;
    summary.ruling_limit = plan.ruling_limit;
    summary.wall_s = end.wall;
    std::size_t all = 0;
    for (const auto& [kind, count] : s.count) all += count;
    summary.particle_steps_per_s = static_cast<double>(s.step_ - first_step) * static_cast<double>(all) / end.wall;
    summary.interrupted = end.interrupted;
    summary.out_of_time = end.out_of_time;
    summary.first_step = static_cast<long>(first_step);
    summary.shares = s.shares(s.step_ - first_step);
    return summary;
}

RankShares Simulation::State::shares(std::int64_t steps) const {
    const Neighbours& neighbours = fluid.neighbours();
    const HaloTraffic traffic = neighbours.traffic();
    const auto a_step = [&](std::int64_t all) {
        return ranks.largest(static_cast<double>(all)) / static_cast<double>(std::max<std::int64_t>(1, steps));
    };
    return {neighbours.imbalance(), neighbours.copies_per_owned(particles), a_step(traffic.messages),
            a_step(traffic.bytes)};
}

RunSummary Simulation::State::summary() const {
    RunSummary summary;
    summary.start = at_start;
    for (const ParticleGroup& group : particles.groups())
        if (const auto all = ranks.sum(static_cast<std::int64_t>(group.owned())); all > 0)
            summary.particles[word(static_cast<PartKind>(group.kind()))] = static_cast<std::size_t>(all);
    summary.steps = static_cast<long>(step_);
    summary.simulated_s = time_;
    summary.threads = settings.threads;
    summary.ranks = ranks.size();
    summary.vector_unit = word(chosen_vector_unit(settings.vector_unit));
    summary.sound_speed = settings.sound_speed;
    summary.end = conserved();
    const OutsideImpulses& given = fluid.impulses();
    summary.impulse_of_body_forces = given.of_body_forces;
    summary.impulse_of_fixed = given.of_fixed;
    summary.impulse_of_drag = given.of_drag;
    for (int axis = 0; axis < particles.dimension(); ++axis)
        // What planes of symmetry take or give is known as the rest.
        if (particles.space().is_mirrored(axis))
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
    const double rest_density = equations_of_state(scene, particles.space()).front().rest_density;
    summary.density_low = density_low * rest_density;
    summary.density_high = density_high * rest_density;
    summary.lost = static_cast<std::size_t>(
        ranks.sum(static_cast<std::int64_t>(watch.lost(particles, fluid.neighbours().list()))));
    summary.state_hash = state_hash(particles, ranks);
    summary.seconds_by_stage = fluid.timer().seconds();
    if (fluid.viscous_solves() != nullptr) summary.viscous_solves = *fluid.viscous_solves();
    if (const SpeciesTransport* species = fluid.species()) {
        summary.species = species->balances(particles);
        summary.species_solves = species->solves();
    }
    summary.measures = measures.series();
    const SpringBodies& springs = fluid.springs();
    for (int origin = 0; scene.changes_bodies() && origin < static_cast<int>(springs.names().size()); ++origin)
        summary.aggregates.push_back(aggregate_of(springs, origin));
    return summary;
}

}  // namespace dmp::solver
