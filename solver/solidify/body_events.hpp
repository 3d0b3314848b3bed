// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "models/elastic/solid_break.hpp"
#include "models/springs/bond_break.hpp"
#include "solver/solidify/solidification.hpp"
#include "solver/state/schedule.hpp"

namespace dmp::solver {

/// What happens to spring bodies between the steps: the scene's [[solidify]] and [[break]], each at its times, in the
/// order of the scene. Scenes without them have none and do nothing.
class BodyEvents {
  public:
    BodyEvents(const Scene& scene, const ParticleSet& set, const Ranks& ranks);

    /// The next time at which something is due [s]; infinite without events. What is looked at in every step is never
    /// waited for.
    [[nodiscard]] double next() const;
    /// All that is due at this time. Returns whether anything was.
    bool act(double time, ParticleStore& particles, FluidStep& fluid);
    /// At this time [s].
    void archive(Archive& file, double time);

  private:
    struct Solidifying {
        std::unique_ptr<Solidification> rule;
        double from, until;  ///< [s]
        Schedule times;
        std::int64_t events = 0;

        [[nodiscard]] double next() const;
    };
    struct Breaks {
        std::string name;
        std::variant<BondBreak, SolidBreak> law;
        int origin;
        bool every_step;
        Schedule times;
    };

    std::vector<Solidifying> solidifying_;
    std::vector<Breaks> breaks_;
};

/// Ids of the ends of a body's bond that breaks now: of those of this origin that are beyond the law's limit the one
/// that is farthest beyond it, of equals the one with the lowest ids. One bond of a body breaks at a time: what is
/// unloaded by that stays whole.
std::optional<std::array<int, 2>> overloaded_bond(const SpringBody& body, const BondBreak& law, int origin);

}  // namespace dmp::solver
