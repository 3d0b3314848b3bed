// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/neighbours/neighbours.hpp"

#include <algorithm>
#include <cmath>

namespace dmp::solver {

namespace {

/// The skin [spacings]: of the first list, and its limits.
constexpr double first_skin = 0.4, least_skin = 0.1, most_skin = 0.8;
constexpr double least_near_skin = 0.02;

/// Cost of building a list and of pruning it, as the additional skin [spacings] that slows down the sweeps of one
/// step (for a list: the prunings of one step) by the same time. Measured on disordered particles in 2-D and in 3-D.
constexpr double cost_of_a_list = 15, cost_of_pruning = 0.3;

Positions positions_of(const ParticleGroup& group) {
    Positions positions{group.owned(), group.dimension()};
    for (int axis = 0; axis < group.dimension(); ++axis) positions.first[axis] = group.data(Field::position, axis);
    return positions;
}

}  // namespace

Neighbours::Neighbours(const Ranks& ranks, const ParticleSpace& space, double support, int threads)
    : ranks_(&ranks),
      spacing_(space.spacing),
      support_(support),
      skin_(first_skin * space.spacing),
      threads_(threads),
      domain_(ranks, space, threads),
      halos_{Halo(ranks, space, threads), Halo(ranks, space, threads), Halo(ranks, space, threads)} {}

/// With skin s a list lasts s / (2 v) steps of length v; c / (s / 2v) + s is smallest at s = sqrt(2 v c). All in
/// spacings.
double Neighbours::skin_for(double cost, double least, double most, double otherwise) const {
    if (half_steps_ == 0) return otherwise * spacing_;
    const double step = since_list_.farthest() / (0.5 * static_cast<double>(half_steps_)) / spacing_;
    return std::clamp(std::sqrt(2 * step * cost), least, most) * spacing_;
}

double Neighbours::best_skin() const { return skin_for(cost_of_a_list, least_skin, most_skin, skin_ / spacing_); }

/// At most the skin that the list still covers.
double Neighbours::best_near_skin() const {
    return std::min(skin_for(cost_of_pruning, least_near_skin, most_skin, least_near_skin),
                    skin_ - 2 * since_list_.farthest());
}

void Neighbours::note_positions(const ParticleStore& particles, PositionsByKind& then) const {
    for (std::size_t kind = 0; kind < then.size(); ++kind)
        then[kind].take(positions_of(particles.groups()[kind]), threads_);
}

/// Over all ranks.
double Neighbours::farthest_gone(const ParticleStore& particles, const PositionsByKind& then) const {
    double farthest = 0;
    for (std::size_t kind = 0; kind < then.size(); ++kind)
        farthest = std::max(farthest, then[kind].farthest_gone(positions_of(particles.groups()[kind]), threads_));
    return ranks_->largest(farthest);
}

void Neighbours::renew(ParticleStore& particles) {
    skin_ = best_skin();
    const double reach = support_ + skin_;
    GroupList groups;
    for (ParticleGroup& group : particles.groups()) groups.push_back(&group);
    if (ranks_->size() > 1) balance(groups);
    domain_.migrate(groups);
    std::array<std::vector<Cluster>, 3> clusters;
    for (std::size_t kind = 0; kind < clusters.size(); ++kind) {
        ParticleGroup& group = particles.groups()[kind];
        clusters[kind] = sort_in_space(group, spacing_, threads_);
        halos_[kind].build(group, domain_, reach);
    }
    if (within_solids_) within_solids_->build(particles, clusters, reach, threads_, Pairs::within_solids);
    list_.build(particles, std::move(clusters), reach, threads_);
    if (ranks_->size() > 1) {
        weights_ = measured_weights(particles);
        imbalance_ = domain_.imbalance(groups, weights_);
    }
    note_positions(particles, listed_at_);
    since_list_.start();
    half_steps_ = 0;
    // Initially all entries count as near; the next pruning removes the far ones.
    near_skin_ = 0;
    last_renewal_ = WallClock::now();
    ++renewals_;
}

/// Divides space again once the ranks have waited longer for the busiest one than a division takes.
void Neighbours::balance(const GroupList& groups) {
    time_lost_ += (imbalance_ - 1) * ranks_->largest(seconds_since(last_renewal_));
    if (renewals_ > 1 && time_lost_ < time_to_divide_) return;
    const auto start = WallClock::now();
    domain_.divide(groups, weights_);
    time_to_divide_ = ranks_->largest(seconds_since(start));
    time_lost_ = 0;
}

/// The weight of a kind is its number of pairs per particle.
KindWeights Neighbours::measured_weights(const ParticleStore& particles) const {
    const auto weight_of = [&](PartKind own_kind) {
        std::int64_t pairs = 0;
        for (std::size_t c = 0; c < list_.clusters(own_kind).size(); ++c)
            for (const PartKind kind : all_kinds)
                pairs += static_cast<std::int64_t>(list_.neighbours(own_kind, c, kind).size());
        const std::int64_t all_pairs = ranks_->sum(pairs);
        const std::int64_t owned = ranks_->sum(static_cast<std::int64_t>(particles.of(own_kind).owned()));
        return std::max(0.05, static_cast<double>(all_pairs) / static_cast<double>(std::max<std::int64_t>(1, owned)));
    };
    return {weight_of(PartKind::fluid), weight_of(PartKind::rigid), weight_of(PartKind::elastic)};
}

double Neighbours::ghosts_per_owned(const ParticleStore& particles) const {
    std::int64_t ghosts = 0;
    for (const Halo& halo : halos_) ghosts += static_cast<std::int64_t>(halo.ghosts());
    return static_cast<double>(ranks_->sum(ghosts)) /
           static_cast<double>(std::max<std::int64_t>(1, ranks_->sum(static_cast<std::int64_t>(particles.owned()))));
}

void Neighbours::start_exchange(ParticleStore& particles, const FieldList& fields) {
    for (std::size_t kind = 0; kind < halos_.size(); ++kind) {
        ParticleGroup& group = particles.groups()[kind];
        FieldList present = fields;
        std::erase_if(present, [&](Field field) { return !group.has(field); });
        halos_[kind].start(group, present);
    }
}

void Neighbours::finish_exchange(ParticleStore& particles) {
    for (std::size_t kind = 0; kind < halos_.size(); ++kind) halos_[kind].finish(particles.groups()[kind]);
}

HaloTraffic Neighbours::traffic() const {
    HaloTraffic all;
    for (const Halo& halo : halos_) {
        all.messages += halo.traffic().messages;
        all.bytes += halo.traffic().bytes;
    }
    return all;
}

}  // namespace dmp::solver
