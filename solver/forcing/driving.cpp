// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/forcing/driving.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/unlisted_value.hpp"
#include "particles/periodic_images.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

int number_of(const ParticleSpace& space, const std::string& name) {
    const int part = space.part_named(name);
    if (part < 0)
        throw InputError("the particles have no part '" + name + "', which the scene pushes", "mesh the scene again");
    return part;
}

template <class Driver>
ScheduleWindow window_of(const Driver& driver) {
    return {driver.from, driver.until > 0 ? driver.until.value : infinity, driver.period};
}

ShapeSide side_of(PushedSide side) {
    switch (side) {
        case PushedSide::both:
            return ShapeSide::both;
        case PushedSide::inside:
            return ShapeSide::inside;
        case PushedSide::outside:
            return ShapeSide::outside;
    }
    unlisted_value(side);
}

bool is_total(ForceAmount amount) {
    switch (amount) {
        case ForceAmount::total:
            return true;
        case ForceAmount::per_particle:
            return false;
    }
    unlisted_value(amount);
}

}  // namespace

Driving::Driving(const Scene& scene, const ParticleSet& set, const ParticleSpace& space) : space_(space) {
    if (scene.forces.empty() && scene.moving_shapes.empty()) return;
    lightest_.assign(set.parts.size(), infinity);
    counts_.assign(set.parts.size(), 0);
    for (std::size_t i = 0; i < set.size(); ++i) {
        const auto part = static_cast<std::size_t>(set.part[i]);
        lightest_[part] = std::min(lightest_[part], set.mass[i]);
        ++counts_[part];
    }
    for (const ForceOnPart& force : scene.forces) {
        const int part = number_of(set, force.part);
        const bool by_mass = is_total(force.amount) && share_by_mass(set, part);
        const PartForce law{is_total(force.amount), counts_[static_cast<std::size_t>(part)]};
        forces_.push_back({part, force.force, law, window_of(force), by_mass,
                           std::ranges::any_of(*force.force, &Expression::depends_on_position),
                           std::ranges::any_of(*force.force, &Expression::depends_on_initial_position)});
    }
    for (const MovingShape& shape : scene.moving_shapes) {
        const ShapeSide side = side_of(shape.side);
        Shape made{std::vector<std::uint8_t>(set.parts.size()),
                   shape.position,
                   {},
                   {shape.strength, shape.range},
                   infinity,
                   window_of(shape)};
        switch (*shape.kind) {
            case ShapeKind::parabola:
                made.curve = ParabolaArc{shape.half_width, shape.height, side};
                break;
            case ShapeKind::circle:
                made.curve = Circle{shape.radius, side};
                break;
        }
        for (const std::string& name : *shape.parts) {
            const auto part = static_cast<std::size_t>(number_of(set, name));
            made.felt_by[part] = 1;
            made.lightest = std::min(made.lightest, lightest_[part]);
        }
        shapes_.push_back(std::move(made));
    }
}

bool Driving::share_by_mass(const ParticleSet& set, int part) {
    constexpr double alike = 1e-9;
    if (set.parts[static_cast<std::size_t>(part)].kind == PartKind::spheres) return false;
    double smallest = infinity, largest = 0, sum = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.part[i] != part) continue;
        smallest = std::min(smallest, set.mass[i]);
        largest = std::max(largest, set.mass[i]);
        sum += set.mass[i];
    }
    if (largest - smallest <= alike * largest) return false;
    mass_over_mean_.resize(set.size(), 1);
    const double mean = sum / static_cast<double>(counts_[static_cast<std::size_t>(part)]);
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.part[i] == part) mass_over_mean_[i] = set.mass[i] / mean;
    return true;
}

Vec Driving::OnPart::at(double t, const Vec& x, const Vec& at_start) const {
    if (!window.acts(t)) return Vec::Zero();
    Vec value;
    for (std::size_t axis = 0; axis < 3; ++axis)
        value[static_cast<Eigen::Index>(axis)] = law.share(force.at(axis).at(t, x, at_start));
    return value;
}

FromShape Driving::from(const Shape& shape, const Vec& x, double t) const {
    Vec apart;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        apart[axis] = x[axis] - shape.position.at(a)(t);
        if (!space_.periodic.at(a)) continue;
        const double period = space_.box.extent()[axis];
        apart[axis] = wrapped(apart[axis], -0.5 * period, 0.5 * period);
    }
    return std::visit([&](const auto& curve) { return curve.from(apart); }, shape.curve);
}

Vec Driving::uniform(int part, double t) const {
    Vec sum = Vec::Zero();
    for (const OnPart& force : forces_)
        if (force.part == part && force.is_uniform()) sum += force.at(t, Vec::Zero(), Vec::Zero());
    return sum;
}

Vec Driving::in_box(const Vec& x) const {
    Vec inside = x;
    for (int axis = 0; axis < 3; ++axis)
        if (space_.periodic.at(static_cast<std::size_t>(axis)))
            inside[axis] = wrapped(x[axis], space_.box.low[axis], space_.box.high[axis]);
    return inside;
}

Vec Driving::by_position(int part, const Vec& position, double t, double share) const {
    const Vec x = in_box(position);
    Vec sum = Vec::Zero();
    for (const OnPart& force : forces_)
        if (force.part == part && !force.is_uniform() && !force.depends_on_initial_position)
            sum += force.by_mass ? Vec(share * force.at(t, x, x)) : force.at(t, x, x);
    for (const Shape& shape : shapes_) {
        if (shape.felt_by[static_cast<std::size_t>(part)] == 0 || !shape.window.acts(t)) continue;
        const FromShape found = from(shape, x, t);
        sum += shape.law.force(found.distance) * found.away;
    }
    return sum;
}

Vec Driving::by_initial_position(int part, const Vec& x, const Vec& at_start, double t, double share) const {
    Vec sum = Vec::Zero();
    for (const OnPart& force : forces_)
        if (force.part == part && force.depends_on_initial_position)
            sum += (force.by_mass ? share : 1) * force.at(t, in_box(x), in_box(at_start));
    return sum;
}

Vec Driving::force(int part, const Vec& x, double t) const { return uniform(part, t) + by_position(part, x, t); }

bool Driving::pushes(int part) const {
    return !is_uniform(part) || std::ranges::find(forces_, part, &OnPart::part) != forces_.end();
}

double Driving::energy(int part, const Vec& x, double t) const {
    double sum = 0;
    for (const Shape& shape : shapes_)
        if (shape.felt_by[static_cast<std::size_t>(part)] != 0 && shape.window.acts(t))
            sum += shape.law.energy(from(shape, x, t).distance);
    return sum;
}

bool Driving::is_uniform(int part) const {
    const auto by_place = [&](const OnPart& force) { return force.part == part && !force.is_uniform(); };
    const auto is_felt = [&](const Shape& shape) { return shape.felt_by[static_cast<std::size_t>(part)] != 0; };
    return std::ranges::none_of(forces_, by_place) && std::ranges::none_of(shapes_, is_felt);
}

void Driving::add_uniform(ParticleGroup& group, int part, const Vec& force, int threads) const {
    const auto count = static_cast<std::ptrdiff_t>(group.owned());
    const auto tags = group.tags();
    for (int axis = 0; axis < group.dimension(); ++axis) {
        double* to = group.data(Field::force, axis);
        const double value = force[axis];
        if (value == 0) continue;
#pragma omp parallel for num_threads(threads) schedule(static)
        for (std::ptrdiff_t i = 0; i < count; ++i)
            if (tags[static_cast<std::size_t>(i)].part == part) to[i] += value;
    }
}

void Driving::add_by_position(ParticleGroup& group, const SpringBodies& springs, double t,
                              std::array<ExactSum, 3>& sum) {
    std::vector<std::uint8_t> driven;
    for (std::size_t part = 0; part < space_.parts.size(); ++part)
        driven.push_back(space_.parts[part].kind == group.kind() && !is_uniform(static_cast<int>(part)) ? 1 : 0);
    if (std::ranges::find(driven, 1) == driven.end()) return;
    for (std::size_t i = 0; i < group.owned(); ++i) {
        const std::size_t part = group.tags()[i].part;
        if (driven[part] == 0) continue;
        Vec x = Vec::Zero();
        for (int axis = 0; axis < group.dimension(); ++axis) x[axis] = group.data(Field::position, axis)[i];
        // Beyond a plane of symmetry the image is driven.
        Vec seen = x;
        for (int axis = 0; axis < group.dimension(); ++axis) seen[axis] = space_.mirrored_back(x[axis], axis);
        const double share =
            mass_over_mean_.empty() ? 1 : mass_over_mean_.at(static_cast<std::size_t>(group.tags()[i].id));
        Vec force = by_position(static_cast<int>(part), seen, t, share);
        for (int axis = 0; axis < group.dimension(); ++axis)
            if (seen[axis] != x[axis]) force[axis] = -force[axis];
        // Solids do not change places with their images.
        if (group.kind() == PartKind::elastic)
            force += by_initial_position(static_cast<int>(part), x, springs.rest_position(i), t, share);
        if (force.isZero(0)) continue;
        for (int axis = 0; axis < group.dimension(); ++axis) {
            group.data(Field::force, axis)[i] += force[axis];
            sum.at(static_cast<std::size_t>(axis)).add(force[axis]);
        }
        largest_acceleration_ = std::max(largest_acceleration_, force.norm() / lightest_[part]);
    }
}

std::array<double, 3> Driving::add_forces(ParticleStore& particles, const SpringBodies& springs, const Ranks& ranks,
                                          double t, int threads) {
    std::array<ExactSum, 3> sum;
    largest_acceleration_ = 0;
    for (const PartKind kind : {PartKind::fluid, PartKind::elastic}) {
        ParticleGroup& group = particles.of(kind);
        for (std::size_t part = 0; part < space_.parts.size(); ++part) {
            if (space_.parts[part].kind != kind) continue;
            const Vec same = uniform(static_cast<int>(part), t);
            if (same.isZero(0)) continue;
            add_uniform(group, static_cast<int>(part), same, threads);
            // Of all particles at once, however many ranks there are.
            if (ranks.is_first())
                for (std::size_t axis = 0; axis < 3; ++axis)
                    sum.at(axis).add(static_cast<double>(counts_[part]) * same[static_cast<Eigen::Index>(axis)]);
        }
        add_by_position(group, springs, t, sum);
    }
    largest_acceleration_ = ranks.largest(largest_acceleration_);
    ranks.sum(sum);
    return {sum[0].value(), sum[1].value(), sum[2].value()};
}

double Driving::step_limit(double length, double t) const {
    double acceleration = largest_acceleration_, limit = infinity;
    if (!forces_.empty())
        for (std::size_t part = 0; part < space_.parts.size(); ++part)
            if (counts_[part] > 0)
                acceleration = std::max(acceleration, uniform(static_cast<int>(part), t).norm() / lightest_[part]);
    if (acceleration > 0) limit = PartForce::step_limit(length, acceleration);
    for (const Shape& shape : shapes_) limit = std::min(limit, shape.law.step_limit(shape.lightest));
    return limit;
}

double Driving::next_change(double t) const {
    double next = infinity;
    for (const OnPart& force : forces_) next = std::min(next, force.window.next_change(t));
    for (const Shape& shape : shapes_) next = std::min(next, shape.window.next_change(t));
    return next;
}

void Driving::archive(Archive& file) {
    if (!empty()) file("driving/largest_acceleration", largest_acceleration_);
}

}  // namespace dmp::solver
