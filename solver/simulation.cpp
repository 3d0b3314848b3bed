// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "solver/output/make_frame.hpp"
#include "solver/output/measures.hpp"
#include "solver/setup.hpp"
#include "solver/state/state_hash.hpp"
#include "solver/state/watch.hpp"
#include "solver/time/fluid_step.hpp"

namespace dmp {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The times k * every, k = 0, 1, ..., one after another, without drift.
class Schedule {
  public:
    explicit Schedule(double every) : every_(every) {}
    [[nodiscard]] double next() const { return static_cast<double>(count_) * every_; }
    /// True when `time` has reached the next of them (within rounding), which is then ticked off.
    bool due(double time) {
        if (time < next() - 1e-9 * every_) return false;
        ++count_;
        return true;
    }

  private:
    double every_;
    long count_ = 0;
};

constexpr int steps_between_looks = 50;

}  // namespace

struct Simulation::State {
    State(Scene s, const ParticleSet& set, const Resources& resources)
        : scene(std::move(s)),
          ranks(resources.ranks),
          particles(set, rest_densities(scene, set)),
          settings(pair_settings(scene, resources)),
          fluid(scene, set, particles, settings, equations_of_state(scene, set), ranks),
          scales(step_scales(scene, set, settings, fluid.sweeps().viscous_limit())),
          measures(scene, set, settings, ranks),
          watch(particles.space(), rest_densities(scene, set), settings.sound_speed, settings.support) {
        for (std::size_t i = 0; i < set.size(); ++i) ++count[word(static_cast<PartKind>(set.kind(i)))];
        fill_store(scene, set, particles);
    }

    [[nodiscard]] Conserved conserved() const;
    [[nodiscard]] std::vector<StepLimit> limits_now(double time, double largest_speed) const;
    [[nodiscard]] double next_step(double time, double target, double largest_speed) const;
    void write_frame(FrameSink* sink, double time, long step);
    /// The same for a state that may hold anything: no neighbours are searched.
    void write_as_it_is(FrameSink* sink, double time, long step);
    [[noreturn]] void diverged(FrameSink* sink, double time, long step, const std::string& problem,
                               const std::string& what_to_do);
    void stop_if_diverged(const RunOptions& options, double time, long step, const FluidExtremes& extremes);

    Scene scene;
    Ranks ranks;
    std::map<std::string, std::size_t> count;  ///< particles of all ranks by kind
    ParticleStore particles;
    PairSettings settings;
    FluidStep fluid;
    StepScales scales;
    Measures measures;
    Watch watch;
    long frames = 0;
    double last_frame = 0;  ///< time of the last frame [s]
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
    for (ExactSum& axis : momentum) ranks.sum(axis);
    // Every rank holds all bodies.
    Conserved sum;
    for (const SpringBody& body : fluid.springs().bodies()) {
        mass.add(body.free_mass());
        for (int axis = 0; axis < 2; ++axis) momentum[axis].add(body.momentum()[axis]);
    }
    sum.mass = mass.value();
    for (int axis = 0; axis < 3; ++axis) sum.momentum[axis] = momentum[axis].value();
    return sum;
}

std::vector<StepLimit> Simulation::State::limits_now(double time, double largest_speed) const {
    double g = 0;
    for (const double axis : fluid.body_acceleration(time)) g = std::hypot(g, axis);
    return fluid_step_limits(scales, largest_speed, g);
}

double Simulation::State::next_step(double time, double target, double largest_speed) const {
    const double longest = ruling_limit(limits_now(time, largest_speed)).dt;
    // Equal steps up to the next time something has to be written.
    return (target - time) / std::max(1.0, std::ceil((target - time) / longest * (1 - 1e-12)));
}

void Simulation::State::write_frame(FrameSink* sink, double time, long step) {
    if (sink == nullptr) return;
    fluid.update_pressure();
    fluid.refresh_neighbours();
    write_as_it_is(sink, time, step);
}

void Simulation::State::write_as_it_is(FrameSink* sink, double time, long step) {
    if (sink == nullptr || (frames > 0 && time <= last_frame)) return;  // no time twice
    sink->write(make_frame(scene, particles, fluid, time, step, frames == 0));
    ++frames;
    last_frame = time;
}

void Simulation::State::stop_if_diverged(const RunOptions& options, double time, long step,
                                         const FluidExtremes& extremes) {
    const auto finding = watch.look(particles, extremes);
    if (!finding) return;
    diverged(options.sink, time, step, finding->problem, finding->what_to_do);
}

void Simulation::State::diverged(FrameSink* sink, double time, long step, const std::string& problem,
                                 const std::string& what_to_do) {
    write_as_it_is(sink, time, step);
    throw DivergenceError(
        "the simulation diverged at t = " + std::to_string(time) + " s, step " + std::to_string(step) + ": " + problem,
        what_to_do);
}

Simulation::Simulation(const Scene& scene, const ParticleSet& particles, const Resources& resources)
    : state_(std::make_unique<State>(scene, particles, resources)) {}

Simulation::~Simulation() = default;

Plan Simulation::plan() const {
    const State& s = *state_;
    Plan plan;
    plan.particles = s.count;
    plan.bytes_per_particle = s.particles.bytes() / std::max<std::size_t>(1, s.particles.owned());
    plan.sound_speed = s.settings.sound_speed;
    plan.largest_speed = s.scene.flow.largest_speed;
    double g = 0;  // largest over one run, sampled
    for (int k = 0; k <= 64; ++k) {
        double here = 0;
        for (const double axis : s.fluid.body_acceleration(s.scene.run.duration * k / 64))
            here = std::hypot(here, axis);
        g = std::max(g, here);
    }
    plan.limits = fluid_step_limits(s.scales, plan.largest_speed, g);
    const StepLimit ruling = ruling_limit(plan.limits);
    plan.dt = ruling.dt;
    plan.ruling_limit = ruling.model;
    plan.steps = static_cast<long>(std::ceil(s.scene.run.duration / plan.dt));
    plan.spring_substeps = s.fluid.springs().substeps(plan.dt);
    for (const auto& limit : s.fluid.springs().step_limits())
        plan.limits.push_back({"springs (" + limit.part + ")", limit.dt,
                               std::string("2 / omega_max of the drawn lattice; ") +
                                   (s.fluid.springs().implicit() ? "not binding, stepped implicitly" : "sub-cycled")});
    plan.models = models_in_use(s.scene);
    for (const ParticleGroup& group : s.particles.groups()) {
        if (group.empty()) continue;
        for (const Field field : group.declared()) {
            const auto bytes = static_cast<std::size_t>(group.axes(field)) * sizeof(double);
            plan.fields.push_back(word(static_cast<PartKind>(group.kind())) + std::string(": ") +
                                  std::string(info(field).name) + ", " + std::to_string(bytes) + " bytes");
        }
    }
    return plan;
}

RunSummary Simulation::run(const RunOptions& options) {
    State& s = *state_;
    const double until = options.until > 0 ? options.until : s.scene.run.duration.value;
    const double measure_every =
        s.scene.output.measure_every > 0 ? s.scene.output.measure_every.value : s.scene.output.every / 4;
    Schedule frame_times(s.scene.output.every), measure_times(measure_every);

    RunSummary summary;
    summary.start = s.conserved();
    summary.density_low = std::numeric_limits<double>::infinity();
    FluidExtremes extremes = s.fluid.extremes();
    double time = 0;
    long step = 0;
    const auto start = Clock::now();
    auto last_progress = start;

    const auto output_if_due = [&] {
        if (measure_times.due(time)) {
            s.fluid.update_pressure();
            s.measures.take(time, s.particles, s.fluid);
        }
        if (frame_times.due(time)) s.write_frame(options.sink, time, step);
    };
    s.fluid.refresh_neighbours();
    output_if_due();

    const double end = until * (1 - 1e-12);
    while (time < end) {
        if (options.stop != nullptr && *options.stop) {
            summary.interrupted = true;
            s.write_frame(options.sink, time, step);
            break;
        }
        const double target = std::min({until, frame_times.next(), measure_times.next()});
        const double dt = s.next_step(time, target, extremes.largest_speed);
        try {
            s.fluid.advance(time, dt);
        } catch (const DivergenceError& error) {
            s.diverged(options.sink, time + dt, step + 1, error.problem(), error.what_to_do());
        }
        time = target - time <= 1.5 * dt ? target : time + dt;
        ++step;

        extremes = s.fluid.extremes();
        summary.density_low = std::min(summary.density_low, extremes.density_low);
        summary.density_high = std::max(summary.density_high, extremes.density_high);
        const bool unwell = !(extremes.largest_speed < s.settings.sound_speed);
        if (unwell || step % steps_between_looks == 0) s.stop_if_diverged(options, time, step, extremes);
        output_if_due();

        if (options.progress && seconds_since(last_progress) > 0.2) {
            last_progress = Clock::now();
            options.progress({time, until, step, dt, extremes.largest_speed, s.frames});
        }
    }

    summary.wall_s = seconds_since(start);
    summary.particles = s.count;
    summary.steps = step;
    summary.simulated_s = time;
    summary.particle_steps_per_s =
        static_cast<double>(step) * static_cast<double>(s.particles.owned()) / summary.wall_s;
    summary.threads = s.settings.threads;
    const Plan plan = this->plan();
    summary.limits = plan.limits;
    summary.ruling_limit = plan.ruling_limit;
    summary.sound_speed = s.settings.sound_speed;
    summary.end = s.conserved();
    const OutsideImpulses& given = s.fluid.impulses();
    summary.impulse_of_body_forces = given.of_body_forces;
    summary.impulse_of_fixed = given.of_fixed;
    summary.impulse_of_drag = given.of_drag;
    double residual = 0, scale = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double impulse = given.of_body_forces[axis] + given.of_fixed[axis] + given.of_drag[axis];
        residual = std::hypot(residual, summary.end.momentum[axis] - summary.start.momentum[axis] - impulse);
        scale += std::abs(given.of_body_forces[axis]) + std::abs(given.of_fixed[axis]) + std::abs(given.of_drag[axis]);
    }
    summary.momentum_residual = scale > 0 ? residual / scale : residual;
    const double rest_density = equations_of_state(s.scene, s.particles.space()).front().rest_density;
    summary.density_low *= rest_density;
    summary.density_high *= rest_density;
    s.fluid.refresh_neighbours();
    summary.lost = s.watch.lost(s.particles, s.fluid.neighbours().list());
    summary.state_hash = state_hash(s.particles, s.ranks);
    summary.seconds_by_stage = s.fluid.timer().seconds();
    summary.measures = s.measures.series();
    return summary;
}

}  // namespace dmp
