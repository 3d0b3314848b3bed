// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <omp.h>

#include "solver/neighbours/cluster_list.hpp"
#include "solver/sweeps/point_reader.hpp"

namespace dmp::solver {

/// Prunes a neighbour list: keeps the entries within `reach` of a member of their cluster as neighbours, L members at
/// a time.
template <class L, int D>
class PruneSweep {
  public:
    PruneSweep(const ParticleStore& particles, ClusterList& list, double reach, int threads)
        : particles_(particles), list_(list), reach_square_(reach * reach), threads_(threads) {}

    void run() {
        for (const PartKind own : all_kinds) {
            const auto count = static_cast<std::ptrdiff_t>(list_.clusters(own).size());
#pragma omp parallel for num_threads(threads_) schedule(static)
            for (std::ptrdiff_t c = 0; c < count; ++c) search_around(own, static_cast<std::size_t>(c));
        }
    }

  private:
    static constexpr std::size_t parts = (cluster_size + L::width - 1) / L::width;
    using Positions = std::array<Vector<L, D>, parts>;

    void search_around(PartKind own, std::size_t number) {
        const Positions members = members_of(particles_.of(own), list_.clusters(own)[number]);
        for (const PartKind other : all_kinds) {
            const auto positions = axes_of<D>(particles_.of(other), Field::position);
            list_.prune(
                own, number, other,
                [&](std::int32_t index) { return is_near(members, load_vector<L, D>(positions, index)); },
                omp_get_thread_num());
        }
    }

    /// Lanes without a member repeat the first one.
    static Positions members_of(const ParticleGroup& group, const Cluster& cluster) {
        Positions members;
        for (int axis = 0; axis < D; ++axis) {
            const double* x = group.data(Field::position, axis) + cluster.first;
            for (std::size_t k = 0; k < parts * L::width; ++k)
                members[k / L::width][axis].set(k % L::width, x[k < static_cast<std::size_t>(cluster.count) ? k : 0]);
        }
        return members;
    }

    [[nodiscard]] NearHalves is_near(const Positions& members, const Vector<double, D>& position) const {
        std::array<bool, 2> near{};
        for (std::size_t part = 0; part < parts; ++part) {
            const auto separation = members[part] - position;
            near[2 * part / parts] |= any_less(dot(separation, separation), L(reach_square_));
        }
        return {near[0], parts == 1 ? near[0] : near[1]};
    }

    const ParticleStore& particles_;
    ClusterList& list_;
    double reach_square_;
    int threads_;
};

}  // namespace dmp::solver
