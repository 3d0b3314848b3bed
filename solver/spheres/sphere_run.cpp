// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/sphere_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <omp.h>

#include "base/errors.hpp"
#include "solver/forcing/driven.hpp"
#include "solver/results/expected_steps.hpp"
#include "solver/spheres/sphere_energy.hpp"
#include "solver/spheres/sphere_group.hpp"
#include "solver/spheres/sphere_monitor.hpp"
#include "solver/spheres/sphere_output.hpp"
#include "solver/state/loaded_groups.hpp"
#include "solver/state/state_hash.hpp"
#include "solver/store/position_quantum.hpp"
#include "solver/time/margins.hpp"
#include "solver/time/step_limits.hpp"

namespace dmp::solver {

namespace {

constexpr int steps_between_checks = 50;
/// Speeds are looked up in steps of this many to an octave, so that the step keeps its length while speeds change
/// little.
constexpr double speeds_an_octave = 4;

Resources with_threads(Resources resources) {
    if (resources.threads == 0) resources.threads = omp_get_num_procs();
    return resources;
}

double rounded_speed(double speed) {
    return speed > 0 ? std::exp2(std::ceil(speeds_an_octave * std::log2(speed)) / speeds_an_octave) : 0;
}

/// Steps that are alike but for their last digits become one (FreeFlight). Up, so that they do not become more: at most
/// a ten millionth beyond a limit.
double equal_to_the_bit(double dt) {
    const auto rounded = static_cast<float>(dt);
    return rounded < dt ? std::nextafter(rounded, HUGE_VALF) : rounded;
}

const ParticleSet& only_spheres(const ParticleSet& set) {
    if (set.dimension != 3) throw InputError("spheres live in 3-D, and the particles in a plane", "mesh a 3-D scene");
    if (set.count(PartKind::spheres) != set.size())
        throw InputError("spheres and other particles in one scene do not act on each other yet",
                         "leave one of them out of the scene");
    return set;
}

}  // namespace

SphereRun::SphereRun(Scene scene, const ParticleSet& set, const Resources& resources)
    : scene_(std::move(scene)),
      ranks_(resources.ranks),
      resources_(with_threads(resources)),
      space_(with_whole_periods(set, PositionQuantum(set))),
      setup_(sphere_setup(scene_, only_spheres(set))),
      group_(sphere_group(set, PositionQuantum(set), ranks_)),
      step_(scene_, set, space_, group_, setup_, resources_),
      measures_(scene_, set, ranks_),
      steady_state_(scene_.run.until_steady),
      frame_times_(scene_.output.every),
      measure_times_(time_between_rows(scene_)) {
    count_["spheres"] = set.size();
    fastest_ = rounded_speed(step_.speed_for_limits(0));
    by_hand_.check(fastest_);
}

std::vector<StepLimit> SphereRun::contact_limits() const {
    return sphere_step_limits(scene_, setup_, space_, rounded_speed(step_.speed_for_limits(time_)));
}

std::vector<StepLimit> SphereRun::limits_without_shapes() const {
    std::vector<StepLimit> all = by_hand_.added_to(contact_limits());
    add_drive_limit(all, setup_.drive_time);
    return all;
}

std::vector<StepLimit> SphereRun::limits() const {
    std::vector<StepLimit> all = limits_without_shapes();
    add_driving_limit(all, step_.driving(), setup_.smallest_radius, time_);
    if (all.empty()) all.push_back({"output", scene_.output.every, "spheres that nothing acts between"});
    return all;
}

StepLimit SphereRun::ruling_of(std::vector<StepLimit> all) const {
    if (by_hand_.given())
        std::erase_if(all, [](const StepLimit& limit) {
            return limit.model != "contact_step" && limit.model != "driving" && limit.model != "drive";
        });
    return ruling_limit(all);
}

/// The limits with their words take longer than a step of a few spheres.
double SphereRun::longest_step(const RunOptions& options) {
    const double speed = rounded_speed(step_.speed_for_limits(time_));
    if (speed != limited_speed_) {
        limited_speed_ = speed;
        const std::vector<StepLimit> limits = limits_without_shapes();
        longest_step_ = limits.empty() ? scene_.output.every.value : ruling_of(limits).dt;
        const bool was_too_long = by_hand_.too_long_at(fastest_).has_value();
        fastest_ = std::max(fastest_, speed);
        const std::optional<Warning> too_long = by_hand_.too_long_at(fastest_);
        if (too_long && !was_too_long && options.warn) options.warn(time_, *too_long);
    }
    const Driving& driving = step_.driving();
    return driving.empty() ? longest_step_ : std::min(longest_step_, driving.step_limit(setup_.smallest_radius, time_));
}

Conserved SphereRun::conserved() const {
    ExactSum mass;
    std::array<ExactSum, 3> momentum;
    for (const SphereMotion& sphere : step_.rows().motion().first(step_.rows().owned())) {
        if (sphere.fixed()) continue;
        mass.add(sphere.velocity.c[3]);
        for (std::size_t axis = 0; axis < 3; ++axis) momentum[axis].add(sphere.velocity.c[3] * sphere.velocity.c[axis]);
    }
    ranks_.sum(mass);
    ranks_.sum(momentum);
    return {mass.value(), {momentum[0].value(), momentum[1].value(), momentum[2].value()}};
}

SphereEnergy SphereRun::energy() const {
    SphereEnergy energy = kinetic_energy(step_, ranks_);
    energy.contacts = energy_in_contacts(step_, ranks_);
    return energy;
}

Plan SphereRun::plan() const {
    Plan plan;
    plan.particles = count_;
    plan.bytes_per_particle = (group_.bytes() + step_.bytes()) / std::max<std::size_t>(1, group_.owned());
    plan.largest_speed = std::max<double>(scene_.flow.largest_speed, step_.speed_for_limits(time_));
    plan.limits = limits();
    const StepLimit ruling = ruling_of(plan.limits);
    plan.dt = ruling.dt;
    plan.ruling_limit = ruling.model;
    plan.steps = expected_steps(scene_, plan.dt, scene_.run.duration);
    plan.models = sphere_models(scene_, setup_, space_);
    add_margins(plan, scene_);
    if (const auto warning = by_hand_.inaccurate_at(fastest_)) plan.warnings.push_back(*warning);
    for (const Field field : group_.declared()) {
        const auto bytes = static_cast<std::size_t>(group_.axes(field)) * sizeof(double);
        plan.fields.push_back("spheres: " + std::string(info(field).name) + ", " + std::to_string(bytes) + " bytes");
        if (info(field).needed_by == "spheres") {
            plan.models.front().fields.push_back(plan.fields.back());
            plan.models.front().bytes += bytes;
        } else {
            plan.common_fields.push_back(plan.fields.back());
        }
    }
    return plan;
}

void SphereRun::archive(Archive& file) {
    step_.give_state();
    file("time", time_);
    file("step", step_count_);
    frame_times_.archive(file, "frames_due", time_);
    measure_times_.archive(file, "measures_due", time_);
    if (!file.starts_run()) archive_accounts(file);
    const auto all = [&] { return ranks_.sum(static_cast<std::int64_t>(group_.owned())); };
    const std::int64_t before = all();
    const std::array<double, 2> radii = radii_of_all_ranks();
    file("spheres", group_);
    if (file.loading()) {
        check_loaded({&group_, 1}, before, space_.parts.size());
        if (radii_of_all_ranks() != radii) throw unlike_any_run("spheres of other sizes than the run has");
        if (all() != before) throw unlike_any_run("more or fewer spheres than the run has");
    }
    step_.archive(file);
}

/// The smallest and the largest one.
std::array<double, 2> SphereRun::radii_of_all_ranks() const {
    const double* radius = group_.data(Field::radius);
    std::array<double, 2> found{-HUGE_VAL, 0};
    for (std::size_t i = 0; i < group_.owned(); ++i)
        found = {std::max(found[0], -radius[i]), std::max(found[1], radius[i])};
    ranks_.largest(found);
    return {-found[0], found[1]};
}

/// What the run has counted and summed up, and what it chose by all of the time that it takes.
void SphereRun::archive_accounts(Archive& file) {
    file.same("drive_time", setup_.drive_time, "the time in which what drives the scene changes [s]");
    file("frames", frames_);
    file("last_frame", last_frame_);
    file("mass_at_start", at_start_.mass);
    file("momentum_at_start", at_start_.momentum);
    file("translation_at_start", energy_at_start_.translation);
    file("rotation_at_start", energy_at_start_.rotation);
    file("contact_energy_at_start", energy_at_start_.contacts);
    file("fastest", fastest_);
    measures_.archive(file);
    steady_state_.archive(file);
}

void SphereRun::write_frame(FrameSink* sink) {
    if (frames_ > 0 && time_ <= last_frame_) return;  // no time twice
    if (ranks_.any(sink != nullptr)) {
        const bool in_pieces = ranks_.any(sink != nullptr && sink->takes_pieces());
        const Frame frame = sphere_frame(step_, space_, time_, static_cast<long>(step_count_), frames_ == 0, in_pieces);
        if (sink != nullptr) sink->write(frame);
    }
    ++frames_;
    last_frame_ = time_;
}

void SphereRun::write_what_is_due(FrameSink* sink) {
    if (measure_times_.due(time_)) take_measures();
    if (frame_times_.due(time_)) write_frame(sink);
}

void SphereRun::stop_if_diverged(FrameSink* sink) { stop_on_violation(sink, trouble_with_spheres(step_, space_)); }

Run::Step SphereRun::next_step(const RunOptions& options) {
    const double longest = longest_step(options);
    // Times that are alike but for their last digits are one.
    const double change = step_.driving().next_change(time_ + 1e-6 * longest);
    const double target = std::min({frame_times_.next(), measure_times_.next(), change});
    // Equal steps up to the next time something has to be written; the last one takes what is left.
    const double steps = std::max(1.0, std::ceil((target - time_) / longest * (1 - 1e-12)));
    return {steps > 1 ? equal_to_the_bit((target - time_) / steps) : target - time_, target};
}

void SphereRun::advance(const RunOptions& options, const Step& step) {
    // What has not been pushed yet is not still.
    const bool may_be_still = step_.driving().next_change(time_) == HUGE_VAL;
    step_.advance(time_, step.dt);
    time_ = step.end(time_);
    ++step_count_;
    if (step_count_ % steps_between_checks == 0 || time_ == step.target) stop_if_diverged(options.sink);
    if (may_be_still) steady_state_.update(time_, step_, ranks_);
    write_what_is_due(options.sink);
}

RunProgress SphereRun::progress(double until) const {
    return {time_,
            until,
            static_cast<long>(step_count_),
            ruling_of(limits()).dt,
            step_.largest_speed(),
            static_cast<long>(frames_),
            0,
            0};
}

void SphereRun::start(FrameSink* sink) {
    if (!begun_) step_.start(step_count_ == 0, time_);
    begun_ = true;
    const bool from_state = starts_from_state() && frames_ == 0;
    if (step_count_ > 0 && !from_state) return;
    at_start_ = conserved();
    energy_at_start_ = energy();
    stop_if_diverged(sink);
    if (!from_state) return write_what_is_due(sink);
    take_measures();
    write_frame(sink);
}

void SphereRun::finish(FrameSink* sink) {
    if (steady_state_.reached()) write_frame(sink);
    step_.give_state();
}

RankShares SphereRun::shares(std::int64_t steps) const {
    const auto a_step = [&](std::int64_t all) {
        return ranks_.largest(static_cast<double>(all)) / static_cast<double>(std::max<std::int64_t>(1, steps));
    };
    const Halo& halo = step_.neighbours().halo();
    return {step_.neighbours().imbalance(), halo.ghosts_per_owned(), a_step(halo.traffic().messages),
            a_step(halo.traffic().bytes)};
}

std::vector<Warning> SphereRun::warnings(const SphereEnergy& end) const {
    std::vector<Warning> warnings;
    if (const auto too_long = by_hand_.too_long_at(fastest_)) warnings.push_back(*too_long);
    if (const auto grown = grown_energy(scene_, setup_, energy_at_start_, end); grown && !is_driven(scene_))
        warnings.push_back(*grown);
    return warnings;
}

RunSummary SphereRun::summary() const {
    RunSummary summary;
    summary.particles = count_;
    summary.steps = static_cast<long>(step_count_);
    summary.simulated_s = time_;
    summary.threads = resources_.threads;
    summary.ranks = ranks_.size();
    summary.vector_unit = name_of(chosen_vector_unit(resources_.vector_unit));
    summary.start = at_start_;
    summary.end = conserved();
    const OutsideImpulses& given = step_.impulses();
    summary.impulse_of_body_forces = given.of_body_forces;
    summary.impulse_of_fixed = given.of_fixed;
    double residual = 0, scale = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        residual = std::hypot(residual, summary.end.momentum[axis] - summary.start.momentum[axis] -
                                            given.of_body_forces[axis] - given.of_fixed[axis]);
        scale += std::abs(given.of_body_forces[axis]) + std::abs(given.of_fixed[axis]);
    }
    summary.momentum_residual = scale > 0 ? residual / scale : residual;
    const LargestOverlap overlap = largest_overlap(step_);
    const SphereEnergy energy_at_end = energy();
    summary.warnings = warnings(energy_at_end);
    summary.spheres = SphereSummary{energy_at_start_, energy_at_end,
                                    static_cast<std::size_t>(ranks_.sum(static_cast<std::int64_t>(overlap.touching))),
                                    ranks_.largest(overlap.ratio), steady_state_.since()};
    summary.state_hash = state_hash(std::span(&group_, 1), space_, ranks_);
    summary.seconds_by_stage = step_.timer().seconds();
    summary.measures = measures_.series();
    return summary;
}

}  // namespace dmp::solver
