// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/neighbours/neighbours.hpp"

#include <algorithm>

namespace dmp {

namespace {

/// Two particles may come nearer by this much before a list is out of date [spacings].
constexpr double skin_spacings = 0.4;

}  // namespace

Neighbours::Neighbours(const Ranks& ranks, const ParticleSpace& space, double support, int threads)
    : ranks_(&ranks),
      spacing_(space.spacing),
      skin_(skin_spacings * space.spacing),
      reach_(support + skin_),
      threads_(threads),
      domain_(ranks, space),
      halos_{Halo(ranks, space), Halo(ranks, space), Halo(ranks, space)} {}

void Neighbours::renew(ParticleStore& particles) {
    domain_.migrate(particles.groups());
    std::array<std::vector<Cluster>, 3> clusters;
    for (std::size_t kind = 0; kind < clusters.size(); ++kind) {
        ParticleGroup& group = particles.groups()[kind];
        clusters[kind] = sort_in_space(group, spacing_, threads_);
        halos_[kind].build(group, domain_, reach_);
    }
    list_.build(particles, std::move(clusters), reach_, threads_);
    moved_ = 0;
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
