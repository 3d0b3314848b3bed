// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/monitor/concentration_monitor.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/number_text.hpp"
#include "scene/step_margins.hpp"

namespace dmp::solver {

namespace {

constexpr double too_much = 10;  ///< times the largest amount that a particle is expected to hold
constexpr double seen = 0.05;    ///< overshoot that is warned of

}  // namespace

std::string ConcentrationMonitor::check(const ParticleStore& particles, const SpeciesTransport& species) {
    const ParticleGroup& fluid = particles.fluid();
    for (std::size_t s = 0; s < species.count(); ++s) {
        const CarriedSpecies& carried = species.carried(s);
        for (std::size_t i = 0; i < fluid.owned(); ++i) {
            const double amount = fluid.data(Field::species_amount, carried.number)[i];
            const double concentration = species.concentration(fluid, i, s);
            if (!(std::abs(amount) <= too_much * carried.largest_amount)) {
                const ParticleTag& tag = fluid.tags()[i];
                std::ostringstream text;
                text << "the concentration of '" << *scene_.species[s].name << "' in particle " << tag.id << " of '"
                     << particles.space().parts[tag.part].name << "' is " << concentration << " "
                     << scene_.species[s].concentration_unit() << ", beyond ten times what it can have been given\n"
                     << likely_cause();
                return text.str();
            }
            const double given = carried.largest_concentration;
            if (given > 0 && !carried.has_flux)
                overshoot_[s] = std::max({overshoot_[s], concentration / given - 1, -concentration / given});
        }
    }
    return "";
}

std::string ConcentrationMonitor::likely_cause() const {
    for (const StepMargin& margin : step_margins(scene_))
        if (margin.model == "species" && margin.is_small()) return "likely cause: " + margin.too_large_text();
    return "likely cause: steps are too long for how fast it diffuses; compare with half of numerics.step_factor";
}

std::vector<Warning> ConcentrationMonitor::warnings(const Ranks& ranks) const {
    std::vector<Warning> found;
    for (std::size_t s = 0; s < overshoot_.size(); ++s) {
        const double overshoot = ranks.largest(overshoot_[s]);
        if (overshoot <= seen) continue;
        const Species& species = scene_.species[s];
        found.push_back({"species." + *species.name, species.name.location,
                         "left the range from 0 to the largest concentration that is given by up to " +
                             number_text(100 * overshoot, 2) +
                             " % of it: a step of it is sharper than the particles can show",
                         "take a smaller particles.spacing, or begin with a smooth concentration (docs/species.md)"});
    }
    return found;
}

}  // namespace dmp::solver
