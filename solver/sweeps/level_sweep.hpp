// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/sweeps/cluster_loop.hpp"
#include "solver/sweeps/point_reader.hpp"
#include "solver/sweeps/reference_pressure.hpp"
#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

/// Runs after the force sweep, which sums pressures less the reference P(x): adds what P exerts on elastic solids that
/// border on nothing (Field::whole_pressure), L of a cluster's particles at a time,
///   F_j = SUM_i V_i V_j [P(x_i) + P(x_j)] (1/r dW/dr) (x_i - x_j)   [N], i: fluid,
/// so that the pressure they feel is the whole one. Walls and supports hold what it exerts (Field::level_force has it).
template <class L, int D, class Kernel>
class LevelSweep {
  public:
    LevelSweep(ParticleStore& particles, const ClusterList& list, const Kernel& kernel,
               const ReferencePressure& reference, const ReproducibleSum& rounding, int threads)
        : list_(list),
          kernel_(kernel),
          reference_(reference),
          rounding_(rounding),
          threads_(threads),
          solids_(particles.of(PartKind::elastic)),
          solid_(axes_of<D>(solids_, Field::position)),
          fluid_(axes_of<D>(particles.fluid(), Field::position)),
          solid_volume_(solids_.data(Field::volume)),
          fluid_volume_(particles.fluid().data(Field::volume)),
          share_(solids_.data(Field::whole_pressure)) {
        for (int axis = 0; axis < D; ++axis) slope_[axis] = L(reference.slope[axis]);
    }

    void run(ClusterChoice choice) {
        for_each_cluster<L::width>(list_, PartKind::elastic, choice, threads_, [&](const Neighbourhood& near) {
            const Force added = force_on(near);
            const auto force = load_vector<L, D>(axes_of<D>(solids_, Field::force), near.cluster);
            store<L, D>(force + added, solids_, Field::force, near.cluster);
            store<L, D>(added, solids_, Field::level_force, near.cluster);
        });
    }

  private:
    using Force = Vector<L, D>;

    [[nodiscard, gnu::flatten]] Force force_on(const Neighbourhood& near) const {
        const Force position = load_vector<L, D>(solid_, near.cluster);
        const L volume = load<L>(share_, near.cluster) * load<L>(solid_volume_, near.cluster);
        L twice_here = L(2 * reference_.level);
        for (int axis = 0; axis < D; ++axis)
            twice_here = multiply_add(2.0 * slope_[axis], position[axis] - L(reference_.centre[axis]), twice_here);
        Force sum;
        rounding_.start(sum);
        for (const std::int32_t index : near.of(PartKind::fluid)) {
            Force separation;
            L both = twice_here;
            for (int axis = 0; axis < D; ++axis) {
                separation[axis] = L(fluid_[axis][index]) - position[axis];
                both = multiply_add(slope_[axis], separation[axis], both);
            }
            const L distance = sqrt(dot(separation, separation));
            ReproducibleSum::add(sum, kernel_.slope(distance), (L(fluid_volume_[index]) * volume * both) * separation);
        }
        return rounding_.total(sum);
    }

    const ClusterList& list_;
    const Kernel& kernel_;
    ReferencePressure reference_;
    const ReproducibleSum& rounding_;
    int threads_;
    ParticleGroup& solids_;
    std::array<const double*, D> solid_, fluid_;
    const double *solid_volume_, *fluid_volume_, *share_;
    Force slope_;
};

}  // namespace dmp::solver
