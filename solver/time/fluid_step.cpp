// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/time/fluid_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace dmp {

namespace {

/// Distance particles may move between two list builds is half of this [spacings].
constexpr double skin_spacings = 0.4;

}  // namespace

FluidStep::FluidStep(const Scene& scene, const ParticleSet& set, ParticleStore& particles, const PairSettings& settings,
                     std::vector<TaitEquation> state_of_part)
    : scene_(scene),
      set_(set),
      particles_(particles),
      settings_(settings),
      state_of_part_(std::move(state_of_part)),
      sweeps_(make_pair_sweeps(settings, particles)),
      springs_(set, scene),
      acceleration_(scene.flow.acceleration) {
    if (settings.walls == WallModel::plain) {
        with_density_.resize(set.size());
        std::iota(with_density_.begin(), with_density_.end(), 0);
    } else {
        with_density_ = particles.ids(ParticleKind::fluid);
    }
}

void FluidStep::advance(double t, double dt) {
    timer_.timed("drift", [&] { drift_fluid(dt / 2); });
    timer_.timed("pressure", [&] { update_pressure(); });
    timer_.timed("neighbours", [&] { refresh_neighbours(); });
    timer_.timed("images", [&] { exchange_after_drift(); });
    timer_.timed("forces", [&] { sweeps_->forces(particles_, list_, body_acceleration(t + dt / 2)); });
    timer_.timed("kick", [&] { kick(t + dt / 2, dt); });
    timer_.timed("springs", [&] { advance_springs(dt); });
    timer_.timed("images", [&] { particles_.refresh_images({Field::velocity}); });
    timer_.timed("density", [&] { sweeps_->density_rates(particles_, list_); });
    timer_.timed("drift", [&] {
        drift_fluid(dt / 2);
        springs_.show_positions(particles_);
    });
    if (settings_.shifting > 0) timer_.timed("shift", [&] { shift(dt); });
}

void FluidStep::drift_fluid(double dt) {
    const auto& fluid = particles_.ids(ParticleKind::fluid);
    const auto fluid_count = static_cast<std::ptrdiff_t>(fluid.size());
    for (int axis = 0; axis < particles_.dimension(); ++axis) {
        double* x = particles_.data(Field::position, axis);
        const double* v = particles_.data(Field::velocity, axis);
#pragma omp parallel for num_threads(settings_.threads) schedule(static)
        for (std::ptrdiff_t k = 0; k < fluid_count; ++k) x[fluid[k]] += dt * v[fluid[k]];
    }
    double* density = particles_.data(Field::density);
    const double* rate = particles_.data(Field::density_rate);
    for (const int i : with_density_) density[i] += dt * rate[i];
}

void FluidStep::advance_springs(double dt) {
    if (springs_.empty()) return;
    const auto given = springs_.advance(particles_, dt, settings_.threads);
    for (int axis = 0; axis < 2; ++axis) {
        impulses_.of_fixed[axis] += given.of_anchors[axis];
        impulses_.of_drag[axis] += given.of_drag[axis];
    }
}

void FluidStep::update_pressure() {
    const double* density = particles_.data(Field::density);
    const double* mass = particles_.data(Field::mass);
    double* pressure = particles_.data(Field::pressure);
    double* volume = particles_.data(Field::volume);
    const auto count = static_cast<std::ptrdiff_t>(with_density_.size());
#pragma omp parallel for num_threads(settings_.threads) schedule(static)
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        const int i = with_density_[k];
        const TaitEquation& state = state_of_part_[set_.part[i]];
        pressure[i] = state.pressure(density[i]);
        // A solid's inertial mass is its own affair: its volume follows the density of the fluid it stands in for.
        volume[i] = particles_.kind(i) == ParticleKind::fluid ? mass[i] / density[i]
                                                              : set_.volume[i] * state.rest_density / density[i];
    }
}

void FluidStep::exchange_after_drift() {
    particles_.refresh_images({Field::position, Field::velocity, Field::density, Field::pressure, Field::volume});
}

double FluidStep::moved_since_list() const {
    double farthest = 0;
    const auto count = static_cast<std::ptrdiff_t>(particles_.owned());
    const double* x = particles_.data(Field::position, 0);
    const double* y = particles_.data(Field::position, 1);
    const double* z = particles_.dimension() == 3 ? particles_.data(Field::position, 2) : nullptr;
#pragma omp parallel for num_threads(settings_.threads) schedule(static) reduction(max : farthest)
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        double square = (x[i] - position_at_list_[0][i]) * (x[i] - position_at_list_[0][i]) +
                        (y[i] - position_at_list_[1][i]) * (y[i] - position_at_list_[1][i]);
        if (z != nullptr) square += (z[i] - position_at_list_[2][i]) * (z[i] - position_at_list_[2][i]);
        farthest = std::max(farthest, square);
    }
    return std::sqrt(farthest);
}

void FluidStep::refresh_neighbours() {
    const double skin = skin_spacings * settings_.spacing;
    if (list_.size() > 0 && moved_since_list() < skin / 2) return;
    const double reach = settings_.support + skin;
    particles_.renew_images(set_.box, set_.periodic, reach);
    list_.build(particles_, set_, reach, settings_.threads);
    for (int axis = 0; axis < particles_.dimension(); ++axis) {
        const double* x = particles_.data(Field::position, axis);
        position_at_list_[axis].assign(x, x + particles_.owned());
    }
}

std::array<double, 3> FluidStep::body_acceleration(double t) const {
    std::array<double, 3> g{};
    for (int axis = 0; axis < 3; ++axis) g[axis] = acceleration_[axis].depends_on_place() ? 0 : acceleration_[axis](t);
    return g;
}

void FluidStep::kick(double t, double dt) {
    const double* mass = particles_.data(Field::mass);
    const auto& fluid = particles_.ids(ParticleKind::fluid);
    const auto fluid_count = static_cast<std::ptrdiff_t>(fluid.size());
    for (int axis = 0; axis < particles_.dimension(); ++axis) {
        const double* force = particles_.data(Field::force, axis);
        double* v = particles_.data(Field::velocity, axis);
        const Expression& g = acceleration_[axis];
        const double uniform = g(t);
        double fluid_mass_times_g = 0;
        if (g.depends_on_place()) {
            for (const int i : fluid) {
                std::array<double, 3> p{};
                for (int a = 0; a < particles_.dimension(); ++a) p[a] = particles_.data(Field::position, a)[i];
                const double local = g(t, p[0], p[1], p[2]);
                v[i] += dt * (force[i] / mass[i] + local);
                fluid_mass_times_g += mass[i] * local;
            }
        } else {
#pragma omp parallel for num_threads(settings_.threads) schedule(static)
            for (std::ptrdiff_t k = 0; k < fluid_count; ++k)
                v[fluid[k]] += dt * (force[fluid[k]] / mass[fluid[k]] + uniform);
            if (uniform != 0)
                for (const int i : fluid) fluid_mass_times_g += mass[i] * uniform;
        }
        impulses_.of_body_forces[axis] += dt * fluid_mass_times_g;

        double on_fixed = 0;
        for (const int i : particles_.ids(ParticleKind::rigid)) on_fixed += force[i];
        for (const int i : particles_.ids(ParticleKind::springs))
            if (set_.fixed[i]) on_fixed += force[i];
        impulses_.of_fixed[axis] -= dt * on_fixed;
    }
    largest_speed_ = extremes().largest_speed;
}

void FluidStep::shift(double dt) {
    const auto& fluid = particles_.ids(ParticleKind::fluid);
    const double per_sum = sweeps_->shift_step(largest_speed_, dt);
    const double longest = sweeps_->longest_shift();
    std::array<double*, 3> x{};
    std::array<const double*, 3> sum{};
    const int dimension = particles_.dimension();
    for (int axis = 0; axis < dimension; ++axis) {
        x[axis] = particles_.data(Field::position, axis);
        sum[axis] = particles_.data(Field::shift, axis);
    }
    const auto count = static_cast<std::ptrdiff_t>(fluid.size());
#pragma omp parallel for num_threads(settings_.threads) schedule(static)
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        const int i = fluid[k];
        double square = 0;
        for (int axis = 0; axis < dimension; ++axis) square += sum[axis][i] * sum[axis][i];
        const double length = std::abs(per_sum) * std::sqrt(square);
        const double step = length > longest ? per_sum * longest / length : per_sum;
        for (int axis = 0; axis < dimension; ++axis) x[axis][i] += step * sum[axis][i];
    }
}

FluidExtremes FluidStep::extremes() const {
    const auto& fluid = particles_.ids(ParticleKind::fluid);
    const auto count = static_cast<std::ptrdiff_t>(fluid.size());
    const double* density = particles_.data(Field::density);
    std::array<const double*, 3> v{};
    for (int axis = 0; axis < particles_.dimension(); ++axis) v[axis] = particles_.data(Field::velocity, axis);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double fastest = 0, low = infinity, high = -infinity;
#pragma omp parallel for num_threads(settings_.threads) schedule(static) reduction(max                            \
                                                                                   : fastest, high) reduction(min \
                                                                                                              : low)
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        const int i = fluid[k];
        double square = 0;
        for (int axis = 0; axis < particles_.dimension(); ++axis) square += v[axis][i] * v[axis][i];
        if (!(square < infinity)) square = infinity;  // NaN too
        fastest = std::max(fastest, square);
        const double relative = density[i] / state_of_part_[set_.part[i]].rest_density;
        low = std::min(low, relative);
        high = std::max(high, relative);
    }
    if (count == 0) low = high = 1;
    return {std::sqrt(fastest), low, high};
}

}  // namespace dmp
