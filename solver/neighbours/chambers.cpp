// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/neighbours/chambers.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "base/disjoint_sets.hpp"

namespace dmp::solver {

namespace {

constexpr double none = std::numeric_limits<double>::max();

double distance_square(const ParticleGroup& a, std::int32_t i, const ParticleGroup& b, std::int32_t j) {
    double square = 0;
    for (int axis = 0; axis < a.dimension(); ++axis) {
        const double apart = a.data(Field::position, axis)[i] - b.data(Field::position, axis)[j];
        square += apart * apart;
    }
    return square;
}

/// Joins fluid particles, owned ones and ghosts, and after their numbers those of the bodies that move.
void join_linked(const ParticleStore& particles, const ClusterList& list, double reach, const std::vector<bool>& moves,
                 DisjointSets& sets) {
    const ParticleGroup &fluid = particles.fluid(), &solids = particles.of(PartKind::elastic);
    const auto clusters = list.clusters(PartKind::fluid);
    const auto owned = static_cast<std::int32_t>(fluid.owned());
    const auto is_linked = [&](std::int32_t i, const ParticleGroup& group, std::int32_t j) {
        return distance_square(fluid, i, group, j) < reach * reach;
    };
    for (std::size_t c = 0; c < clusters.size(); ++c)
        for (std::int32_t i = clusters[c].first; i < clusters[c].first + clusters[c].count; ++i) {
            for (const std::int32_t j : list.neighbours(PartKind::fluid, c, PartKind::fluid))
                if ((j > i || j >= owned) && is_linked(i, fluid, j)) sets.join(i, j);
            for (const std::int32_t j : list.neighbours(PartKind::fluid, c, PartKind::elastic)) {
                const auto body = static_cast<std::size_t>(solids.tags()[j].body);
                if (moves[body] && is_linked(i, solids, j)) sets.join(i, fluid.total() + body);
            }
        }
}

/// Writes the lowest id of all particles that are joined, on any rank, into Field::chamber.
void spread_lowest_ids(ParticleStore& particles, Neighbours& neighbours, std::size_t bodies, DisjointSets& sets) {
    const Ranks& ranks = neighbours.ranks();
    ParticleGroup& fluid = particles.fluid();
    const std::size_t total = fluid.total();
    double* label = fluid.data(Field::chamber);
    for (std::size_t i = 0; i < total; ++i) label[i] = static_cast<double>(fluid.tags()[i].id);
    std::vector<double> of_root, of_body(bodies, none);
    for (bool changed = true; ranks.any(changed);) {
        of_root.assign(total + bodies, none);
        for (std::size_t k = 0; k < total + bodies; ++k) {
            double& lowest = of_root[sets.find(k)];
            lowest = std::min(lowest, k < total ? label[k] : of_body[k - total]);
        }
        changed = false;
        for (std::size_t i = 0; i < total; ++i) {
            const double lowest = of_root[sets.find(i)];
            changed = changed || lowest < label[i];
            label[i] = lowest;
        }
        for (std::size_t b = 0; b < bodies; ++b) of_body[b] = -of_root[sets.find(total + b)];
        ranks.largest(of_body);
        for (double& lowest : of_body) lowest = -lowest;
        neighbours.exchange(particles, {Field::chamber});
    }
}

/// By label: the number of a chamber, for those that are large enough, and the place of its particle of that id.
struct Numbered {
    std::map<double, std::int32_t> number;
    std::vector<std::array<double, 3>> places;
};

Numbered number_chambers(const ParticleGroup& fluid, const Ranks& ranks) {
    struct Piece {
        double label;
        std::int64_t particles, has_place;
        std::array<double, 3> place;
    };
    std::map<double, Piece> pieces;
    const auto add = [&](const Piece& piece) {
        Piece& known = pieces.try_emplace(piece.label, Piece{piece.label, 0, 0, {}}).first->second;
        known.particles += piece.particles;
        if (piece.has_place == 0) return;
        known.has_place = 1;
        known.place = piece.place;
    };
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        const double label = fluid.data(Field::chamber)[i];
        Piece one{label, 1, static_cast<double>(fluid.tags()[i].id) == label ? 1 : 0, {}};
        for (int axis = 0; axis < fluid.dimension(); ++axis) one.place[axis] = fluid.data(Field::position, axis)[i];
        add(one);
    }
    std::vector<Piece> own;
    for (const auto& [label, piece] : pieces) own.push_back(piece);
    pieces.clear();
    for (const Piece& piece : ranks.all_gather(own)) add(piece);
    const auto largest = std::ranges::max_element(pieces, {}, [](const auto& each) { return each.second.particles; });
    if (largest == pieces.end()) return {};
    const std::int64_t fewest = std::min(ChamberLinks::fewest_particles(fluid.dimension()), largest->second.particles);
    Numbered numbered;
    for (const auto& [label, piece] : pieces) {
        if (piece.particles < fewest) continue;
        numbered.number[label] = static_cast<std::int32_t>(numbered.places.size());
        numbered.places.push_back(piece.place);
    }
    return numbered;
}

using SharedCounts = std::map<std::pair<std::int32_t, std::int32_t>, std::int64_t>;

std::vector<FoundChambers::Shared> of_all_ranks(const SharedCounts& own, const Ranks& ranks) {
    std::vector<FoundChambers::Shared> here, all;
    for (const auto& [pair, particles] : own) here.push_back({pair.first, pair.second, particles});
    SharedCounts sum;
    for (const auto& each : ranks.all_gather(here)) sum[{each.before, each.now}] += each.particles;
    for (const auto& [pair, particles] : sum) all.push_back({pair.first, pair.second, particles});
    return all;
}

}  // namespace

bool FoundChambers::same_as_before() const {
    std::vector<std::int32_t> before, now;
    for (const Shared& each : shared) {
        before.push_back(each.before);
        now.push_back(each.now);
    }
    std::ranges::sort(now);
    return std::ranges::adjacent_find(before) == before.end() && std::ranges::adjacent_find(now) == now.end();
}

FoundChambers find_chambers(ParticleStore& particles, Neighbours& neighbours, double spacing,
                            const std::vector<bool>& moves) {
    const Ranks& ranks = neighbours.ranks();
    ParticleGroup& fluid = particles.fluid();
    double* chamber = fluid.data(Field::chamber);
    const std::vector<double> before(chamber, chamber + fluid.owned());
    neighbours.exchange(particles, {Field::position});
    DisjointSets sets(fluid.total() + moves.size());
    join_linked(particles, neighbours.list(), ChamberLinks::reach(spacing), moves, sets);
    spread_lowest_ids(particles, neighbours, moves.size(), sets);
    const Numbered numbered = number_chambers(fluid, ranks);

    constexpr std::int32_t apart = -1;
    std::vector<std::int32_t> now(fluid.owned(), apart);
    SharedCounts counts;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const auto known = numbered.number.find(chamber[i]);
        if (known == numbered.number.end()) continue;
        now[i] = known->second;
        ++counts[{static_cast<std::int32_t>(before[i]), now[i]}];
    }
    std::map<std::int32_t, FoundChambers::Shared> most;  // by chamber before
    for (const auto& each : of_all_ranks(counts, ranks)) {
        auto& known = most.try_emplace(each.before, each).first->second;
        if (each.particles > known.particles) known = each;
    }
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (now[i] == apart) {
            const auto own = static_cast<std::int32_t>(before[i]);
            now[i] = most.contains(own) ? most.at(own).now : 0;
            ++counts[{own, now[i]}];
        }
        chamber[i] = now[i];
    }
    return {of_all_ranks(counts, ranks), numbered.places};
}

}  // namespace dmp::solver
