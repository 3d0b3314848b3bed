// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/transport/species_diffusion.hpp"
#include "solver/sweeps/cluster_loop.hpp"
#include "solver/sweeps/pair_sweeps.hpp"
#include "solver/sweeps/point_reader.hpp"
#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

/// Reads particles in the form used by the diffusion of a species.
template <class L, int D, PartKind kind>
class SpeciesReader {
  public:
    SpeciesReader(const ParticleGroup& group, const SpeciesSums& sums)
        : position_(axes_of<D>(group, Field::position)),
          normal_(axes_of<D>(group, Field::wall_normal)),
          volume_(group.data(Field::volume)),
          concentration_(group.data(sums.values, sums.array_of_values)),
          diffusivity_(if_there(group, Field::species_diffusivity, sums.species)),
          depth_(group.data(Field::wall_distance)),
          wall_(if_there(group, Field::species_wall, sums.species)) {}

    template <class Index>
    [[nodiscard]] auto operator()(const Index& at) const {
        return read(at, load<L>(diffusivity_, at));
    }
    /// The same if all have one diffusivity.
    template <class Index>
    [[nodiscard]] auto with(double diffusivity, const Index& at) const {
        using T = decltype(load<L>(volume_, at));
        return read(at, T(diffusivity));
    }

  private:
    static const double* if_there(const ParticleGroup& group, Field field, int array) {
        return group.has(field) ? group.data(field, array) : nullptr;
    }
    template <class Index, class T>
    [[nodiscard]] auto read(const Index& at, const T& diffusivity) const {
        const SpeciesPoint<T, D> point{load_vector<L, D>(position_, at), load<L>(volume_, at),
                                       load<L>(concentration_, at), diffusivity};
        if constexpr (kind == PartKind::rigid) {
            using std::max;
            const T wall = load<L>(wall_, at);
            return SpeciesWallPoint<T, D>{point, load_vector<L, D>(normal_, at), load<L>(depth_, at), max(wall, T(0.0)),
                                          max(-wall, T(0.0))};
        } else if constexpr (kind == PartKind::elastic) {
            return SpeciesBodyPoint<T, D>{point, load<L>(wall_, at)};
        } else {
            return point;
        }
    }

    std::array<const double*, D> position_, normal_;
    const double *volume_, *concentration_, *diffusivity_, *depth_, *wall_;
};

/// The amounts that the particles carrying a species receive from their neighbours, L of a cluster's particles at a
/// time; also for walls held at a concentration. `Alike`: all fluid particles have one diffusivity, which is not
/// read.
template <class L, int D, class Kernel, bool Alike>
class SpeciesSweep {
  public:
    SpeciesSweep(ParticleStore& particles, const SpeciesPairs& pairs, const Kernel& kernel, const SpeciesSums& sums,
                 const SpeciesDiffusion& diffusion, int threads)
        : particles_(particles),
          pairs_(pairs),
          kernel_(kernel),
          sums_(sums),
          diffusion_(diffusion),
          rounding_(sums.largest_term),
          threads_(threads) {}

    void run() {
        run_kind<PartKind::fluid>();
        if (sums_.with_rigid) run_kind<PartKind::rigid>();
        if (sums_.with_elastic) run_kind<PartKind::elastic>();
    }

  private:
    template <PartKind own>
    void run_kind() {
        double* result = particles_.of(own).data(sums_.result, sums_.array_of_result);
        for_each_cluster<L::width>(pairs_.meeting, own, ClusterChoice::all, threads_, [&](const Neighbourhood& near) {
            L sum = from<own, PartKind::fluid>(near, near.of(PartKind::fluid));
            if (sums_.with_rigid) sum += from<own, PartKind::rigid>(near, of<own, PartKind::rigid>(near));
            if (sums_.with_elastic) {
                sum += from<own, PartKind::elastic>(near, near.of(PartKind::elastic));
                if constexpr (own == PartKind::elastic) sum += from<own, own>(near, within<own>(near));
            }
            double* to = result + near.cluster.first;
            (sums_.adds ? L::load(to) + sum : sum).store(to, static_cast<std::size_t>(near.cluster.count));
        });
    }

    template <PartKind own, PartKind other>
    [[nodiscard]] std::span<const std::int32_t> of(const Neighbourhood& near) const {
        if constexpr (own == PartKind::rigid && other == own)
            return within<own>(near);
        else
            return near.of(other);
    }
    /// Neighbours in the cluster's own solid.
    template <PartKind own>
    [[nodiscard]] std::span<const std::int32_t> within(const Neighbourhood& near) const {
        if (pairs_.within_solids == nullptr) return {};
        return pairs_.within_solids->neighbours(own, near.number, own);
    }

    template <PartKind kind, class Index>
    [[nodiscard]] auto read(const SpeciesReader<L, D, kind>& reader, const Index& at) const {
        if constexpr (Alike && kind == PartKind::fluid)
            return reader.with(sums_.diffusivity, at);
        else
            return reader(at);
    }

    // Flattened: inlines the law into the loop, regardless of its size.
    template <PartKind own, PartKind other>
    [[nodiscard, gnu::flatten]] L from(const Neighbourhood& near, std::span<const std::int32_t> others) const {
        L sum = 0.0;
        if (others.empty()) return sum;
        const SpeciesReader<L, D, own> own_reader(particles_.of(own), sums_);
        const SpeciesReader<L, D, other> reader(particles_.of(other), sums_);
        const auto i = read<own>(own_reader, near.cluster);
        if (sums_.of == SpeciesSums::Of::conductances) {
            for (const std::int32_t index : others) sum += conductance(i, read<other>(reader, index));
            return sum;
        }
        if constexpr (own == PartKind::fluid && other == own) {
            if (sums_.shift_per_sum != 0) return with_shift(near, i, others, reader);
        }
        for (const std::int32_t index : others) {
            const auto j = read<other>(reader, index);
            const auto separation = i.position - j.position;
            const L slope = kernel_.slope(sqrt(dot(separation, separation)));
            sum += rounding_(slope * (sums_.time * taken<own, other>(i, j)));
        }
        return sum;
    }

    /// Between fluid particles that will be shifted.
    template <class I>
    [[nodiscard]] L with_shift(const Neighbourhood& near, const I& i, std::span<const std::int32_t> others,
                               const SpeciesReader<L, D, PartKind::fluid>& reader) const {
        const Vector<L, D> shift =
            sums_.displacement(load_vector<L, D>(axes_of<D>(particles_.fluid(), Field::shift), near.cluster));
        L sum = 0.0;
        for (const std::int32_t index : others) {
            const auto j = read<PartKind::fluid>(reader, index);
            const auto separation = i.position - j.position;
            const L slope = kernel_.slope(sqrt(dot(separation, separation)));
            sum += rounding_(slope * diffusion_.law_with_shift(i, j, sums_.time, shift));
        }
        return sum;
    }

    template <PartKind own, PartKind other, class I, class J>
    [[nodiscard]] auto taken(const I& i, const J& j) const {
        if constexpr (Alike && own == PartKind::fluid && other == own)
            return (i.volume * j.volume) * (2 * sums_.diffusivity) * (i.concentration - j.concentration);
        else
            return diffusion_.law(i, j);
    }

    /// The neighbours of a cluster include its own members.
    template <class I, class J>
    [[nodiscard]] L conductance(const I& i, const J& j) const {
        const auto separation = i.position - j.position;
        const L square = dot(separation, separation);
        const L term = kernel_.slope(sqrt(square)) * (sums_.time * diffusion_.conductance(i, j));
        return rounding_(where_less(L(0.0), square, -term, L(0.0)));
    }

    ParticleStore& particles_;
    const SpeciesPairs& pairs_;
    const Kernel& kernel_;
    const SpeciesSums& sums_;
    const SpeciesDiffusion& diffusion_;
    ReproducibleSum rounding_;
    int threads_;
};

}  // namespace dmp::solver
