// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "models/solidify/activity.hpp"
#include "scene/scene.hpp"
#include "solver/solidify/bond_candidates.hpp"
#include "solver/state/archive.hpp"
#include "solver/time/fluid_step.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// One [[solidify]]: who are its seeds, and what happens at its events (docs/solidify.md). Every rank finds the
/// bond candidates of its own fluid, all ranks gather them and make the same random trials, so that all make the same
/// change to the bodies, which all hold.
class Solidification {
  public:
    /// `number` of the rule in the scene. Throws InputError when the particles do not have what the rule needs.
    Solidification(const Scene& scene, int number, const ParticleSet& set, const Ranks& ranks);

    /// Event `event`, counted from 0: turns liquid solid and bonds it. Pressures and neighbours must be up to date.
    void act(std::int64_t event, const ParticleStore& particles, FluidStep& fluid);

    void archive(Archive& file);

  private:
    /// A liquid particle that turns solid, as it is sent between ranks.
    struct SolidifyingParticle {
        std::int64_t id;
        double mass;
        std::array<double, 3> position, velocity;
        double radius;  ///< of the solid that it becomes, half a spacing [m]
    };

    [[nodiscard]] SolidifyingParticle turning(const ParticleStore& particles, std::size_t i, double ahead) const;
    [[nodiscard]] std::vector<SolidifyingParticle> from_all(std::vector<SolidifyingParticle> own) const;
    [[nodiscard]] std::vector<ParticlePosition> acting_seeds(std::int64_t event, const ParticleStore& particles,
                                                             const FluidStep& fluid,
                                                             const std::vector<SolidifyingParticle>& new_seeds) const;
    /// How many more bonds particles may have that have some of this rule.
    [[nodiscard]] std::unordered_map<std::int64_t, int> room(const SpringBodies& springs) const;
    void bond_to_neighbours(BodyChange& change, const std::vector<SolidifyingParticle>& turned,
                            const ParticleStore& particles, const SpringBodies& springs) const;
    void add_node(BodyChange& change, const SolidifyingParticle& turned) const;
    void add_bond(BodyChange& change, const SpringBodies& springs, int a, int b) const;

    const Scene& scene_;
    const Solidify& rule_;
    const Ranks& ranks_;
    ParticleSpace space_;
    int number_, origin_, liquid_part_;
    Activity activity_;
    int most_bonds_;
    struct WallSeed {
        ParticlePosition particle;
        double mass;
    };
    std::map<std::int64_t, WallSeed> walls_;
    std::map<std::int64_t, std::int64_t> since_;  ///< nodes that are seeds: the first event in which they may act
};

}  // namespace dmp::solver
