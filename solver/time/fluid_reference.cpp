// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/time/fluid_reference.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number_text.hpp"

namespace dmp::solver {

FluidReference::FluidReference(const Settings& settings, std::vector<double> rest_density,
                               const ParticleStore& particles, const Ranks& ranks)
    : settings_(settings), rest_density_(std::move(rest_density)) {
    count(particles, ranks);
    mean_density_ = rest_volume_ > 0 ? mass_ / rest_volume_ : 0;
}

void FluidReference::count(const ParticleStore& particles, const Ranks& ranks) {
    const ParticleGroup& fluid = particles.fluid();
    std::vector<ExactSum> sums(2);
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        const double mass = fluid.data(Field::mass)[i];
        sums[0].add(mass);
        sums[1].add(mass / rest_density_[fluid.tags()[i].part]);
    }
    ranks.sum(sums);
    mass_ = sums[0].value();
    rest_volume_ = sums[1].value();
}

ReferencePressure FluidReference::pressure(const ParticleStore& particles, const std::array<double, 3>& g) const {
    ReferencePressure reference;
    if (!settings_.subtracts || mass_ == 0) return reference;
    const ParticleSpace& space = particles.space();
    reference.level = level_ - suction_;
    for (int axis = 0; axis < particles.dimension(); ++axis) {
        reference.slope[axis] = space.is_mirrored(axis) ? 0 : mean_density_ * g[axis];
        reference.centre[axis] = 0.5 * (space.box.low[axis] + space.box.high[axis]);
    }
    return reference;
}

void FluidReference::start(const VolumeSums& of_all_ranks) {
    volume_ratio_ = rest_volume_ > 0 ? of_all_ranks.volume.value() / rest_volume_ : 1;
    update_level(of_all_ranks);
}

void FluidReference::update(const VolumeSums& of_all_ranks, double dt) {
    if (settings_.keeps_volume && rest_volume_ > 0) {
        excess_ = volume_ratio_ * rest_volume_ / of_all_ranks.volume.value() - 1;
        drift_ += excess_;
    }
    update_level(of_all_ranks);
    update_suction(of_all_ranks, dt);
}

/// The sums are of pressures less what is subtracted at present.
void FluidReference::update_level(const VolumeSums& sums) {
    const double volume = sums.volume.value();
    if (settings_.subtracts && volume > 0) level_ += sums.pressure.value() / volume - suction_;
}

void FluidReference::update_suction(const VolumeSums& sums, double dt) {
    const double volume = sums.volume.value();
    if (!settings_.subtracts || !(volume > 0)) return;
    const double variance = sums.square.value() / volume - std::pow(sums.pressure.value() / volume, 2);
    // No number is an error, and ends the run.
    suction_ = VoidClosing::suction(suction_, sums.beside_voids.value(), std::sqrt(std::max(0.0, variance)),
                                    dt / settings_.void_time);
}

void FluidReference::archive(Archive& file) {
    file("reference/mass", mass_);
    file("reference/rest_volume", rest_volume_);
    file("reference/volume_ratio", volume_ratio_);
    file("reference/level", level_);
    if (settings_.subtracts) file("reference/suction", suction_);
    if (!file.starts_run()) file("reference/density_drift", drift_);
}

std::optional<Warning> drift_warning(double drift) {
    constexpr double most = 0.05;
    if (!(std::abs(drift) > most)) return {};
    Warning warning;
    warning.key = "numerics.scheme";
    warning.problem = "\"corrected\" kept the fluid's volume by taking a drift of its mean density of " +
                      number_text(100 * drift, 2) +
                      " % off, in steps: errors of the density rate are large in this flow";
    warning.what_to_do = "compare with a smaller particles.spacing";
    return warning;
}

}  // namespace dmp::solver
