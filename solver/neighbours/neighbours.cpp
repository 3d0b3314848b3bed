// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/neighbours/neighbours.hpp"

#include <algorithm>
#include <cmath>

namespace dmp {

namespace {

/// The skin [spacings]: of the first list, and its limits.
constexpr double first_skin = 0.4, least_skin = 0.1, most_skin = 0.8;

/// Making a list costs as much time as one step's sweeps take longer with this much more skin [spacings]. Measured on
/// disordered particles: 2.3 in 2-D (125 ns against 54 ns a spacing, support 3), 3 in 3-D (400 against 130, support 2).
constexpr double cost_of_a_list = 2.5;

}  // namespace

Neighbours::Neighbours(const Ranks& ranks, const ParticleSpace& space, double support, int threads)
    : ranks_(&ranks),
      spacing_(space.spacing),
      support_(support),
      skin_(first_skin * space.spacing),
      threads_(threads),
      domain_(ranks, space),
      halos_{Halo(ranks, space), Halo(ranks, space), Halo(ranks, space)} {}

/// With skin s a list lasts s / (2 v) steps of length v; c / (s / 2v) + s is least at s = sqrt(2 v c).
double Neighbours::best_skin() const {
    if (half_steps_ == 0) return skin_;
    const double step = moved_ / (0.5 * static_cast<double>(half_steps_)) / spacing_;
    return std::clamp(std::sqrt(2 * step * cost_of_a_list), least_skin, most_skin) * spacing_;
}

void Neighbours::renew(ParticleStore& particles) {
    skin_ = best_skin();
    const double reach = support_ + skin_;
    domain_.migrate(particles.groups());
    std::array<std::vector<Cluster>, 3> clusters;
    for (std::size_t kind = 0; kind < clusters.size(); ++kind) {
        ParticleGroup& group = particles.groups()[kind];
        clusters[kind] = sort_in_space(group, spacing_, threads_);
        halos_[kind].build(group, domain_, reach);
    }
    list_.build(particles, std::move(clusters), reach, threads_);
    moved_ = 0;
    half_steps_ = 0;
    ++renewals_;
}

void Neighbours::exchange(ParticleStore& particles, const FieldList& fields) {
    for (std::size_t kind = 0; kind < halos_.size(); ++kind) {
        ParticleGroup& group = particles.groups()[kind];
        FieldList present = fields;
        std::erase_if(present, [&](Field field) { return !group.has(field); });
        halos_[kind].exchange(group, present);
    }
}

}  // namespace dmp
