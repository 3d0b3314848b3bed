// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/time/fluid_passes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "solver/parallel/sums_over.hpp"
#include "solver/sweeps/order_free.hpp"

namespace dmp {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Calls visit(i) for the owned particles of a group.
template <class Visit>
void for_each_owned(const ParticleGroup& group, int threads, const Visit& visit) {
    const auto count = static_cast<std::ptrdiff_t>(group.owned());
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::ptrdiff_t i = 0; i < count; ++i) visit(i);
}

template <int D>
std::array<double*, D> axes(ParticleGroup& group, Field field) {
    std::array<double*, D> arrays{};
    for (int axis = 0; axis < D; ++axis) arrays[axis] = group.data(field, axis);
    return arrays;
}

/// The least and the largest of value(i), i in [0, count). Side by side in lanes, so that the compiler may use vectors:
/// it may not change the order of comparisons, in which a NaN matters, by itself.
template <class Value>
std::pair<double, double> low_and_high(std::ptrdiff_t count, int threads, const Value& value) {
    constexpr std::ptrdiff_t lanes = 8, block = 64 * lanes;
    double low = infinity, high = -infinity;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(max : high) reduction(min : low)
    for (std::ptrdiff_t begin = 0; begin < count; begin += block) {
        const std::ptrdiff_t end = std::min(begin + block, count), end_of_lanes = begin + (end - begin) / lanes * lanes;
        std::array<double, lanes> lows, highs;
        lows.fill(infinity);
        highs.fill(-infinity);
        const auto look = [&](std::ptrdiff_t i, std::ptrdiff_t lane) {
            const double x = value(i);
            lows[lane] = x < lows[lane] ? x : lows[lane];
            highs[lane] = x > highs[lane] ? x : highs[lane];
        };
        for (std::ptrdiff_t i = begin; i < end_of_lanes; i += lanes)
            for (std::ptrdiff_t lane = 0; lane < lanes; ++lane) look(i + lane, lane);
        for (std::ptrdiff_t i = end_of_lanes; i < end; ++i) look(i, 0);
        for (const double x : lows) low = std::min(low, x);
        for (const double x : highs) high = std::max(high, x);
    }
    return {low, high};
}

/// Of a largest square that is infinite where a number was none.
double root(double square) { return std::sqrt(square); }

}  // namespace

FluidPasses::FluidPasses(std::vector<LiquidState> state_of_part, int threads)
    : state_of_part_(std::move(state_of_part)),
      one_state_(std::all_of(state_of_part_.begin(), state_of_part_.end(),
                             [&](const LiquidState& state) {
                                 return state.rest_density == state_of_part_.front().rest_density &&
                                        state.sound_speed == state_of_part_.front().sound_speed;
                             })),
      threads_(threads) {}

void FluidPasses::drift_to_middle(ParticleStore& particles, double dt) const {
    ParticleGroup& fluid = particles.fluid();
    const PositionQuantum& quantum = particles.quantum();
    for (int axis = 0; axis < particles.dimension(); ++axis) {
        double* x = fluid.data(Field::position, axis);
        const double* v = fluid.data(Field::velocity, axis);
        for_each_owned(fluid, threads_, [=](std::ptrdiff_t i) { x[i] += quantum.round(dt * v[i]); });
    }
    for (ParticleGroup& group : particles.groups())
        if (group.has(Field::density_rate)) {
            update_density(group, dt);
            update_pressure(group);
        }
}

void FluidPasses::note_transport(ParticleGroup& fluid, double dt, const ShiftStep& shift) const {
    for_each_owned(fluid, threads_, [&](std::ptrdiff_t i) {
        double square = 0;
        for (int axis = 0; axis < fluid.dimension(); ++axis)
            square += std::pow(shift.per_sum * fluid.data(Field::shift, axis)[i], 2);
        const double length = std::sqrt(square), shortened = length > shift.longest ? shift.longest / length : 1;
        for (int axis = 0; axis < fluid.dimension(); ++axis)
            fluid.data(Field::transport_velocity, axis)[i] =
                shortened * shift.per_sum / dt * fluid.data(Field::shift, axis)[i];
    });
}

void FluidPasses::update_density(ParticleGroup& group, double dt) const {
    double* density = group.data(Field::density);
    const double* rate = group.data(Field::density_rate);
    for_each_owned(group, threads_, [=](std::ptrdiff_t i) { density[i] += dt * rate[i]; });
}

void FluidPasses::update_pressure(ParticleGroup& group) const {
    const double* density = group.data(Field::density);
    const double* mass = group.data(Field::mass);
    double* pressure = group.data(Field::pressure);
    double* volume = group.data(Field::volume);
    if (one_state_) {
        const LiquidState state = state_of_part_.front();
        for_each_owned(group, threads_, [=](std::ptrdiff_t i) {
            pressure[i] = state.pressure(density[i]);
            volume[i] = mass[i] / density[i];
        });
    } else {
        const auto tags = group.tags();
        for_each_owned(group, threads_, [=, this](std::ptrdiff_t i) {
            pressure[i] = state_of_part_[tags[i].part].pressure(density[i]);
            volume[i] = mass[i] / density[i];
        });
    }
}

void FluidPasses::update_pressure(ParticleStore& particles) const {
    for (ParticleGroup& group : particles.groups())
        if (group.has(Field::pressure)) update_pressure(group);
}

double FluidPasses::kick(ParticleGroup& fluid, double dt, const std::array<double, 3>& g) const {
    const auto count = static_cast<std::ptrdiff_t>(fluid.owned());
    const double* mass = fluid.data(Field::mass);
    std::array<double*, 3> v{};
    std::array<const double*, 3> force{};
    for (int axis = 0; axis < fluid.dimension(); ++axis) {
        v[axis] = fluid.data(Field::velocity, axis);
        force[axis] = fluid.data(Field::force, axis);
    }
    const auto pass = [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        double fastest = 0;
#pragma omp parallel for num_threads(threads_) schedule(static) reduction(max : fastest)
        for (std::ptrdiff_t i = 0; i < count; ++i) {
            double square = 0;
            for (int axis = 0; axis < D; ++axis) {
                v[axis][i] += dt * (force[axis][i] / mass[i] + g[axis]);
                square += v[axis][i] * v[axis][i];
            }
            fastest = square <= fastest ? fastest : square < infinity ? square : infinity;  // NaN too
        }
        return fastest;
    };
    return root(fluid.dimension() == 3 ? pass(std::integral_constant<int, 3>{})
                                       : pass(std::integral_constant<int, 2>{}));
}

ExactSum FluidPasses::fourth_powers_of_speeds(const ParticleGroup& fluid, double largest_speed) const {
    const double largest = std::pow(largest_speed, 4);
    if (!(largest < infinity)) {
        ExactSum broken;
        broken.add(infinity);
        return broken;
    }
    std::array<const double*, 3> v{};
    for (int axis = 0; axis < fluid.dimension(); ++axis) v[axis] = fluid.data(Field::velocity, axis);
    const OrderFree rounded(at_least_something(largest));
    const auto add = [&]<int D>() {
        return sums_of_multiples<1>(fluid, threads_, [&](std::ptrdiff_t i, auto& sum) {
            double square = 0;
            for (int axis = 0; axis < D; ++axis) square += v[axis][i] * v[axis][i];
            sum[0] += rounded(square * square);
        });
    };
    return (fluid.dimension() == 3 ? add.operator()<3>() : add.operator()<2>())[0];
}

template <int D>
PassExtremes FluidPasses::drift_and_shift(ParticleStore& particles, double dt, const ShiftStep& shift) const {
    ParticleGroup& fluid = particles.fluid();
    const PositionQuantum quantum = particles.quantum();
    const auto x = axes<D>(fluid, Field::position), v = axes<D>(fluid, Field::velocity);
    const bool shifts = shift.per_sum != 0;
    const auto sum = axes<D>(fluid, shifts ? Field::shift : Field::velocity);
    const double per_sum_square = shift.per_sum * shift.per_sum, longest_square = shift.longest * shift.longest;
    const auto count = static_cast<std::ptrdiff_t>(fluid.owned());
    double farthest = 0;
    if (!shifts) {
#pragma omp parallel for num_threads(threads_) schedule(static)
        for (std::ptrdiff_t i = 0; i < count; ++i)
            for (int axis = 0; axis < D; ++axis) x[axis][i] += quantum.round(dt * v[axis][i]);
    } else {
#pragma omp parallel for num_threads(threads_) schedule(static) reduction(max : farthest)
        for (std::ptrdiff_t i = 0; i < count; ++i) {
            double square = 0;
            for (int axis = 0; axis < D; ++axis) square += sum[axis][i] * sum[axis][i];
            const double length_square = per_sum_square * square;
            const double shortened = length_square > longest_square ? std::sqrt(longest_square / length_square) : 1;
            for (int axis = 0; axis < D; ++axis)
                x[axis][i] += quantum.round(dt * v[axis][i] + shortened * shift.per_sum * sum[axis][i]);
            farthest = std::max(farthest, std::min(length_square, longest_square));
        }
    }
    PassExtremes extremes;
    extremes.longest_shift = std::sqrt(farthest);
    return extremes;
}

PassExtremes FluidPasses::drift_to_end(ParticleStore& particles, double dt, const ShiftStep& shift) const {
    PassExtremes extremes = particles.dimension() == 3 ? drift_and_shift<3>(particles, dt, shift)
                                                       : drift_and_shift<2>(particles, dt, shift);
    for (ParticleGroup& group : particles.groups())
        if (group.has(Field::density_rate) && group.kind() != ParticleKind::fluid) update_density(group, dt);
    ParticleGroup& fluid = particles.fluid();
    double* density = fluid.data(Field::density);
    if (fluid.has(Field::density_rate)) {
        const double* rate = fluid.data(Field::density_rate);
        look_at_densities(
            fluid, [=](std::ptrdiff_t i) { return density[i] += dt * rate[i]; }, extremes);
    } else {
        look_at_densities(
            fluid, [=](std::ptrdiff_t i) { return density[i]; }, extremes);
    }
    return extremes;
}

/// Takes note of the extremes of density_of(i), which may bring the density up to date.
template <class DensityOf>
void FluidPasses::look_at_densities(const ParticleGroup& fluid, const DensityOf& density_of,
                                    PassExtremes& extremes) const {
    const auto count = static_cast<std::ptrdiff_t>(fluid.owned());
    if (count == 0) {
        extremes.density_low = infinity;
        extremes.density_high = -infinity;
    } else if (one_state_) {
        const double rest_density = state_of_part_.front().rest_density;
        const auto [low, high] = low_and_high(count, threads_, density_of);
        extremes.density_low = low / rest_density;
        extremes.density_high = high / rest_density;
    } else {
        const auto relative = [&, tags = fluid.tags()](std::ptrdiff_t i) {
            return density_of(i) / state_of_part_[tags[i].part].rest_density;
        };
        std::tie(extremes.density_low, extremes.density_high) = low_and_high(count, threads_, relative);
    }
}

PassExtremes FluidPasses::extremes(const ParticleGroup& fluid) const {
    const auto count = static_cast<std::ptrdiff_t>(fluid.owned());
    std::array<const double*, 3> v{};
    for (int axis = 0; axis < fluid.dimension(); ++axis) v[axis] = fluid.data(Field::velocity, axis);
    double fastest = 0;
#pragma omp parallel for num_threads(threads_) schedule(static) reduction(max : fastest)
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        double square = 0;
        for (int axis = 0; axis < fluid.dimension(); ++axis) square += v[axis][i] * v[axis][i];
        fastest = square <= fastest ? fastest : square < infinity ? square : infinity;  // NaN too
    }
    PassExtremes extremes;
    extremes.largest_speed = root(fastest);
    look_at_densities(
        fluid, [density = fluid.data(Field::density)](std::ptrdiff_t i) { return density[i]; }, extremes);
    return extremes;
}

}  // namespace dmp
