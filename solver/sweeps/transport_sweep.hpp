// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/sph/transport_velocity.hpp"
#include "solver/sweeps/cluster_loop.hpp"
#include "solver/sweeps/point_reader.hpp"
#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

/// Runs after the force sweep: adds the forces due to the transport velocity to those of the fluid and stores the sum
/// that spreads the particles in Field::shift, L of a cluster's particles at a time.
template <class L, int D, class Kernel>
class TransportSweep {
  public:
    TransportSweep(ParticleStore& particles, const ClusterList& list, const Kernel& kernel,
                   const ReproducibleSum& force, const ReproducibleSum& spreading, int threads)
        : particles_(particles),
          list_(list),
          kernel_(kernel),
          force_rounding_(force),
          spreading_rounding_(spreading),
          threads_(threads),
          fluid_(particles.fluid()),
          transport_(axes_of<D>(particles.fluid(), Field::transport_velocity)) {}

    void run(ClusterChoice choice) {
        ParticleGroup& group = particles_.fluid();
        for_each_cluster<L::width>(list_, PartKind::fluid, choice, threads_, [&](const Neighbourhood& near) {
            const Sum sum = around_fluid(near);
            const auto force = load_vector<L, D>(axes_of<D>(group, Field::force), near.cluster);
            store<L, D>(force + sum.force, group, Field::force, near.cluster);
            store<L, D>(sum.spreading, group, Field::shift, near.cluster);
        });
    }

  private:
    struct Sum {
        Vector<L, D> force, spreading;
    };

    [[nodiscard, gnu::flatten]] Sum around_fluid(const Neighbourhood& near) const {
        const auto i = fluid_(near.cluster);
        const auto of_i = load_vector<L, D>(transport_, near.cluster);
        Sum sum{Vector<L, D>::zero(), Vector<L, D>::zero()};
        for (const std::int32_t index : near.of(PartKind::fluid)) {
            const auto j = fluid_(index);
            const auto separation = i.position - j.position;
            const L distance = sqrt(dot(separation, separation));
            const L slope = kernel_.slope(distance);
            const Pair pair{i, j, separation, distance, 1.0};
            sum.force += force_rounding_(slope * TransportVelocity::law(pair, i, of_i));
            sum.force += force_rounding_(slope * TransportVelocity::law(pair, j, load_vector<L, D>(transport_, index)));
            sum.spreading += spreading_rounding_(slope * TransportVelocity::spreading(pair));
        }
        for (const PartKind kind : {PartKind::rigid, PartKind::elastic}) {
            const SolidReader<L, D, false, false> solid(particles_.of(kind));
            for (const std::int32_t index : near.of(kind)) {
                const auto j = solid(index);
                const auto separation = i.position - j.position;
                const L distance = sqrt(dot(separation, separation));
                const Pair pair{i, j, separation, distance, 1.0};
                sum.spreading += spreading_rounding_(kernel_.slope(distance) * TransportVelocity::spreading(pair));
            }
        }
        return sum;
    }

    ParticleStore& particles_;
    const ClusterList& list_;
    const Kernel& kernel_;
    const ReproducibleSum& force_rounding_;
    const ReproducibleSum& spreading_rounding_;
    int threads_;
    FluidReader<L, D> fluid_;
    std::array<const double*, D> transport_;
};

}  // namespace dmp::solver
