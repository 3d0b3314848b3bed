// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/models/sph/continuity.hpp"
#include "solver/models/sph/density_diffusion.hpp"
#include "solver/models/sph/shifting.hpp"
#include "solver/sweeps/point_reader.hpp"

namespace dmp {

/// Sums the density rate and the shifting vector over the neighbours of each cluster.
template <int D, class Kernel, bool WithDiffusion, bool WithShifting>
class DensitySweep {
  public:
    DensitySweep(ParticleStore& particles, const ClusterList& list, const Kernel& kernel,
                 const DensityDiffusion& diffusion, const Shifting<Kernel>& shifting, double solid_weight, int threads)
        : particles_(particles),
          list_(list),
          kernel_(kernel),
          diffusion_(diffusion),
          shifting_(shifting),
          solid_weight_(solid_weight),
          threads_(threads),
          read_(particles) {}

    void fluid() {
        sweep(ParticleKind::fluid, [this](const Cluster& cluster) {
            const auto i = read_.fluid(cluster);
            Sum sum{0.0, Vector<Lanes, D>::zero()};
            for (const int index : list_.neighbours(cluster, ParticleKind::fluid))
                add<true>(i, read_.fluid(index), sum);
            for (const ParticleKind kind : {ParticleKind::rigid, ParticleKind::springs})
                for (const int index : list_.neighbours(cluster, kind))
                    add<false>(i, read_.template solid<false>(index), sum);
            if constexpr (WithShifting) store<D>(sum.shift, particles_, Field::shift, cluster);
            return sum.rate;
        });
    }

    /// Plain walls carry a density that the fluid's motion changes.
    void solids() {
        for (const ParticleKind kind : {ParticleKind::rigid, ParticleKind::springs})
            sweep(kind, [this](const Cluster& cluster) {
                const auto i = read_.template solid<false>(cluster);
                Lanes rate = 0.0;
                for (const int index : list_.neighbours(cluster, ParticleKind::fluid)) {
                    const auto j = read_.fluid(index);
                    rate += ContinuityRate::law(pair(i, j));
                }
                return rate;
            });
    }

  private:
    struct Sum {
        Lanes rate;
        Vector<Lanes, D> shift;
    };

    template <class RateOf>
    void sweep(ParticleKind kind, const RateOf& rate_of) {
        const auto clusters = list_.clusters(kind);
        const auto count = static_cast<std::ptrdiff_t>(clusters.size());
        double* density_rate = particles_.data(Field::density_rate);
#pragma omp parallel for num_threads(threads_) schedule(static)
        for (std::ptrdiff_t c = 0; c < count; ++c)
            rate_of(clusters[c]).scatter(density_rate, clusters[c].member.data(), clusters[c].count);
    }

    template <class I, class J>
    auto pair(const I& i, const J& j) const {
        const auto separation = i.position - j.position;
        const Lanes distance = sqrt(dot(separation, separation));
        return Pair{i, j, separation, distance, kernel_.slope(distance)};
    }

    template <bool BothFluid, class I, class J>
    void add(const I& i, const J& j, Sum& sum) const {
        const auto p = pair(i, j);
        const auto rate = ContinuityRate::law(p);
        sum.rate += BothFluid ? rate : solid_weight_ * rate;
        if constexpr (BothFluid && WithDiffusion) sum.rate += diffusion_.law(p);
        if constexpr (WithShifting) sum.shift += shifting_.law(p, kernel_);
    }

    ParticleStore& particles_;
    const ClusterList& list_;
    const Kernel& kernel_;
    const DensityDiffusion& diffusion_;
    const Shifting<Kernel>& shifting_;
    double solid_weight_;  ///< what a solid's approach counts: see ExtrapolatedSolid::approach_weight
    int threads_;
    PointReader<D> read_;
};

}  // namespace dmp
