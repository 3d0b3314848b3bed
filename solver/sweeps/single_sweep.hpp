// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/models/sph/continuity.hpp"
#include "solver/models/sph/density_diffusion.hpp"
#include "solver/models/sph/morris_viscosity.hpp"
#include "solver/models/sph/pressure_force.hpp"
#include "solver/models/sph/shifting.hpp"
#include "solver/sweeps/cluster_loop.hpp"
#include "solver/sweeps/order_free.hpp"
#include "solver/sweeps/point_reader.hpp"
#include "solver/sweeps/single_points.hpp"
#include "solver/sweeps/strands.hpp"

namespace dmp {

/// The sums over pairs of fluid particles in mixed precision: the same laws, each pair's term in single precision and
/// in units of the scene (SingleUnits), separations taken and sums kept in double. Lanes L hold the members of a
/// cluster, and if there is room several times, each time with another neighbour.
/// Terms are rounded to whole multiples of 2^-30 of the largest one expected, which leaves those near it as precise as
/// they are, and makes the sums exact: the same bits in any order.
template <class L, int D, class Kernel>
class SingleSweep {
  public:
    SingleSweep(ParticleStore& particles, const ClusterList& list, const SinglePoints& points, const SingleUnits& units,
                const Kernel& kernel, double largest_term, int threads)
        : fluid_(particles.fluid()),
          list_(list),
          points_(points),
          units_(units),
          kernel_(kernel),
          scale_(std::ldexp(1.0, 30 - std::ilogb(largest_term))),
          per_length_(1 / units.length),
          threads_(threads),
          position_(axes_of<D>(fluid_, Field::position)) {
        for (int axis = 0; axis < D; ++axis) velocity_[static_cast<std::size_t>(axis)] = points.velocity(axis);
    }

    /// force [N]; rounded to what the double sums are multiples of.
    void forces(const OrderFree& rounding) {
        const double unit =
            units_.density * units_.sound_speed * units_.sound_speed * std::pow(units_.length, D - 1) / scale_;
        for_each_cluster<width, UnderflowToZero<L>>(list_, ParticleKind::fluid, threads_,
                                                    [&](const Neighbourhood& near) { force_on(near, unit, rounding); });
    }

    /// density_rate [kg/m^3/s] and, if there is shifting, shift [1/m].
    template <bool WithDiffusion, bool WithShifting>
    void density_rates(const DensityDiffusion& diffusion, const Shifting<Kernel>& shifting,
                       const OrderFree& rate_rounding, const OrderFree& shift_rounding) {
        const RateUnits units{units_.density * units_.sound_speed / units_.length / scale_, 1 / units_.length / scale_,
                              rate_rounding, shift_rounding};
        for_each_cluster<width, UnderflowToZero<L>>(
            list_, ParticleKind::fluid, threads_, [&](const Neighbourhood& near) {
                rates_of<WithDiffusion, WithShifting>(near, diffusion, shifting, units);
            });
    }

  private:
    using Lane = Strands<L>;
    using Neighbours = typename Lane::Neighbours;
    static constexpr std::size_t width = Lane::members;
    static_assert(Lane::count <= 2);
    struct RateUnits {
        double rate, shift;
        const OrderFree &rate_rounding, &shift_rounding;
    };
    template <int N>
    using Sums = std::array<WideSum<L>, static_cast<std::size_t>(N)>;
    using Place = std::array<typename Lane::Halves, D>;

    // Flattened: every law becomes part of its loop, whatever the compiler thinks of their size. Constants are copied,
    // and sums stored by the function that makes them: only what nobody else can see stays in registers.
    [[gnu::flatten]] void force_on(const Neighbourhood& near, double unit, const OrderFree& rounding) const {
        const auto i = members(near.cluster);
        const Place place = place_of(near.cluster);
        const Kernel kernel = kernel_;
        Sums<D> sum{};
        for_neighbours(near, [&, scale = scale_, per_length = per_length_](const Neighbours& some) {
            const auto j = neighbours(some);
            const Vector<L, D> separation = separation_from(place, some, per_length);
            const L distance = sqrt(dot(separation, separation));
            const Pair pair{i, j, separation, distance, 1.0};
            const L slope = scale * kernel.slope(distance);
            add(slope * (PressureForce::law(pair) + MorrisViscosity::law(pair)), sum);
        });
        store(sum, unit, rounding, Field::force, near.cluster);
    }

    template <bool WithDiffusion, bool WithShifting>
    [[gnu::flatten]] void rates_of(const Neighbourhood& near, DensityDiffusion diffusion, Shifting<Kernel> shifting,
                                   const RateUnits& units) const {
        const auto i = members(near.cluster);
        const Place place = place_of(near.cluster);
        const Kernel kernel = kernel_;
        Sums<1> rates{};
        Sums<D> shifts{};
        for_neighbours(near, [&, scale = scale_, per_length = per_length_](const Neighbours& some) {
            const auto j = neighbours(some);
            const Vector<L, D> separation = separation_from(place, some, per_length);
            const L distance = sqrt(dot(separation, separation));
            const Pair pair{i, j, separation, distance, 1.0};
            const L slope = scale * kernel.slope(distance);
            Vector<L, 1> rate{ContinuityRate::law(pair)};
            if constexpr (WithDiffusion) rate[0] += diffusion.law(pair);
            add(slope * rate, rates);
            if constexpr (WithShifting) add(slope * shifting.law(pair, kernel), shifts);
        });
        store(rates, units.rate, units.rate_rounding, Field::density_rate, near.cluster);
        if constexpr (WithShifting) store(shifts, units.shift, units.shift_rounding, Field::shift, near.cluster);
    }

    /// Calls visit(neighbours) for as many fluid neighbours at a time as there are strands; nobody fills the last up.
    template <class Visit>
    void for_neighbours(const Neighbourhood& near, const Visit& visit) const {
        const auto listed = near.of(ParticleKind::fluid);
        std::size_t n = 0;
        Neighbours some;
        for (; n + some.size() <= listed.size(); n += some.size()) {
            for (std::size_t k = 0; k < some.size(); ++k) some[k] = listed[n + k];
            visit(some);
        }
        if (n == listed.size()) return;
        // Fewer are left than there are strands.
        some.fill(static_cast<std::int32_t>(points_.size()));
        some[0] = listed[n];
        visit(some);
    }

    [[nodiscard]] FluidPoint<L, D> members(const Cluster& cluster) const {
        return point([&](const float* values) { return Lane::of_members(values + cluster.first); });
    }
    [[nodiscard]] FluidPoint<L, D> neighbours(const Neighbours& some) const {
        return point([&](const float* values) { return Lane::of_neighbours(values, some); });
    }
    /// Without a position: laws take the separation.
    template <class Load>
    [[nodiscard]] FluidPoint<L, D> point(const Load& load) const {
        FluidPoint<L, D> point;
        for (int axis = 0; axis < D; ++axis) point.velocity[axis] = load(velocity_[static_cast<std::size_t>(axis)]);
        point.volume = load(points_.volume());
        point.density = load(points_.density());
        point.pressure = load(points_.pressure());
        point.viscosity = load(points_.viscosity());
        return point;
    }
    [[nodiscard]] Place place_of(const Cluster& cluster) const {
        Place place;
        for (std::size_t axis = 0; axis < D; ++axis) place[axis] = Lane::of_members(position_[axis] + cluster.first);
        return place;
    }
    [[nodiscard]] Vector<L, D> separation_from(const Place& place, const Neighbours& some, double per_length) const {
        Vector<L, D> separation;
        for (std::size_t axis = 0; axis < D; ++axis)
            separation.c[axis] = per_length * Lane::separation(place[axis], position_[axis], some);
        return separation;
    }

    template <int N>
    static void add(const Vector<L, N>& terms, std::array<WideSum<L>, static_cast<std::size_t>(N)>& sum) {
        for (std::size_t axis = 0; axis < N; ++axis) sum[axis] += nearest_whole(terms.c[axis]);
    }
    template <std::size_t N>
    void store(const std::array<WideSum<L>, N>& sum, double unit, const OrderFree& rounding, Field field,
               const Cluster& cluster) const {
        for (std::size_t axis = 0; axis < N; ++axis) {
            double* to = fluid_.data(field, static_cast<int>(axis)) + cluster.first;
            const auto count = static_cast<std::size_t>(cluster.count);
            sum[axis].by_member([&](const auto& sums, std::size_t first) {
                if (first < count)
                    rounding(unit * sums)
                        .store(to + first, std::min(count - first, std::decay_t<decltype(sums)>::width));
            });
        }
    }

    ParticleGroup& fluid_;
    const ClusterList& list_;
    const SinglePoints& points_;
    const SingleUnits& units_;
    const Kernel& kernel_;
    double scale_, per_length_;
    int threads_;
    std::array<const double*, D> position_;
    std::array<const float*, D> velocity_{};
};

}  // namespace dmp
