// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/time/fluid_reference.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/disjoint_sets.hpp"
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
    count_chambers(particles, ranks);
}

void FluidReference::count_chambers(const ParticleStore& particles, const Ranks& ranks) {
    if (chambers_.empty()) return;
    const ParticleGroup& fluid = particles.fluid();
    std::vector<ExactSum> sums(2 * chambers_.size());
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        const auto chamber = static_cast<std::size_t>(fluid.data(Field::chamber)[i]);
        const double mass = fluid.data(Field::mass)[i];
        sums[2 * chamber].add(mass);
        sums[2 * chamber + 1].add(mass / rest_density_[fluid.tags()[i].part]);
    }
    ranks.sum(sums);
    for (std::size_t c = 0; c < chambers_.size(); ++c) {
        chambers_[c].mass = sums[2 * c].value();
        chambers_[c].rest_volume = sums[2 * c + 1].value();
    }
}

namespace {

/// By chamber: the sum of m / rho as densities are now [m^3].
std::vector<double> volumes_of(std::size_t chambers, const ParticleGroup& fluid, const Ranks& ranks) {
    std::vector<ExactSum> sums(chambers);
    for (std::size_t i = 0; i < fluid.owned(); ++i)
        sums[static_cast<std::size_t>(fluid.data(Field::chamber)[i])].add(fluid.data(Field::mass)[i] /
                                                                          fluid.data(Field::density)[i]);
    ranks.sum(sums);
    std::vector<double> volumes;
    for (const ExactSum& sum : sums) volumes.push_back(sum.value());
    return volumes;
}

}  // namespace

void FluidReference::take_chambers(const FoundChambers& found, const ParticleStore& particles, const Ranks& ranks) {
    const std::size_t count = found.count();
    const bool same = found.same_as_before();
    if (count == 0 || (same && count == 1)) return;
    std::vector<Chamber> before = chambers_;
    if (before.empty()) before.push_back({mass_, rest_volume_, volume_ratio_, drift_, {}});
    chambers_.assign(count, {});
    count_chambers(particles, ranks);
    // New chambers with liquid of the same ones share their target.
    DisjointSets sets(before.size() + count);
    std::vector<std::int64_t> most(count);
    for (const FoundChambers::Shared& each : found.shared) {
        sets.join(each.before, before.size() + each.now);
        if (each.particles <= most[each.now]) continue;
        most[each.now] = each.particles;
        chambers_[each.now].drift = before[each.before].drift;
        chambers_[each.now].ratio = before[each.before].ratio;
    }
    if (!same) {
        const std::vector<double> volume = volumes_of(count, particles.fluid(), ranks);
        std::vector<double> target(before.size() + count), present(before.size() + count);  // by root
        for (std::size_t c = 0; c < before.size(); ++c) target[sets.find(c)] += before[c].target();
        for (std::size_t c = 0; c < count; ++c) present[sets.find(before.size() + c)] += volume[c];
        std::vector<int> news(before.size() + count), olds(before.size() + count);
        for (std::size_t c = 0; c < before.size(); ++c) ++olds[sets.find(c)];
        for (std::size_t c = 0; c < count; ++c) ++news[sets.find(before.size() + c)];
        for (std::size_t c = 0; c < count; ++c) {
            const std::size_t root = sets.find(before.size() + c);
            if (olds[root] == 1 && news[root] == 1) continue;  // keeps its ratio, to the last bit
            chambers_[c].ratio = volume[c] * target[root] / (present[root] * chambers_[c].rest_volume);
        }
    }
    for (std::size_t c = 0; c < count; ++c) chambers_[c].place = found.places[c];
    excess_of_chambers_.assign(count, 0);
    if (count > 1) return;
    volume_ratio_ = chambers_.front().ratio;
    chambers_.clear();
    excess_of_chambers_.clear();
}

std::vector<ChamberDrift> FluidReference::chamber_drifts() const {
    std::vector<ChamberDrift> drifts;
    for (const Chamber& chamber : chambers_) drifts.push_back({chamber.mass, chamber.drift, chamber.place});
    return drifts;
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

void FluidReference::update(const VolumeSums& of_all_ranks, double dt, std::span<const ExactSum> volumes) {
    if (settings_.keeps_volume && rest_volume_ > 0) update_excess(of_all_ranks.volume.value(), volumes);
    update_level(of_all_ranks);
    update_suction(of_all_ranks, dt);
}

void FluidReference::update_excess(double volume, std::span<const ExactSum> volumes) {
    double target = volume_ratio_ * rest_volume_;
    if (!chambers_.empty()) target = 0;
    for (std::size_t c = 0; c < chambers_.size(); ++c) {
        if (chambers_[c].rest_volume > 0)
            excess_of_chambers_[c] = chambers_[c].target() / volumes[c].value() - 1;
        else
            excess_of_chambers_[c] = 0;  // all of it has turned solid
        chambers_[c].drift += excess_of_chambers_[c];
        target += chambers_[c].target();
    }
    excess_ = target / volume - 1;
    drift_ += excess_;
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
    if (!settings_.chambers) return;
    std::vector<double> values;
    for (const Chamber& chamber : chambers_)
        values.insert(values.end(), {chamber.mass, chamber.rest_volume, chamber.ratio, chamber.drift, chamber.place[0],
                                     chamber.place[1], chamber.place[2]});
    file("reference/chambers", values);
    if (!file.loading()) return;
    constexpr std::size_t of_each = 7;
    chambers_.clear();
    for (std::size_t k = 0; k + of_each <= values.size(); k += of_each) {
        const double* of = values.data() + k;
        chambers_.push_back({of[0], of[1], of[2], file.starts_run() ? 0 : of[3], {of[4], of[5], of[6]}});
    }
    excess_of_chambers_.assign(chambers_.size(), 0);
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

std::optional<Warning> chamber_warning(const ChamberDrift& chamber, int dimension) {
    constexpr double most = 0.05;
    if (!(std::abs(chamber.drift) > most)) return {};
    std::string place;
    for (int axis = 0; axis < dimension; ++axis)
        place += (axis > 0 ? ", " : "") + number_text(chamber.place[axis], 4) + " m";
    Warning warning;
    warning.key = "numerics.scheme";
    warning.problem = "\"corrected\" kept the volume of the closed chamber at (" + place +
                      ") by taking a drift of its mean density of " + number_text(100 * chamber.drift, 2) +
                      " % off, in steps: errors of the density rate are large in it";
    warning.what_to_do = "look for liquid that passes its walls, and compare with a smaller particles.spacing";
    return warning;
}

}  // namespace dmp::solver
