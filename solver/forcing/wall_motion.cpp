// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/forcing/wall_motion.hpp"

#include <algorithm>
#include <cmath>

namespace dmp::solver {

namespace {

/// R(angle) of a vector, about z.
class Turn {
  public:
    explicit Turn(double angle) : cosine_(std::cos(angle)), sine_(std::sin(angle)) {}
    [[nodiscard]] Vec operator()(const Vec& v) const {
        return {cosine_ * v[0] - sine_ * v[1], sine_ * v[0] + cosine_ * v[1], v[2]};
    }

  private:
    double cosine_, sine_;
};

Vec at(const ParticleGroup& group, Field field, std::size_t i) {
    Vec value = Vec::Zero();
    for (int axis = 0; axis < group.dimension(); ++axis) value[axis] = group.data(field, axis)[i];
    return value;
}

/// Integral over [t, t + dt] by the three-point Gauss rule.
double integral(const Expression& rate, double t, double dt) {
    const double offset = 0.5 * std::sqrt(0.6) * dt, middle = t + 0.5 * dt;
    return dt / 18 * (5 * rate(middle - offset) + 8 * rate(middle) + 5 * rate(middle + offset));
}

void clear(ParticleGroup& walls, Field field) {
    for (int k = 0; k < arrays_of(field, walls.dimension()); ++k) std::fill_n(walls.data(field, k), walls.owned(), 0.0);
}

/// Derivative of `velocity` along `axis`: of the differences to both sides over `step`, the smaller one; 0 where they
/// differ in sign, as at the end of a lid, or where the formula has no value beside the surface.
double derivative(const Expression& velocity, double t, const Vec& x, int axis, double step) {
    const Vec before = x - step * Vec::Unit(axis), after = x + step * Vec::Unit(axis);
    const double here = velocity(t, x[0], x[1], x[2]);
    const double back = (here - velocity(t, before[0], before[1], before[2])) / step;
    const double forth = (velocity(t, after[0], after[1], after[2]) - here) / step;
    if (!std::isfinite(back) || !std::isfinite(forth) || back * forth <= 0) return 0;
    return std::abs(back) < std::abs(forth) ? back : forth;
}

template <class Visit>
void for_each_of(const ParticleGroup& walls, std::uint16_t part, const Visit& visit) {
    for (std::size_t i = 0; i < walls.owned(); ++i)
        if (walls.tags()[i].part == part) visit(i);
}

}  // namespace

WallMotion::WallMotion(const Scene& scene, const ParticleSet& set, ParticleStore& particles) : spacing_(set.spacing) {
    for (const Part* part : scene.parts_of(PartKind::rigid))
        for (std::size_t p = 0; p < set.parts.size(); ++p) {
            if (set.parts[p].name != *part->name) continue;
            const auto number = static_cast<std::uint16_t>(p);
            if (part->slides()) sliding_.push_back({number, part->surface_velocity});
            if (!part->moves()) continue;
            Moving moving{number, part->velocity, part->spin, part->centre, 0, !part->spin->is_zero(), {}, {}, {}, {}};
            for (std::size_t i = 0; i < set.size(); ++i)
                if (set.part[i] == static_cast<int>(p))
                    moving.radius = std::max(moving.radius, (set.position[i] - moving.centre).norm());
            moving_.push_back(std::move(moving));
        }
    if (!moving_.empty())
        particles.of(PartKind::rigid).declare({Field::initial_position, Field::wall_normal, Field::initial_normal});
}

bool WallMotion::moves(std::uint16_t part) const {
    return std::ranges::any_of(moving_, [part](const Moving& moving) { return moving.part == part; });
}

Vec WallMotion::Moving::velocity_at(double t) const { return {velocity[0](t), velocity[1](t), velocity[2](t)}; }

Vec WallMotion::carried(std::uint16_t part, const Vec& drawn) const {
    for (const Moving& moving : moving_)
        if (moving.part == part)
            return moving.centre + moving.shown.displacement + Turn(moving.shown.angle)(drawn - moving.centre);
    return drawn;
}

Vec WallMotion::velocity(std::uint16_t part, const Vec& drawn, double t) const {
    for (const Moving& moving : moving_)
        if (moving.part == part) {
            const Vec arm = Turn(moving.shown.angle)(drawn - moving.centre);
            return moving.velocity_at(t) + (moving.turns ? moving.spin(t) : 0) * Vec(-arm[1], arm[0], 0);
        }
    return Vec::Zero();
}

WallPose WallMotion::Moving::after(const WallPose& pose, double t, double dt) const {
    WallPose next = pose;
    for (int axis = 0; axis < 3; ++axis) next.displacement[axis] += integral(velocity[axis], t, dt);
    if (turns) next.angle += integral(spin, t, dt);
    return next;
}

void WallMotion::start_step(double t, double dt) {
    t_ = t;
    dt_ = dt;
    for (Moving& part : moving_) {
        part.start = part.shown;
        part.middle = part.after(part.start, t, dt / 2);
        part.end = part.after(part.middle, t + dt / 2, dt / 2);
    }
}

double WallMotion::move_to_middle(ParticleStore& particles) { return move(particles, &Moving::middle); }
double WallMotion::move_to_end(ParticleStore& particles) { return move(particles, &Moving::end); }

/// By the difference of two places in whole quanta, which leaves alone how often a particle was moved by a period.
double WallMotion::move(ParticleStore& particles, WallPose Moving::*pose) {
    ParticleGroup& walls = particles.of(PartKind::rigid);
    const PositionQuantum& quantum = particles.quantum();
    double farthest = 0;
    for (Moving& part : moving_) {
        const WallPose from = part.shown, to = part.*pose;
        const Turn turn_from(from.angle), turn_to(to.angle);
        for_each_of(walls, part.part, [&](std::size_t i) {
            const Vec arm = at(walls, Field::initial_position, i) - part.centre;
            const Vec before = part.centre + from.displacement + turn_from(arm);
            const Vec now = part.centre + to.displacement + turn_to(arm);
            const Vec normal = turn_to(at(walls, Field::initial_normal, i));
            for (int axis = 0; axis < walls.dimension(); ++axis) {
                walls.data(Field::position, axis)[i] += quantum.round(now[axis]) - quantum.round(before[axis]);
                if (part.turns) walls.data(Field::wall_normal, axis)[i] = normal[axis];
            }
        });
        farthest = std::max(
            farthest, (to.displacement - from.displacement).norm() + part.radius * std::abs(to.angle - from.angle));
        part.shown = to;
    }
    return farthest;
}

/// Adds `factor` times the velocities at time t, of the particles or of the surface in front of them.
void WallMotion::add_motion(Of what, const Moving& part, ParticleGroup& walls, const WallPose& pose, double t, Field to,
                            double factor) const {
    const Vec velocity = part.velocity_at(t);
    const double spin = part.turns ? part.spin(t) : 0;
    const Turn turn(pose.angle);
    for_each_of(walls, part.part, [&](std::size_t i) {
        Vec drawn = at(walls, Field::initial_position, i);
        if (what == Of::surface) drawn += walls.data(Field::wall_distance)[i] * at(walls, Field::initial_normal, i);
        const Vec arm = turn(drawn - part.centre);
        const Vec here = velocity + spin * Vec(-arm[1], arm[0], 0);
        for (int axis = 0; axis < walls.dimension(); ++axis) walls.data(to, axis)[i] += factor * here[axis];
    });
}

/// Of the nearest point of the surface, at time t.
void WallMotion::show_surface_velocities(ParticleGroup& walls, WallPose Moving::*pose, double t) const {
    clear(walls, Field::velocity);
    if (walls.has(Field::surface_gradient)) clear(walls, Field::surface_gradient);
    for (const Moving& part : moving_) {
        add_motion(Of::surface, part, walls, part.*pose, t, Field::velocity, 1);
        if (part.turns && walls.has(Field::surface_gradient)) add_spin(part, walls, part.spin(t));
    }
    for (const Sliding& part : sliding_)
        for_each_of(walls, part.part, [&](std::size_t i) {
            const Vec x =
                at(walls, Field::position, i) + walls.data(Field::wall_distance)[i] * at(walls, Field::wall_normal, i);
            for (int axis = 0; axis < walls.dimension(); ++axis)
                walls.data(Field::velocity, axis)[i] += part.velocity[axis](t, x[0], x[1], x[2]);
            if (walls.has(Field::surface_gradient)) add_gradient(part, walls, i, x, t);
        });
}

/// The gradient of a rotation about z.
void WallMotion::add_spin(const Moving& part, ParticleGroup& walls, double spin) {
    const int dimension = walls.dimension();
    for_each_of(walls, part.part, [&](std::size_t i) {
        walls.data(Field::surface_gradient, 1)[i] -= spin;          // dv_x/dy
        walls.data(Field::surface_gradient, dimension)[i] += spin;  // dv_y/dx
    });
}

void WallMotion::add_gradient(const Sliding& part, ParticleGroup& walls, std::size_t i, const Vec& x, double t) const {
    const int dimension = walls.dimension();
    for (int row = 0; row < dimension; ++row) {
        if (!part.velocity[row].depends_on_position()) continue;
        for (int axis = 0; axis < dimension; ++axis)
            walls.data(Field::surface_gradient, row * dimension + axis)[i] +=
                derivative(part.velocity[row], t, x, axis, spacing_);
    }
}

FieldList WallMotion::show_surfaces(ParticleStore& particles) const {
    if (moving_.empty() && sliding_.empty()) return {};
    ParticleGroup& walls = particles.of(PartKind::rigid);
    const bool continues_pressure = walls.has(Field::wall_acceleration);
    show_surface_velocities(walls, &Moving::start, t_);
    if (continues_pressure) {
        clear(walls, Field::wall_acceleration);
        for (const Moving& part : moving_) {
            add_motion(Of::surface, part, walls, part.end, t_ + dt_, Field::wall_acceleration, 1 / dt_);
            add_motion(Of::surface, part, walls, part.start, t_, Field::wall_acceleration, -1 / dt_);
        }
    }
    FieldList changed{Field::velocity};
    if (walls.has(Field::surface_gradient)) changed.push_back(Field::surface_gradient);
    if (continues_pressure) changed.push_back(Field::wall_acceleration);
    if (moves()) changed.push_back(Field::wall_normal);
    return changed;
}

FieldList WallMotion::show_velocities(ParticleStore& particles) const {
    if (moving_.empty() && sliding_.empty()) return {};
    ParticleGroup& walls = particles.of(PartKind::rigid);
    const bool both = walls.has(Field::wall_motion);
    const Field of_particles = both ? Field::wall_motion : Field::velocity;
    if (both) show_surface_velocities(walls, &Moving::end, t_ + dt_);
    clear(walls, of_particles);
    for (const Moving& part : moving_) add_motion(Of::particles, part, walls, part.end, t_ + dt_, of_particles, 1);
    FieldList changed;
    if (both) changed.insert(changed.end(), {Field::wall_motion, Field::surface_gradient});
    if (both && moves()) changed.push_back(Field::wall_normal);
    return changed;
}

double WallMotion::largest_speed(double t) const {
    double largest = 0;
    for (const Moving& part : moving_)
        largest =
            std::max(largest, part.velocity_at(t).norm() + (part.turns ? part.radius * std::abs(part.spin(t)) : 0));
    for (const Sliding& part : sliding_) {
        if (std::ranges::any_of(part.velocity, &Expression::depends_on_position)) continue;
        largest = std::max(largest, Vec(part.velocity[0](t), part.velocity[1](t), part.velocity[2](t)).norm());
    }
    return largest;
}

double WallMotion::farthest() const {
    double farthest = 0;
    for (const Moving& part : moving_)
        farthest = std::max(farthest, part.shown.displacement.norm() + (part.turns ? 2 * part.radius : 0));
    return farthest;
}

void WallMotion::archive(Archive& file) {
    if (moving_.empty()) return;
    std::vector<double> poses;
    for (const Moving& part : moving_) {
        const Vec& d = part.shown.displacement;
        poses.insert(poses.end(), {d[0], d[1], d[2], part.shown.angle});
    }
    const std::size_t expected = poses.size();
    file("walls/poses", poses);
    if (!file.loading()) return;
    if (poses.size() != expected)
        throw InputError("the checkpoint's moving parts are not those of the scene", "start the run anew");
    for (std::size_t k = 0; k < moving_.size(); ++k)
        moving_[k].shown = {Vec(poses[4 * k], poses[4 * k + 1], poses[4 * k + 2]), poses[4 * k + 3]};
}

}  // namespace dmp::solver
