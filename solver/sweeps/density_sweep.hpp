// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/sph/continuity.hpp"
#include "models/sph/density_diffusion.hpp"
#include "models/sph/shifting.hpp"
#include "solver/sweeps/cluster_loop.hpp"
#include "solver/sweeps/point_reader.hpp"
#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

/// Rounding of the sums of a density sweep.
struct DensityRounding {
    ReproducibleSum rate, shift, divergence;
};

/// For sweeps without species.
struct NoSpecies {
    struct Sum {};
    static Sum around(const Cluster& /*any*/) { return {}; }
};

/// Terms of a density sweep. `hydrostatic`: with the hydrostatic correction, for a body force or a free surface (see
/// HydrostaticDiffusion and Shifting). `species`: with fused diffusion of a species.
struct DensityTerms {
    bool rate = true, diffusion = false, shifting = false, hydrostatic = false, species = false;
};

/// Sums the density rate and the shifting vector over the neighbours of each cluster, L of its particles at a time.
/// `Species` is FusedDiffusion, or NoSpecies.
template <class L, int D, class Kernel, class Solid, DensityTerms with, class Species>
class DensitySweep {
  public:
    DensitySweep(ParticleStore& particles, const ClusterList& list, const Kernel& kernel,
                 const DensityDiffusion& diffusion, const HydrostaticDiffusion<D>& hydrostatic,
                 const Shifting<Kernel>& shifting, const DensityRounding& rounding, const Species& species, int threads)
        : particles_(particles),
          list_(list),
          kernel_(kernel),
          diffusion_(diffusion),
          hydrostatic_(hydrostatic),
          shifting_(shifting),
          rounding_(rounding),
          species_(species),
          threads_(threads),
          fluid_(particles.fluid()),
          rigid_(particles.of(PartKind::rigid)),
          springs_(particles.of(PartKind::elastic)) {}

    void run(ClusterChoice choice) {
        fluid(choice);
        if constexpr (with.rate && Solid::needs_state) {  // the density of these walls changes with the fluid's motion
            solids(PartKind::rigid, choice, rigid_);
            solids(PartKind::elastic, choice, springs_);
        }
    }

  private:
    struct Sum {
        L rate;
        Vector<L, D> shift;
        L divergence;
        typename Species::Sum species;
    };

    void fluid(ClusterChoice choice) {
        ParticleGroup& group = particles_.fluid();
        for_each_cluster<L::width>(list_, PartKind::fluid, choice, threads_, [&](const Neighbourhood& near) {
            const Sum sum = around_fluid(near);
            if constexpr (with.shifting) store<L, D>(sum.shift, group, Field::shift, near.cluster);
            if constexpr (with.rate) store_rate(sum.rate, group, near.cluster);
            if constexpr (with.species) species_.store(sum.species, sum.shift, near.cluster);
        });
    }

    template <class Reader>
    void solids(PartKind kind, ClusterChoice choice, const Reader& read) {
        for_each_cluster<L::width>(list_, kind, choice, threads_, [&](const Neighbourhood& near) {
            store_rate(rate_of_solid(near, read), particles_.of(kind), near.cluster);
        });
    }

    // Flattened: inlines every law into the loop, regardless of size.
    [[nodiscard, gnu::flatten]] Sum around_fluid(const Neighbourhood& near) const {
        const auto i = fluid_(near.cluster);
        Sum sum{0.0, Vector<L, D>::zero(), 0.0, species_.around(near.cluster)};
        for (const std::int32_t index : near.of(PartKind::fluid)) add<true>(i, fluid_(index), sum, index);
        for (const std::int32_t index : near.of(PartKind::rigid)) {
            if constexpr (Solid::needs_motion) {
                const auto wall = rigid_(index);
                add<false>(i, Solid::approached(i, wall), sum);
            } else {
                add<false>(i, rigid_(index), sum);
            }
        }
        for (const std::int32_t index : near.of(PartKind::elastic)) add<false>(i, springs_(index), sum);
        if constexpr (with.shifting && with.hydrostatic)
            sum.shift = Shifting<Kernel>::template kept<D>(sum.divergence) * sum.shift;
        return sum;
    }

    template <class Reader>
    [[nodiscard, gnu::flatten]] L rate_of_solid(const Neighbourhood& near, const Reader& read) const {
        const auto i = read(near.cluster);
        L rate = 0.0;
        for (const std::int32_t index : near.of(PartKind::fluid)) {
            const auto j = fluid_(index);
            const auto separation = i.position - j.position;
            const L distance = sqrt(dot(separation, separation));
            rate +=
                rounding_.rate(kernel_.slope(distance) * ContinuityRate::law(Pair{i, j, separation, distance, 1.0}));
        }
        return rate;
    }

    static void store_rate(const L& rate, ParticleGroup& group, const Cluster& cluster) {
        rate.store(group.data(Field::density_rate) + cluster.first, static_cast<std::size_t>(cluster.count));
    }

    template <bool BothFluid, class I, class J>
    void add(const I& i, const J& j, Sum& sum, [[maybe_unused]] std::int32_t index = -1) const {
        const auto separation = i.position - j.position;
        const L distance = sqrt(dot(separation, separation));
        const L slope = kernel_.slope(distance);
        const Pair pair{i, j, separation, distance, 1.0};
        if constexpr (with.rate) {
            L rate = ContinuityRate::law(pair);
            if constexpr (!BothFluid) rate = Solid::approach_weight * rate;
            if constexpr (BothFluid && with.diffusion && with.hydrostatic) rate += hydrostatic_.law(pair);
            if constexpr (BothFluid && with.diffusion && !with.hydrostatic) rate += diffusion_.law(pair);
            sum.rate += rounding_.rate(slope * rate);
        }
        if constexpr (with.shifting) sum.shift += rounding_.shift(slope * shifting_.law(pair, kernel_));
        if constexpr (with.shifting && with.hydrostatic)
            sum.divergence += rounding_.divergence(slope * Shifting<Kernel>::divergence(pair));
        if constexpr (BothFluid && with.species)
            species_.add(i.volume * j.volume, index, separation, slope, sum.species);
    }

    ParticleStore& particles_;
    const ClusterList& list_;
    const Kernel& kernel_;
    const DensityDiffusion& diffusion_;
    const HydrostaticDiffusion<D>& hydrostatic_;
    const Shifting<Kernel>& shifting_;
    const DensityRounding& rounding_;
    const Species& species_;
    int threads_;
    FluidReader<L, D> fluid_;
    SolidReader<L, D, Solid::needs_state, Solid::needs_motion, Solid::needs_motion> rigid_;
    SolidReader<L, D, Solid::needs_state, false> springs_;
};

}  // namespace dmp::solver
