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

/// Groups of particles; every rank has the same kinds with the same fields in the same order.
using GroupList = std::vector<ParticleGroup*>;

/// Computing cost of a particle of each kind relative to the others; must be positive.
struct KindWeights {
    double fluid = 1, rigid = 1, springs = 1, spheres = 1;
    [[nodiscard]] double of(PartKind kind) const {
        if (kind == PartKind::spheres) return spheres;
        return kind == PartKind::fluid ? fluid : kind == PartKind::rigid ? rigid : springs;
    }
};

/// Domain decomposition: one box per rank, known to all ranks. The owner of a particle depends on its position alone.
/// Initially rank 0 owns all of space.
/// All functions except owner() and box() must be called by all ranks together. On one rank no MPI is called.
class Domain {
  public:
    Domain(const Ranks& ranks, const ParticleSpace& space, int threads = 1);

    /// Divides space again, such that the owned particles of these groups weigh about the same on each rank;
    /// migrate() then moves them to their ranks. With hardly more particles than ranks, rank 0 may get all of them.
    /// Positions are moved into the box by whole periods. Takes about 1 us and temporarily 100 bytes per particle.
    /// Throws as migrate() does, and ResourceError if Zoltan fails.
    void divide(const GroupList& groups, const KindWeights& weights);

    /// The rank that owns this point; along periodic axes the point may be any number of periods away.
    [[nodiscard]] int owner(const Vec& point) const;
    /// A rank's part of space. It extends to infinity where the axis is neither periodic nor ends at a plane of
    /// symmetry (and along z in 2-D); low > high if the rank has none. Points inside belong to the rank; for points
    /// on a side that two ranks share, owner() decides.
    [[nodiscard]] const Box& box(int rank) const { return regions_.box(rank); }

    /// Moves every owned particle into the box of the space by whole periods, replaces fluid particles that have
    /// crossed a plane of symmetry by their mirror image, and sends all particles to the rank that owns their
    /// position, with their tags and all state fields. Particles that stay keep their order; arriving particles are
    /// appended. Ghost particles are dropped. Throws DivergenceError on all ranks if the position of a particle is
    /// NaN, infinite or too far away.
    void migrate(const GroupList& groups) const;

    /// The largest load of a rank divided by the mean: 1 is perfect. 1 without particles.
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
