// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/sphere_step.hpp"

#include <algorithm>
#include <cmath>

#include "models/dem/pull_off.hpp"
#include "particles/periodic_images.hpp"
#include "solver/parallel/shares.hpp"
#include "solver/spheres/quad.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

/// How far a sphere may come towards walls before they are listed anew [mean radii].
constexpr double skin_at_walls = 0.5;
/// Terms of force sums are rounded to parts of this times the largest one expected: many small spheres on a large one
/// still add up without rounding.
constexpr double room_for_sums = 8;

std::vector<bool> fixed_by_id(const ParticleSet& set) {
    std::vector<bool> fixed(set.size());
    for (std::size_t i = 0; i < set.size(); ++i) fixed[i] = set.fixed[i] != 0;
    return fixed;
}

}  // namespace

SphereStep::SphereStep(const Scene& scene, const ParticleSet& set, const ParticleSpace& space, ParticleGroup& group,
                       const SphereSetup& setup, const Resources& resources)
    : space_(space),
      group_(group),
      setup_(setup),
      quantum_(set),
      ranks_(resources.ranks),
      threads_(resources.threads),
      fixed_(fixed_by_id(set)),
      any_fixed_(std::ranges::find(fixed_, true) != fixed_.end()),
      acceleration_(scene.flow.acceleration),
      depends_on_position_(std::ranges::any_of(acceleration_, &Expression::depends_on_position)),
      may_fly_(std::ranges::all_of(acceleration_, &Expression::is_zero)),
      driving_(scene, set, space),
      rows_(resources.threads),
      walls_(space, setup.wall_velocity, setup.walls),
      neighbours_(ranks_, space, setup, set.size(), resources.threads),
      deferred_(static_cast<std::size_t>(resources.threads)),
      deferred_count_(static_cast<std::size_t>(resources.threads)),
      wall_skin_(skin_at_walls * setup.mean_radius) {
    neighbours_.set_fixed(fixed_);
    for (std::size_t part = 0; part < set.parts.size(); ++part)
        driven_.push_back(driving_.pushes(static_cast<int>(part)) ? 1 : 0);
    for (const SpherePair& pair : setup.pairs) sweeps_.push_back(contact_sweep(pair.model, resources.vector_unit));
    ExactSum mass;
    for (std::size_t i = 0; i < group.owned(); ++i)
        if (!fixed_[static_cast<std::size_t>(group.tags()[i].id)]) mass.add(group.data(Field::mass)[i]);
    ranks_.sum(mass);
    free_mass_ = mass.value();
    double speed = 0;
    for (std::size_t i = 0; i < group.owned(); ++i)
        speed = std::max(speed, std::hypot(group.data(Field::velocity, 0)[i], group.data(Field::velocity, 1)[i],
                                           group.data(Field::velocity, 2)[i]));
    largest_speed_ = ranks_.largest(speed);
    walls_.advance(0, 0);
}

SphereStep::Three SphereStep::acceleration_at(double t) const {
    Three g{};
    if (!depends_on_position_)
        for (std::size_t axis = 0; axis < 3; ++axis) g[axis] = acceleration_[axis](t);
    return g;
}

void SphereStep::start(bool with_forces, double t) {
    timer_.timed("neighbours", [&] {
        // Loads of the last step are the group's.
        neighbours_.start(group_, rows_, walls_);
        walls_.list(rows_, group_.tags(), setup_.reach + wall_skin_);
        choose_who_flies();
    });
    moved_to_walls_ = 0;
    if (with_forces) {
        walls_.advance(t, 0);
        // Overlaps of the start may be of any size: a first sweep tells how large forces are.
        sweep_contacts({});
        largest_force_ = ranks_.largest(largest_force_);
        std::ranges::fill(rows_.loads(), SphereLoad{});
        find_forces(0);
    }
}

void SphereStep::advance(double t, double dt) {
    // What drives parts is that of the middle of the step, so that a schedule's impulse is exact.
    if (!driving_.empty()) timer_.timed("kick", [&] { drive(t + 0.5 * dt, 0.5 * dt); });
    if (depends_on_position_) timer_.timed("kick", [&] { kick_by_position(t, 0.5 * dt); });
    timer_.timed("drift", [&] { kick_and_drift(t, dt); });
    walls_.advance(t, dt);
    timer_.timed("neighbours", [&] {
        moved_to_walls_ += dt * (largest_speed_ + walls_.largest_speed());
        const long prunings = neighbours_.prunings();
        const bool renewed = neighbours_.refresh(group_, rows_, walls_);
        const bool walls_too = !walls_.empty() && (renewed || moved_to_walls_ > wall_skin_);
        if (walls_too) {
            rows_.land();
            walls_.list(rows_, group_.tags(), setup_.reach + wall_skin_);
            moved_to_walls_ = 0;
        }
        if (walls_too || neighbours_.prunings() > prunings) choose_who_flies();
    });
    find_forces(dt);
    timer_.timed("kick", [&] { kick(t + dt, 0.5 * dt); });
    if (!driving_.empty()) timer_.timed("kick", [&] { drive(t + 0.5 * dt, 0.5 * dt); });
}

namespace {

/// Velocity and spin of a sphere for `half` by its load; `gained` is the velocity that a body acceleration gives.
void push(SphereMotion& sphere, const SphereLoad& load, double half, Quad gained) {
    const double part = half * sphere.inverse_mass(), radius = sphere.radius();
    if (part == 0) return;  // fixed
    write(sphere.velocity, read(sphere.velocity) + (part * read(load.force) + gained));
    // Of a solid sphere: 2/5 m R^2.
    write(sphere.spin, read(sphere.spin) + (2.5 * part / (radius * radius)) * read(load.torque));
}

}  // namespace

void SphereStep::Fastest::update_max(const SphereMotion& sphere, const Three& frame, float of_wide, float of_narrow) {
    const Quad v = read(sphere.velocity), in_frame = v - Quad{frame[0], frame[1], frame[2], 0};
    const Quad v2 = v * v, frame2 = in_frame * in_frame;
    const double square_in_frame = frame2[0] + frame2[1] + frame2[2];
    update_max({v2[0] + v2[1] + v2[2], square_in_frame * of_wide, square_in_frame * of_narrow});
}

/// Those that are not among the contacts, at no wall, and that nothing drives. Their loads are 0.
void SphereStep::choose_who_flies() {
    if (!may_fly_) return;
    const std::size_t owned = rows_.owned();
    acted_on_.assign(rows_.total() + 2, 0);
    neighbours_.list().for_each([&](std::size_t k, std::int16_t) {
        acted_on_[static_cast<std::size_t>(neighbours_.list().low()[k])] = 1;
        acted_on_[static_cast<std::size_t>(neighbours_.list().high()[k])] = 1;
    });
    walls_.for_each_listed([&](std::int32_t row) { acted_on_[static_cast<std::size_t>(row)] = 1; });
    const auto tags = group_.tags();
    for (std::size_t i = 0; i < owned; ++i) acted_on_[i] |= driven_[tags[i].part];
    rows_.flight().begin(std::span(acted_on_).first(owned));
    const auto wide = neighbours_.wide().inverse_squares(), narrow = neighbours_.narrow().inverse_squares();
    flying_ = {};
    for (const std::int32_t row : rows_.flight().flying()) {
        const auto i = static_cast<std::size_t>(row);
        flying_.update_max(rows_.motion()[i], neighbours_.drift(), wide[i], narrow[i]);
    }
}

/// Velocities and spins of free spheres for `half` by the loads there are.
void SphereStep::kick(double t, double half) {
    const Three g = acceleration_at(t);
    const Quad gained{half * g[0], half * g[1], half * g[2], 0};
    const auto busy = rows_.flight().busy();
    const auto motion = rows_.motion();
    const auto loads = rows_.loads();
    in_shares(busy.size(), threads_, [&](std::size_t first, std::size_t end) {
        for (const std::int32_t row : busy.subspan(first, end - first)) {
            const auto i = static_cast<std::size_t>(row);
            push(motion[i], loads[i], half, gained);
        }
    });
    if (depends_on_position_) kick_by_position(t, half);
    add_impulses(t, half);
}

void SphereStep::kick_by_position(double t, double half) {
    const auto motion = rows_.motion();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        ExactSum impulse;
        for (std::size_t i = 0; i < rows_.owned(); ++i) {
            if (motion[i].fixed()) continue;
            // Wherever it was wrapped last, a formula has the place in the box.
            Three x{};
            for (std::size_t a = 0; a < 3; ++a) {
                const auto k = static_cast<Eigen::Index>(a);
                x[a] = motion[i].position.c[a];
                if (space_.periodic[a]) x[a] = wrapped(x[a], space_.box.low[k], space_.box.high[k]);
            }
            const double gained = half * acceleration_[axis](t, x[0], x[1], x[2]);
            motion[i].velocity.c[axis] += gained;
            impulse.add(motion[i].velocity.c[3] * gained);
        }
        ranks_.sum(impulse);
        impulses_.of_body_forces[axis] += impulse.value();
    }
}

/// Velocities for `half` by the forces and shapes of time t, where the spheres are now.
void SphereStep::drive(double t, double half) {
    const auto motion = rows_.motion();
    const auto tags = group_.tags();
    std::array<ExactSum, 3> impulse;
    double largest = 0;
    for (std::size_t i = 0; i < rows_.owned(); ++i) {
        SphereMotion& sphere = motion[i];
        if (sphere.fixed() || driven_[tags[i].part] == 0) continue;
        const Vec force =
            driving_.force(tags[i].part, Vec(sphere.position.c[0], sphere.position.c[1], sphere.position.c[2]), t);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double pushed = half * force[static_cast<Eigen::Index>(axis)];
            sphere.velocity.c[axis] += pushed * sphere.inverse_mass();
            impulse[axis].add(pushed);
        }
        largest = std::max(largest, force.norm() * sphere.inverse_mass());
    }
    ranks_.sum(impulse);
    for (std::size_t axis = 0; axis < 3; ++axis) impulses_.of_body_forces[axis] += impulse[axis].value();
    driving_.update_max(ranks_.largest(largest));
}

void SphereStep::add_impulses(double t, double half) {
    const Three g = acceleration_at(t);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        impulses_.of_body_forces[axis] += half * g[axis] * free_mass_;
        impulses_.of_fixed[axis] += half * wall_force_[axis];
    }
}

/// Velocities and spins half a step and places a whole one; takes note of how fast spheres are, and how hard contacts
/// were.
void SphereStep::kick_and_drift(double t, double dt) {
    const double half = 0.5 * dt;
    const Three g = acceleration_at(t);
    const Quad gained{half * g[0], half * g[1], half * g[2], 0};
    add_impulses(t, half);
    const Three frame = neighbours_.drift();
    const double magic = quantum_.magic();
    const auto busy = rows_.flight().busy();
    const auto motion = rows_.motion();
    const auto loads = rows_.loads();
    std::fill(loads.begin() + static_cast<std::ptrdiff_t>(rows_.owned()), loads.end(), SphereLoad{});
    const auto wide = neighbours_.wide().inverse_squares(), narrow = neighbours_.narrow().inverse_squares();
    rows_.flight().pass(dt, quantum_, motion);
    Fastest of_all = flying_;
    in_shares(busy.size(), threads_, [&](std::size_t first, std::size_t end) {
        Fastest fastest;
        for (const std::int32_t row : busy.subspan(first, end - first)) {
            const auto i = static_cast<std::size_t>(row);
            push(motion[i], loads[i], half, gained);
            write(motion[i].position, read(motion[i].position) + way_of(read(motion[i].velocity), dt, magic));
            loads[i] = {};
            fastest.update_max(motion[i], frame, wide[i], narrow[i]);
        }
#pragma omp critical
        of_all.update_max(fastest);
    });
    std::array<double, 4> largest{std::sqrt(of_all.speed), largest_force_, std::sqrt(of_all.wide),
                                  std::sqrt(of_all.narrow)};
    ranks_.largest(largest);
    largest_speed_ = largest[0];
    largest_force_ = largest[1];
    neighbours_.moved(dt, largest[2], largest[3]);
}

/// Of one contact, at most about 30 times this: the largest of the last step, or that of an overlap that is new in this
/// one [N].
double SphereStep::expected_force(double dt) const {
    double largest = std::max(largest_force_, 1e-60);
    const double overlap = 2 * largest_speed_ * dt, speed = 2 * largest_speed_;
    for (const SpherePair& pair : setup_.pairs) {
        const double touch = std::sqrt(pair.largest_radius * overlap), mass = pair.largest_mass;
        largest = std::max(
            largest, pair.constants.normal_stiffness * touch * overlap +
                         pair.constants.normal_dashpot * std::sqrt(mass * touch) * speed +
                         std::min(pair.constants.normal_rate * mass * touch, mass / std::max(dt, 1e-300)) * speed);
        largest = std::max(largest, largest_attraction(pair.model, pair.largest_radius, pair.constants));
    }
    return largest;
}

void SphereStep::find_forces(double dt) {
    const ContactTime time{dt, 0.5 * dt};
    timer_.timed("contacts", [&] { sweep_contacts(time); });
    timer_.timed("walls", [&] {
        if (!walls_.empty()) walls_.add_loads(rows_, group_.tags(), time);
    });
    if (walls_.empty() && !any_fixed_) return;
    std::array<ExactSum, 3> from_outside = walls_.total_force();
    if (any_fixed_)
        for (std::size_t i = 0; i < rows_.owned(); ++i)
            if (rows_.motion()[i].fixed())
                for (std::size_t axis = 0; axis < 3; ++axis) from_outside[axis].add(-rows_.loads()[i].force.c[axis]);
    ranks_.sum(from_outside);
    for (std::size_t axis = 0; axis < 3; ++axis) wall_force_[axis] = from_outside[axis].value();
}

/// Returns the largest force along a normal [N].
double SphereStep::sweep_contacts_of(int thread, const ContactTime& time, const ReproducibleSum& force_rounding,
                                     const ReproducibleSum& torque_rounding) {
    ContactList& list = neighbours_.list();
    auto& deferred = deferred_[static_cast<std::size_t>(thread)];
    if (deferred.size() < list.most_deferred()) deferred.resize(list.most_deferred());
    ContactJob job;
    job.motion = rows_.motion().data();
    job.loads = rows_.loads().data();
    job.low = list.low().data();
    job.high = list.high().data();
    for (std::size_t n = 0; n < list.history_width(); ++n) job.history[n] = list.history(n);
    job.time = time;
    job.force_rounding = force_rounding;
    job.torque_rounding = torque_rounding;
    job.deferred = deferred.data();
    job.first_row = list.bounds()[static_cast<std::size_t>(thread)];
    job.end_row = threads_ == 1 ? static_cast<std::int32_t>(rows_.motion().size())
                                : list.bounds()[static_cast<std::size_t>(thread) + 1];
    for (const ContactSegment& segment : list.segments()) {
        if (segment.thread != thread) continue;
        job.first = segment.first;
        job.end = segment.end;
        job.constants = setup_.pairs[static_cast<std::size_t>(segment.kind)].constants;
        sweeps_[static_cast<std::size_t>(segment.kind)](job);
    }
    deferred_count_[static_cast<std::size_t>(thread)] = job.deferred_count;
    return job.largest_force;
}

void SphereStep::sweep_contacts(const ContactTime& time) {
    const double largest = room_for_sums * expected_force(time.dt);
    const ReproducibleSum force_rounding(largest), torque_rounding(largest * setup_.largest_radius);
    double found = 0;
    on_each_thread(threads_, [&](int thread) {
        const double largest_of_thread = sweep_contacts_of(thread, time, force_rounding, torque_rounding);
#pragma omp critical
        found = std::max(found, largest_of_thread);
    });
    largest_force_ = found;
    if (threads_ == 1) return;
    // Whose load it is does not matter: sums of these terms are exact.
    for (std::size_t thread = 0; thread < deferred_.size(); ++thread)
        for (std::size_t k = 0; k < deferred_count_[thread]; ++k) {
            const DeferredLoad& later = deferred_[thread][k];
            SphereLoad& load = rows_.loads()[static_cast<std::size_t>(later.row)];
            write(load.force, read(load.force) + read(later.load.force));
            write(load.torque, read(load.torque) + read(later.load.torque));
        }
}

void SphereStep::archive(Archive& file) {
    file("spheres/largest_speed", largest_speed_);
    double force = file.loading() ? 0 : ranks_.largest(largest_force_);
    file("spheres/largest_force", force);
    largest_force_ = force;
    file("spheres/wall_force", wall_force_);
    if (!file.starts_run()) {
        file("spheres/impulse_of_body_forces", impulses_.of_body_forces);
        file("spheres/impulse_of_fixed", impulses_.of_fixed);
    }
    neighbours_.archive(file, group_);
    walls_.archive(file, ranks_, neighbours_.ids());
    if (!file.starts_run()) driving_.archive(file);
}

}  // namespace dmp::solver
