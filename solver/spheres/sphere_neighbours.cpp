// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/sphere_neighbours.hpp"

#include <algorithm>
#include <cmath>

#include "solver/neighbours/space_order.hpp"

namespace dmp {

namespace {

/// Skins [mean radii]: with which a run starts, and their limits.
constexpr double first_skin = 0.2, least_skin = 0.04, most_skin = 0.5;
constexpr double first_near_skin = 0.004, least_near_skin = 1e-4;

/// Weights that the two skins are balanced with: what a look costs against contacts that a narrow skin adds, and what a
/// list costs against pairs that a wide one adds, in steps and mean radii. Measured on a dense bed.
constexpr double cost_of_a_look = 0.05, cost_of_a_list = 3.3;

}  // namespace

SphereNeighbours::SphereNeighbours(const Ranks& ranks, const ParticleSpace& space, const SphereSetup& setup,
                                   std::size_t ids, int threads)
    : ranks_(&ranks),
      reach_(setup.reach),
      largest_radius_(setup.largest_radius),
      mean_radius_(setup.mean_radius),
      threads_(threads),
      domain_(ranks, space, threads),
      halo_(ranks, space, threads),
      memory_(ids),
      list_(setup.kinds, static_cast<std::int16_t>(setup.pairs.size()), setup.history_width, threads) {}

/// The mean velocity of all spheres. Its last bits do not matter: where lists are made changes no result.
void SphereNeighbours::measure_drift(const SphereRows& rows) {
    std::array<ExactSum, 3> sum;
    for (const SphereMotion& sphere : rows.motion().first(rows.owned()))
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis].add(sphere.fixed() ? 0 : sphere.velocity.c[axis]);
    const auto count =
        static_cast<double>(std::max<std::int64_t>(1, ranks_->sum(static_cast<std::int64_t>(rows.owned()))));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        ranks_->sum(sum[axis]);
        drift_[axis] = sum[axis].value() / count;
    }
}

void SphereNeighbours::start(ParticleGroup& group, SphereRows& rows, SphereWalls& walls) {
    rows.take(group, fixed_by_id_);
    list_.forget();
    renew(group, rows, walls);
}

bool SphereNeighbours::refresh(ParticleGroup& group, SphereRows& rows, SphereWalls& walls) {
    const double least_near = least_near_skin * mean_radius_;
    if (2 * moved_since_look_ > near_skin_ && 2 * moved_ + least_near > skin_) {
        renew(group, rows, walls);
        return true;
    }
    halo_.exchange_rows(rows.motion().data()->place.c, motion_width);
    if (2 * moved_since_look_ > near_skin_) look(group, rows, nullptr);
    return false;
}

/// With near skin n (mean radii), looks cost c 2v/n a step and needless contacts n: least at sqrt(2 v c).
void SphereNeighbours::look(ParticleGroup& group, const SphereRows& rows, const ContactMemory* memory) {
    double best = first_near_skin;
    if (steps_ > 0) {
        const double step = moved_ / static_cast<double>(steps_) / mean_radius_;
        best = std::clamp(std::sqrt(2 * step * cost_of_a_look), least_near_skin, 0.5 * most_skin);
    }
    near_skin_ = std::min(best * mean_radius_, skin_ - 2 * moved_);
    list_.look_through(rows, reach_ + near_skin_, group.tags(), memory);
    moved_since_look_ = 0;
    ++looks_;
}

void SphereNeighbours::renew(ParticleGroup& group, SphereRows& rows, SphereWalls& walls) {
    const double near = steps_ > 0 ? near_skin_ / mean_radius_ : first_near_skin;
    skin_ = mean_radius_ *
            (steps_ > 0 ? std::clamp(std::sqrt(cost_of_a_list * near), std::max(least_skin, 2 * near), most_skin)
                        : first_skin);
    rows.give(group);
    if (ranks_->size() > 1) balance(group);
    if (list_.built()) send_contacts(group, walls);
    domain_.migrate({&group});
    sort_in_space(group, 2 * mean_radius_, threads_);
    halo_.build(group, domain_, 2 * largest_radius_ + reach_ + skin_);
    rows.take(group, fixed_by_id_);
    list_.build(rows, group.tags(), reach_ + skin_);
    moved_ = 0;
    memory_.sort();
    look(group, rows, &memory_);
    memory_.clear();
    measure_drift(rows);
    steps_ = 0;
    if (ranks_->size() > 1) imbalance_ = domain_.imbalance({&group}, {});
    last_renewal_ = Clock::now();
    ++renewals_;
}

/// Divides space anew where the time that ranks have waited for the busiest one is more than dividing takes.
void SphereNeighbours::balance(ParticleGroup& group) {
    const auto seconds_since = [](Clock::time_point start) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    time_lost_ += (imbalance_ - 1) * ranks_->largest(seconds_since(last_renewal_));
    if (renewals_ > 1 && time_lost_ < time_to_divide_) return;
    const auto start = Clock::now();
    domain_.divide({&group}, {});
    time_to_divide_ = ranks_->largest(seconds_since(start));
    time_lost_ = 0;
}

/// Tells every rank what the contacts of spheres that it will own remember.
void SphereNeighbours::send_contacts(const ParticleGroup& group, SphereWalls& walls) {
    std::vector<int> rank_of(group.owned(), ranks_->rank());
    if (ranks_->size() > 1)
        for (std::size_t i = 0; i < group.owned(); ++i)
            rank_of[i] = domain_.owner({group.data(Field::position, 0)[i], group.data(Field::position, 1)[i],
                                        group.data(Field::position, 2)[i]});
    const auto owned = static_cast<std::int32_t>(group.owned());
    const auto rank = [&](std::int32_t row) { return row < owned ? rank_of[static_cast<std::size_t>(row)] : -1; };
    std::vector<std::vector<RememberedContact>> to_each(static_cast<std::size_t>(ranks_->size()));
    list_.for_each([&](std::size_t k, std::int16_t) {
        if (!list_.has_history(k)) return;
        const std::int32_t i = list_.low()[k], j = list_.high()[k];
        const RememberedContact contact{group.tags()[i].id, group.tags()[j].id, list_.history_of(k)};
        if (const int to = rank(i); to >= 0) to_each[static_cast<std::size_t>(to)].push_back(contact);
        if (const int to = rank(j); to >= 0 && to != rank(i)) to_each[static_cast<std::size_t>(to)].push_back(contact);
    });
    if (ranks_->size() == 1) {
        for (const RememberedContact& contact : to_each[0]) memory_.add(contact);
        return;
    }
    memory_.exchange(*ranks_, to_each);
    walls.exchange(*ranks_, rank_of);
}

std::vector<RememberedContact> SphereNeighbours::own_contacts(const ParticleGroup& group) const {
    std::vector<RememberedContact> own;
    const auto owned = static_cast<std::int32_t>(group.owned());
    list_.for_each([&](std::size_t k, std::int16_t) {
        const std::int32_t i = list_.low()[k], j = list_.high()[k];
        // A contact across a border is there on both sides; that of the lower id counts.
        if (i < owned && list_.has_history(k))
            own.push_back({group.tags()[i].id, group.tags()[j].id, list_.history_of(k)});
    });
    return own;
}

void SphereNeighbours::archive(Archive& file, const ParticleGroup& group) {
    std::vector<RememberedContact> contacts;
    if (!file.loading()) contacts = own_contacts(group);
    ContactMemory::archive(file, "spheres/contacts", *ranks_, contacts);
    if (!file.loading()) return;
    memory_.clear();
    for (const RememberedContact& contact : contacts) memory_.add(contact);
    list_.forget();
}

}  // namespace dmp
