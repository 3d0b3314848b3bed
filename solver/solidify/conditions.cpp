// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/solidify/conditions.hpp"

#include "particles/periodic_images.hpp"
#include "solver/output/fluid_fields.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

SolidifyRegion::SolidifyRegion(const Scene& scene, const Value<std::string>& name, const ParticleSpace& space)
    : space_(space), everywhere_(name->empty()) {
    for (std::size_t k = 0; !everywhere_ && k < scene.regions.size(); ++k) {
        const ResidenceRegion& region = scene.regions[k];
        if (*region.name != *name) continue;
        number_ = static_cast<int>(k);
        region_ = &region;
    }
}

bool SolidifyRegion::contains(const Vec& position) const {
    if (everywhere_) return true;
    Vec place = position;
    for (int axis = 0; axis < space_.dimension; ++axis)
        if (space_.periodic[axis]) place[axis] = wrapped(place[axis], space_.box.low[axis], space_.box.high[axis]);
    return region_->contains(place, space_.dimension);
}

SolidifyConditions::SolidifyConditions(const Scene& scene, const Solidify& rule, int liquid_part,
                                       const ParticleStore& particles, const FluidStep& fluid)
    : rule_(rule),
      liquid_part_(liquid_part),
      particles_(particles),
      seed_region_(scene, rule.seed_region, particles.space()),
      region_(scene, rule.region, particles.space()) {
    if (rule.seed_stress_above > 0 || rule.stress_above > 0)
        stress_ = FluidFields(scene, particles, fluid).of(FluidField::shear_stress).front().values;
}

bool SolidifyConditions::fulfils(std::size_t i, const SolidifyRegion& region, double stress, double residence) const {
    const ParticleGroup& fluid = particles_.fluid();
    Vec position = Vec::Zero();
    for (int axis = 0; axis < fluid.dimension(); ++axis) position[axis] = fluid.data(Field::position, axis)[i];
    if (!region.contains(position)) return false;
    if (stress > 0 && !(stress_[i] > stress)) return false;
    return residence <= 0 || fluid.data(Field::residence_time, region.number())[i] > residence;
}

bool SolidifyConditions::becomes_seed(std::size_t i, std::int64_t event) const {
    if (!rule_.seed_part->empty()) return false;
    const bool always = rule_.seed_stress_above > 0 || rule_.seed_residence_above > 0;
    return (always || event == 0) && fulfils(i, seed_region_, rule_.seed_stress_above, rule_.seed_residence_above);
}

bool SolidifyConditions::may_turn(std::size_t i) const {
    return fulfils(i, region_, rule_.stress_above, rule_.residence_above);
}

}  // namespace dmp::solver
