// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/sweeps/fluid_passes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "models/sph/shifting.hpp"
#include "models/sph/void_closing.hpp"
#include "solver/parallel/largest_square.hpp"
#include "solver/parallel/low_and_high.hpp"
#include "solver/store/sums_over.hpp"
#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Calls visit(i) for the owned particles of a group, several at a time: calls must not depend on each other.
template <class Visit>
void for_each_owned(const ParticleGroup& group, int threads, const Visit& visit) {
    const auto count = static_cast<std::ptrdiff_t>(group.owned());
#pragma omp parallel for simd num_threads(threads) schedule(static)
    for (std::ptrdiff_t i = 0; i < count; ++i) visit(i);
}

template <int D>
std::array<double*, D> axes(ParticleGroup& group, Field field) {
    std::array<double*, D> arrays{};
    for (int axis = 0; axis < D; ++axis) arrays[axis] = group.data(field, axis);
    return arrays;
}

/// True if a quantum exists for the fourth powers of speeds up to this one.
bool can_round(double largest_speed) { return largest_speed > 0 && std::pow(largest_speed, 4) < infinity; }

ReproducibleSum rounding_of_powers(double largest_speed) {
    return ReproducibleSum(at_least_something(std::pow(largest_speed, 4)));
}

/// For so few values the sum is exact (ReproducibleSum).
double sum_of_fourth_powers(const LargestSquare::Squares& squares, const ReproducibleSum& rounded) {
    constexpr std::ptrdiff_t lanes = LargestSquare::lanes;
    std::array<double, lanes> sums{};
    for (std::ptrdiff_t k = 0; k < LargestSquare::at_a_time; k += lanes)
        for (std::ptrdiff_t lane = 0; lane < lanes; ++lane)
            sums[lane] += rounded(squares[k + lane] * squares[k + lane]);
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

/// Root of a largest square, which is infinite if a value was NaN.
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
    drift(particles, dt);
    for (ParticleGroup& group : particles.groups())
        if (group.has(Field::density_rate)) {
            double* density = group.data(Field::density);
            const double* rate = group.data(Field::density_rate);
            update_pressure(group, [=](std::ptrdiff_t i) { return density[i] += dt * rate[i]; });
        }
    update_reduced_pressure(particles.fluid());
}

void FluidPasses::drift(ParticleStore& particles, double dt) const {
    ParticleGroup& fluid = particles.fluid();
    const PositionQuantum& quantum = particles.quantum();
    for (int axis = 0; axis < particles.dimension(); ++axis) {
        double* x = fluid.data(Field::position, axis);
        const double* v = fluid.data(Field::velocity, axis);
        for_each_owned(fluid, threads_, [=](std::ptrdiff_t i) { x[i] += quantum.round(dt * v[i]); });
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

/// Pressure and volume from density_of(i), which may also update the density.
template <class DensityOf>
void FluidPasses::update_pressure(ParticleGroup& group, const DensityOf& density_of) const {
    const double* mass = group.data(Field::mass);
    double* pressure = group.data(Field::pressure);
    double* volume = group.data(Field::volume);
    const auto update = [&](const auto& state_of) {
        for_each_owned(group, threads_, [=](std::ptrdiff_t i) {
            const double density = density_of(i);
            pressure[i] = state_of(i).pressure(density);
            volume[i] = mass[i] / density;
        });
    };
    if (one_state_)
        update([state = state_of_part_.front()](std::ptrdiff_t) { return state; });
    else
        update([tags = group.tags(), this](std::ptrdiff_t i) { return state_of_part_[tags[i].part]; });
}

void FluidPasses::update_pressure(ParticleStore& particles) const {
    for (ParticleGroup& group : particles.groups())
        if (group.has(Field::pressure))
            update_pressure(group, [density = group.data(Field::density)](std::ptrdiff_t i) { return density[i]; });
    update_reduced_pressure(particles.fluid());
}

void FluidPasses::update_reduced_pressure(ParticleGroup& fluid) const {
    if (!fluid.has(Field::reduced_pressure)) return;
    const double* pressure = fluid.data(Field::pressure);
    double* reduced = fluid.data(Field::reduced_pressure);
    std::array<const double*, 3> x{};
    int axes_with_slope = 0;
    std::array<double, 3> slope{}, centre{};
    for (int axis = 0; axis < fluid.dimension(); ++axis) {
        if (reference_.slope[axis] == 0) continue;
        x[axes_with_slope] = fluid.data(Field::position, axis);
        slope[axes_with_slope] = reference_.slope[axis];
        centre[axes_with_slope++] = reference_.centre[axis];
    }
    for_each_owned(fluid, threads_, [=, level = reference_.level](std::ptrdiff_t i) {
        double reference = level;
        for (int k = 0; k < axes_with_slope; ++k) reference += slope[k] * (x[k][i] - centre[k]);
        reduced[i] = pressure[i] - reference;
    });
}

VolumeSums FluidPasses::volume_sums(const ParticleGroup& fluid, double largest_volume, double largest_pressure) const {
    const ReproducibleSum round_volume(largest_volume);
    const ReproducibleSum round_energy(at_least_something(largest_volume * largest_pressure));
    const double *volume = fluid.data(Field::volume), *reduced = fluid.data(Field::reduced_pressure);
    // Squares exceed their expected size sooner.
    const ReproducibleSum round_square(at_least_something(25 * largest_volume * largest_pressure * largest_pressure));
    const double* correction = fluid.data(Field::mean_correction);
    const auto sums = sums_of_multiples<4>(fluid, threads_, [&](std::ptrdiff_t i, auto& sum) {
        sum[0] += round_volume(volume[i]);
        sum[1] += round_energy(volume[i] * reduced[i]);
        sum[2] += round_square(volume[i] * reduced[i] * reduced[i]);
        sum[3] += VoidClosing::is_beside_void(correction[i]) ? 1 : 0;
    });
    return {sums[0], sums[1], sums[2], sums[3]};
}

std::vector<ExactSum> FluidPasses::chamber_volumes(const ParticleGroup& fluid, std::size_t chambers,
                                                   double largest_volume) {
    const ReproducibleSum round_volume(largest_volume);
    const double *volume = fluid.data(Field::volume), *chamber = fluid.data(Field::chamber);
    std::vector<ExactSum> sums(chambers);
    // Few numbers of one chamber at a time, which add up exactly.
    constexpr std::size_t at_a_time = 32;
    for (std::size_t i = 0; i < fluid.owned();) {
        const double own = chamber[i];
        double some = 0;
        for (const std::size_t end = std::min(i + at_a_time, fluid.owned()); i < end && chamber[i] == own; ++i)
            some += round_volume(volume[i]);
        sums[static_cast<std::size_t>(own)].add(some);
    }
    return sums;
}

SpeedSums FluidPasses::kick(ParticleGroup& fluid, double dt, const std::array<double, 3>& g,
                            double expected_speed) const {
    return can_round(expected_speed) ? kick_and_sum<true>(fluid, dt, g, expected_speed)
                                     : kick_and_sum<false>(fluid, dt, g, 0);
}

template <bool sums_powers>
SpeedSums FluidPasses::kick_and_sum(ParticleGroup& fluid, double dt, const std::array<double, 3>& g,
                                    double expected_speed) const {
    const auto count = static_cast<std::ptrdiff_t>(fluid.owned());
    const double* mass = fluid.data(Field::mass);
    const ReproducibleSum rounded = rounding_of_powers(expected_speed);
    SpeedSums sums;
    const auto pass = [&]<int D>() {
        const auto v = axes<D>(fluid, Field::velocity), force = axes<D>(fluid, Field::force);
#pragma omp parallel num_threads(threads_)
        {
            LargestSquare largest;
            ExactSum powers;
#pragma omp for schedule(static) nowait
            for (std::ptrdiff_t begin = 0; begin < count; begin += LargestSquare::at_a_time) {
                const std::ptrdiff_t some = std::min(LargestSquare::at_a_time, count - begin);
                LargestSquare::Squares square{};
                for (int axis = 0; axis < D; ++axis) {
                    double* speed = v[axis] + begin;
                    const double *pushed = force[axis] + begin, *inertia = mass + begin, driven = g[axis];
#pragma omp simd
                    for (std::ptrdiff_t k = 0; k < some; ++k) {
                        speed[k] += dt * (pushed[k] / inertia[k] + driven);
                        square[k] += speed[k] * speed[k];
                    }
                }
                largest.update(square);
                if constexpr (sums_powers) powers.add(sum_of_fourth_powers(square, rounded));
            }
#pragma omp critical(dmp_kick)
            {
                sums.largest = std::max(sums.largest, largest.value());
                sums.fourth_powers.add(powers);
            }
        }
    };
    fluid.dimension() == 3 ? pass.template operator()<3>() : pass.template operator()<2>();
    sums.largest = root(sums.largest);
    return sums;
}

bool FluidPasses::sum_alike(double expected_speed, double largest_speed) {
    return can_round(expected_speed) && can_round(largest_speed) &&
           rounding_of_powers(expected_speed).quantum() == rounding_of_powers(largest_speed).quantum();
}

ExactSum FluidPasses::fourth_powers_of_speeds(const ParticleGroup& fluid, double largest_speed) const {
    if (!can_round(largest_speed)) {
        ExactSum none_or_broken;
        none_or_broken.add(largest_speed == 0 ? 0 : infinity);
        return none_or_broken;
    }
    std::array<const double*, 3> v{};
    for (int axis = 0; axis < fluid.dimension(); ++axis) v[axis] = fluid.data(Field::velocity, axis);
    const ReproducibleSum rounded = rounding_of_powers(largest_speed);
    return sums_of_multiples<1>(fluid, threads_, [&](std::ptrdiff_t i, auto& sum) {
        double square = 0;
        for (int axis = 0; axis < fluid.dimension(); ++axis) square += v[axis][i] * v[axis][i];
        sum[0] += rounded(square * square);
    })[0];
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

template <int D>
FluidPasses::Shifted FluidPasses::shift_and_interpolate(ParticleStore& particles, const ShiftStep& shift,
                                                        double largest_momentum) const {
    ParticleGroup& fluid = particles.fluid();
    const PositionQuantum quantum = particles.quantum();
    const auto x = axes<D>(fluid, Field::position), v = axes<D>(fluid, Field::velocity);
    const auto sum = axes<D>(fluid, Field::shift), g = axes<D>(fluid, Field::next_density_gradient);
    const auto off_walls = axes<D>(fluid, Field::off_walls);
    std::array<const double*, D * D> gradient{};
    for (int k = 0; k < D * D; ++k) gradient[k] = fluid.data(Field::velocity_gradient, k);
    double* density = fluid.data(Field::density);
    const double* mass = fluid.data(Field::mass);
    const ReproducibleSum rounded(at_least_something(largest_momentum));
    const double longest_square = shift.longest * shift.longest;
    const auto count = static_cast<std::ptrdiff_t>(fluid.owned());
    // Sums of so few terms of up to this size are exact. Larger terms, as of fluid at rest beside a body that is set in
    // motion, are added one by one.
    constexpr std::ptrdiff_t at_a_time = 32;
    const double largest_term = 4 * largest_momentum;
    Shifted result;
    double farthest = 0;
#pragma omp parallel num_threads(threads_)
    {
        double farthest_here = 0;
        std::array<ExactSum, 3> momentum_here;
#pragma omp for schedule(static) nowait
        for (std::ptrdiff_t begin = 0; begin < count; begin += at_a_time) {
            std::array<double, D> momentum{};
            for (std::ptrdiff_t i = begin; i < std::min(begin + at_a_time, count); ++i) {
                simd::Vector<double, D> d, normal;
                double square = 0;
                for (int a = 0; a < D; ++a) {
                    d[a] = shift.per_sum * sum[a][i];
                    normal[a] = off_walls[a][i];
                    square += d[a] * d[a];
                }
                const double shortened = square > longest_square ? std::sqrt(longest_square / square) : 1;
                for (int a = 0; a < D; ++a) d[a] *= shortened;
                const auto interpolated = models::interpolated_part(d, normal);
                for (int a = 0; a < D; ++a) {
                    double change = 0;
                    for (int b = 0; b < D; ++b) change += gradient[a * D + b][i] * interpolated[b];
                    x[a][i] += quantum.round(d[a]);
                    v[a][i] += change;
                    density[i] += g[a][i] * interpolated[a];
                    const double term = mass[i] * change;
                    if (std::abs(term) <= largest_term)
                        momentum[a] += rounded(term);
                    else
                        momentum_here[a].add(term);
                }
                farthest_here = std::max(farthest_here, std::min(square, longest_square));
            }
            for (int a = 0; a < D; ++a) momentum_here[a].add(momentum[a]);
        }
#pragma omp critical(dmp_shift)
        {
            farthest = std::max(farthest, farthest_here);
            for (int a = 0; a < D; ++a) result.momentum[a].add(momentum_here[a]);
        }
    }
    result.extremes.longest_shift = std::sqrt(farthest);
    return result;
}

FluidPasses::Shifted FluidPasses::shift(ParticleStore& particles, double dt, const ShiftStep& shift,
                                        double largest_momentum, double density_excess,
                                        std::span<const double> excess_of_chambers) const {
    ParticleGroup& fluid = particles.fluid();
    Shifted shifted;
    if (shift.per_sum != 0)
        shifted = particles.dimension() == 3 ? shift_and_interpolate<3>(particles, shift, largest_momentum)
                                             : shift_and_interpolate<2>(particles, shift, largest_momentum);
    for (int axis = 0; axis < fluid.dimension(); ++axis)
        std::copy_n(fluid.data(Field::next_density_gradient, axis), fluid.owned(),
                    fluid.data(Field::density_gradient, axis));
    double* density = fluid.data(Field::density);
    const double* rate = fluid.data(Field::density_rate);
    if (excess_of_chambers.empty()) {
        const double kept = 1 - density_excess;
        update_density_range(
            fluid, [=](std::ptrdiff_t i) { return density[i] = kept * (density[i] + dt * rate[i]); }, shifted.extremes);
    } else {
        const double* chamber = fluid.data(Field::chamber);
        const auto kept = [=](std::ptrdiff_t i) {
            return 1 - excess_of_chambers[static_cast<std::size_t>(chamber[i])];
        };
        update_density_range(
            fluid, [=](std::ptrdiff_t i) { return density[i] = kept(i) * (density[i] + dt * rate[i]); },
            shifted.extremes);
    }
    return shifted;
}

void FluidPasses::add_to_velocities(ParticleGroup& fluid, const std::array<double, 3>& change) const {
    for (int axis = 0; axis < fluid.dimension(); ++axis) {
        double* v = fluid.data(Field::velocity, axis);
        for_each_owned(fluid, threads_, [=, add = change[axis]](std::ptrdiff_t i) { v[i] += add; });
    }
}

PassExtremes FluidPasses::drift_to_end(ParticleStore& particles, double dt, const ShiftStep& shift) const {
    PassExtremes extremes = particles.dimension() == 3 ? drift_and_shift<3>(particles, dt, shift)
                                                       : drift_and_shift<2>(particles, dt, shift);
    for (ParticleGroup& group : particles.groups())
        if (group.has(Field::density_rate) && group.kind() != PartKind::fluid) update_density(group, dt);
    ParticleGroup& fluid = particles.fluid();
    double* density = fluid.data(Field::density);
    if (fluid.has(Field::density_rate)) {
        const double* rate = fluid.data(Field::density_rate);
        update_density_range(
            fluid, [=](std::ptrdiff_t i) { return density[i] += dt * rate[i]; }, extremes);
    } else {
        update_density_range(
            fluid, [=](std::ptrdiff_t i) { return density[i]; }, extremes);
    }
    return extremes;
}

/// Determines the extremes of density_of(i), which may also update the density.
template <class DensityOf>
void FluidPasses::update_density_range(const ParticleGroup& fluid, const DensityOf& density_of,
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
    update_density_range(
        fluid, [density = fluid.data(Field::density)](std::ptrdiff_t i) { return density[i]; }, extremes);
    return extremes;
}

}  // namespace dmp::solver
