// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/results/plan.hpp"
#include "solver/results/run_summary.hpp"
#include "solver/state/archive.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The largest strains that the bonds, or the cells, of each elastic solid reach. A bond's force is linear in its
/// length, so a solid has the modulus that its scene gives only while strains are small (docs/elastic.md, "Large
/// strains"). Above 20 % an elastic part is warned of, unless a [[break]] says what its bonds withstand.
class SpringStrain {
  public:
    explicit SpringStrain(const SpringBodies& springs);

    /// Whether the state after this step is one of those to look at.
    [[nodiscard]] static bool wants(std::int64_t step) { return step % 10 == 0; }
    /// Looks at all bonds. Returns the warnings that it is the first to raise. Every rank holds all bodies.
    std::vector<Warning> add(const SpringBodies& springs, const Scene& scene);

    /// Of solids whose bonds were strained.
    [[nodiscard]] std::vector<LargestStrain> largest() const;
    [[nodiscard]] std::vector<Warning> warnings(const Scene& scene) const;

    void archive(Archive& file);

  private:
    std::vector<LargestStrain> largest_;  ///< by number in SpringBodies::names
};

}  // namespace dmp::solver
