// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "particles/particle_set.hpp"
#include "solver/domain/regions.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/store/particle_group.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Groups of particles, the same kinds with the same fields in the same order on every rank.
using GroupList = std::vector<ParticleGroup*>;

/// What a particle of each kind costs, compared with the others; above 0.
struct KindWeights {
    double fluid = 1, rigid = 1, springs = 1, spheres = 1;
    [[nodiscard]] double of(PartKind kind) const {
        if (kind == PartKind::spheres) return spheres;
        return kind == PartKind::fluid ? fluid : kind == PartKind::rigid ? rigid : springs;
    }
};

/// Which rank owns which part of space: one box a rank, known to all. Who owns a particle is a question of its position
/// alone. At first all of space is the first rank's.
/// All but owner() and box() must be called by all ranks together. One rank alone calls no MPI.
class Domain {
  public:
    Domain(const Ranks& ranks, const ParticleSpace& space, int threads = 1);

    /// Divides space anew, so that the owned particles of these groups weigh about the same on each rank; migrate()
    /// then brings them there. With hardly more particles than ranks, all may become the first rank's. Positions move
    /// by whole periods into the box. Takes about 1 us a particle, and 100 bytes for as long. Throws as migrate() does,
    /// and ResourceError where Zoltan fails.
    void divide(const GroupList& groups, const KindWeights& weights);

    /// The rank that owns this place; along periodic axes it may lie any number of periods away.
    [[nodiscard]] int owner(const Vec& point) const;
    /// A rank's part of space: infinite outwards where the axis is not periodic and has no plane of symmetry (and along
    /// z in 2-D); low > high if it has none. What lies inside is the rank's; owner() knows about points on a side that
    /// two ranks share.
    [[nodiscard]] const Box& box(int rank) const { return regions_.box(rank); }

    /// Moves every owned particle by whole periods into the box of the space, fluid particles that have passed a plane
    /// of symmetry to where their mirror image is, and all to the rank that owns its place, with its tag and all state
    /// fields. Those that stay keep their order; those that come stand behind them. Copies go. Throws DivergenceError,
    /// on all ranks, if a particle has no place any more (NaN, infinite or far off).
    void migrate(const GroupList& groups) const;

    /// The largest rank's load over the mean: 1 is perfect. 1 without particles.
    [[nodiscard]] double imbalance(const GroupList& groups, const KindWeights& weights) const;

  private:
    void move_into_box(const GroupList& groups) const;
    void mirror_back(ParticleGroup& fluid) const;

    Ranks ranks_;
    int dimension_, threads_;
    std::array<bool, 3> periodic_;
    std::array<std::array<bool, 2>, 3> mirrored_;
    Box space_;  ///< one period, between planes of symmetry, or from -infinity to infinity
    Regions regions_;
};

}  // namespace dmp::solver
