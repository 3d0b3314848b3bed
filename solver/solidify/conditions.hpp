// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/time/fluid_step.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The box of a region that a [[solidify]] names.
class SolidifyRegion {
  public:
    /// Everywhere where no region is named.
    SolidifyRegion(const Scene& scene, const Value<std::string>& name, const ParticleSpace& space);
    [[nodiscard]] bool contains(const Vec& position) const;
    /// Number of the region in the scene; 0 where none is named.
    [[nodiscard]] int number() const { return number_; }

  private:
    const ParticleSpace& space_;
    bool everywhere_;
    int number_ = 0;
    const ResidenceRegion* region_ = nullptr;  ///< null: everywhere
};

/// Which of this rank's liquid particles a [[solidify]] may turn solid now, and which become seeds. Works out shear
/// stresses, for which all ranks must come together, only where they are asked for.
class SolidifyConditions {
  public:
    SolidifyConditions(const Scene& scene, const Solidify& rule, int liquid_part, const ParticleStore& particles,
                       const FluidStep& fluid);

    /// Whether particle i of the liquid's group is of the rule's liquid.
    [[nodiscard]] bool is_liquid(std::size_t i) const {
        return static_cast<int>(particles_.fluid().tags()[i].part) == liquid_part_;
    }
    /// In event `event`, of what is liquid.
    [[nodiscard]] bool becomes_seed(std::size_t i, std::int64_t event) const;
    /// Near a seed.
    [[nodiscard]] bool may_turn(std::size_t i) const;

  private:
    [[nodiscard]] bool fulfils(std::size_t i, const SolidifyRegion& region, double stress, double residence) const;

    const Solidify& rule_;
    int liquid_part_;
    const ParticleStore& particles_;
    SolidifyRegion seed_region_, region_;
    std::vector<double> stress_;  ///< shear stress of this rank's liquid, where it is asked for [Pa]
};

}  // namespace dmp::solver
