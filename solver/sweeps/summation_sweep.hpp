// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "models/sph/summation_density.hpp"
#include "solver/sweeps/cluster_loop.hpp"
#include "solver/sweeps/point_reader.hpp"
#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

/// Sets the fluid's density to the sum over neighbours (models/sph/summation_density.hpp), L of a cluster's particles
/// at a time. Particles contribute by mass, so that the densities of neighbours are not needed.
template <class L, int D, class Kernel>
class SummationSweep {
  public:
    /// `rest_density` by part number [kg/m^3].
    SummationSweep(ParticleStore& particles, const ClusterList& list, const Kernel& kernel,
                   const ReproducibleSum& rounding, std::span<const double> rest_density, int threads)
        : particles_(particles),
          list_(list),
          kernel_(kernel),
          rounding_(rounding),
          rest_density_(rest_density),
          threads_(threads) {}

    void run(ClusterChoice choice) {
        ParticleGroup& fluid = particles_.fluid();
        for_each_cluster<L::width>(list_, PartKind::fluid, choice, threads_, [&](const Neighbourhood& near) {
            density_of(near).store(fluid.data(Field::density) + near.cluster.first,
                                   static_cast<std::size_t>(near.cluster.count));
        });
    }

  private:
    [[nodiscard, gnu::flatten]] L density_of(const Neighbourhood& near) const {
        const auto tags = particles_.fluid().tags();
        L rest = 0.0;
        for (std::int32_t k = 0; k < near.cluster.count; ++k)
            rest.set(static_cast<std::size_t>(k), rest_density_[tags[near.cluster.first + k].part]);
        return sum(near, PartKind::fluid, Field::mass, L(1.0)) + sum(near, PartKind::rigid, Field::volume, rest) +
               sum(near, PartKind::elastic, Field::volume, rest);
    }

    /// SUM factor_i weight_j W_ij, including the particle itself if it is of this kind.
    [[nodiscard]] L sum(const Neighbourhood& near, PartKind kind, Field weights, const L& factor) const {
        const auto position = load_vector<L, D>(axes_of<D>(particles_.fluid(), Field::position), near.cluster);
        const auto others = axes_of<D>(particles_.of(kind), Field::position);
        const double* weight = particles_.of(kind).data(weights);
        L density = 0.0;
        for (const std::int32_t index : near.of(kind)) {
            const auto separation = position - load_vector<L, D>(others, index);
            density += rounding_(
                SummationDensity::law(factor * weight[index], kernel_.value(sqrt(dot(separation, separation)))));
        }
        return density;
    }

    ParticleStore& particles_;
    const ClusterList& list_;
    const Kernel& kernel_;
    const ReproducibleSum& rounding_;
    std::span<const double> rest_density_;
    int threads_;
};

}  // namespace dmp::solver
