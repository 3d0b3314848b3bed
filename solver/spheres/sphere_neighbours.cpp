// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/sphere_neighbours.hpp"

#include <algorithm>
#include <cmath>

#include "solver/neighbours/space_order.hpp"

namespace dmp::solver {

namespace {

/// Skins of a pair on average [mean radii]: with which a run starts, and their limits. And what a sphere may have.
constexpr double first_skin = 0.2, least_skin = 0.04, most_skin = 1;
constexpr double least_near_skin = 1e-4;
constexpr double most_of_a_sphere = 2;
/// What spheres are taken to move in a step before one was made [mean radii].
constexpr double first_step = 1.6e-4;
/// Share of the wide skins after which spheres are listed anew, as what is left of them is too narrow for contacts.
constexpr double most_worn = 0.98;
/// Skins are kept in floats: all of one, less what their last digits are unsure of.
constexpr double all_worn = 0.999;

/// Weights that the two skins are balanced with: what a look costs against contacts that a narrow skin adds, and what a
/// list costs against pairs that a wide one adds, in steps and mean radii. Measured on a dense bed, whose lists have
/// six pairs a sphere. Where they have fewer, skins add fewer, while prunes and lists cost the same for each sphere.
constexpr double cost_of_pruning = 0.05, cost_of_a_list = 3.3, dense_pairs = 6;
double cost_of_pruning_at(double pairs) { return cost_of_pruning * dense_pairs / pairs; }
double cost_of_a_list_at(double pairs) { return cost_of_a_list * dense_pairs / pairs; }

Positions positions_of(const SphereRows& rows) {
    const double* first = rows.motion().data()->position.c;
    return {rows.owned(), 3, {first, first + 1, first + 2}, motion_width};
}

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
      list_(setup.kinds, static_cast<std::int16_t>(setup.pairs.size()), setup.history_width, threads),
      step_(first_step),
      pairs_(dense_pairs) {}

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
    const bool prunes = beyond(since_pruning_, all_worn, rows);
    if (prunes && beyond(since_list_, most_worn, rows)) {
        renew(group, rows, walls);
        return true;
    }
    if (prunes) rows.land();
    halo_.exchange_rows(rows.motion().data()->position.c, motion_width);
    if (prunes) prune(group, rows, nullptr);
    return false;
}

void SphereNeighbours::start(Since& since, const SphereRows& rows) const {
    since.positions.take(positions_of(rows), threads_);
    since.displacement.start();
    since.time = 0;
}

/// Whether some sphere has gone that share of its skin.
bool SphereNeighbours::beyond(Since& since, double share, SphereRows& rows) const {
    return since.displacement.beyond(share, [&] {
        rows.land();
        Positions now = positions_of(rows);
        for (std::size_t axis = 0; axis < 3; ++axis) now.common[axis] = since.time * drift_[axis];
        const SphereSkins& skins = since.skins;
        return ranks_->largest(since.positions.farthest_gone(now, threads_, skins.inverse_squares(), skins.least()));
    });
}

/// Never none, as some may come.
void SphereNeighbours::measure_pairs(const SphereRows& rows) {
    const auto pairs = ranks_->sum(static_cast<std::int64_t>(list_.pairs())),
               spheres = ranks_->sum(static_cast<std::int64_t>(rows.owned()));
    pairs_ = std::max(0.02, static_cast<double>(pairs) / static_cast<double>(std::max<std::int64_t>(1, spheres)));
}

/// How far spheres move in a step, as fast ones and slow ones wear out their skins alike.
void SphereNeighbours::measure_step() {
    if (steps_ == 0) return;
    step_ = since_list_.displacement.farthest() * since_list_.skins.mean() / static_cast<double>(steps_) / mean_radius_;
}

/// With near skin n (mean radii), prunes cost c 2v/n a step and needless contacts n: least at sqrt(2 v c).
void SphereNeighbours::prune(ParticleGroup& group, const SphereRows& rows, const ContactMemory* memory) {
    measure_step();
    near_skin_ = std::clamp(std::sqrt(2 * step_ * cost_of_pruning_at(pairs_)), least_near_skin, 0.5 * most_skin);
    since_pruning_.skins.make_within(all_worn - since_list_.displacement.farthest(), since_list_.skins, rows, drift_,
                                     0.5 * near_skin_ * mean_radius_, *ranks_, threads_);
    list_.prune_list(rows, reach_, since_pruning_.skins.by_row(), group.tags(), memory);
    start(since_pruning_, rows);
    ++searches_;
}

void SphereNeighbours::renew(ParticleGroup& group, SphereRows& rows, SphereWalls& walls) {
    measure_step();
    double skin = first_skin;
    if (renewals_ > 0)
        skin = std::clamp(std::sqrt(cost_of_a_list_at(pairs_) * near_skin_), std::max(least_skin, 2 * near_skin_),
                          most_skin);
    measure_drift(rows);
    const auto make_skins = [&] {
        since_list_.skins.make(rows, drift_, 0.5 * skin * mean_radius_, most_of_a_sphere * mean_radius_, *ranks_,
                               threads_);
    };
    make_skins();
    rows.give(group);
    if (ranks_->size() > 1) balance(group);
    if (list_.built()) send_contacts(group, walls);
    domain_.migrate({&group});
    sort_in_space(group, 2 * mean_radius_, threads_);
    // The same skins as below, but for the last bits of a sum that adds up spheres in another order.
    halo_.build(group, domain_, 2 * largest_radius_ + reach_ + 2.001 * ranks_->largest(since_list_.skins.largest()));
    rows.take(group, fixed_by_id_);
    make_skins();
    list_.build(rows, group.tags(), reach_, since_list_.skins.by_row());
    start(since_list_, rows);
    measure_pairs(rows);
    memory_.sort();
    steps_ = 0;
    prune(group, rows, &memory_);
    memory_.clear();
    if (ranks_->size() > 1) imbalance_ = domain_.imbalance({&group}, {});
    last_renewal_ = WallClock::now();
    ++renewals_;
}

/// Divides space anew where the time that ranks have waited for the busiest one is more than dividing takes.
void SphereNeighbours::balance(ParticleGroup& group) {
    time_lost_ += (imbalance_ - 1) * ranks_->largest(seconds_since(last_renewal_));
    if (renewals_ > 1 && time_lost_ < time_to_divide_) return;
    const auto start = WallClock::now();
    domain_.divide({&group}, {});
    time_to_divide_ = ranks_->largest(seconds_since(start));
    time_lost_ = 0;
}

/// Tells every rank what the contacts of spheres that it will own remember.
void SphereNeighbours::send_contacts(const ParticleGroup& group, SphereWalls& walls) {
    const auto contact = [&](std::size_t k) {
        return RememberedContact{group.tags()[list_.low()[k]].id, group.tags()[list_.high()[k]].id,
                                 list_.history_of(k)};
    };
    if (ranks_->size() == 1) {
        list_.for_each([&](std::size_t k, std::int16_t) {
            if (list_.has_history(k)) memory_.add(contact(k));
        });
        return;
    }
    std::vector<int> rank_of(group.owned());
    for (std::size_t i = 0; i < group.owned(); ++i)
        rank_of[i] = domain_.owner(
            {group.data(Field::position, 0)[i], group.data(Field::position, 1)[i], group.data(Field::position, 2)[i]});
    const auto owned = static_cast<std::int32_t>(group.owned());
    const auto rank = [&](std::int32_t row) { return row < owned ? rank_of[static_cast<std::size_t>(row)] : -1; };
    std::vector<std::vector<RememberedContact>> to_each(static_cast<std::size_t>(ranks_->size()));
    list_.for_each([&](std::size_t k, std::int16_t) {
        if (!list_.has_history(k)) return;
        const int low = rank(list_.low()[k]), high = rank(list_.high()[k]);
        if (low >= 0) to_each[static_cast<std::size_t>(low)].push_back(contact(k));
        if (high >= 0 && high != low) to_each[static_cast<std::size_t>(high)].push_back(contact(k));
    });
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
    memory_.archive(file, "spheres/contacts", *ranks_, contacts);
    if (!file.loading()) return;
    memory_.clear();
    for (const RememberedContact& contact : contacts) memory_.add(contact);
    list_.forget();
}

}  // namespace dmp::solver
