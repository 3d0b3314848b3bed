// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/solidify/bond_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "models/solidify/mutually_closest.hpp"
#include "models/solidify/per_candidate.hpp"
#include "models/solidify/per_pair.hpp"
#include "particles/cell_grid.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

std::array<double, 3> in_box(const Vec& position, const ParticleSpace& space) {
    std::array<double, 3> inside{position[0], position[1], position[2]};
    for (int axis = 0; axis < space.dimension; ++axis)
        if (space.periodic[axis]) inside[axis] = wrapped(inside[axis], space.box.low[axis], space.box.high[axis]);
    return inside;
}

/// Calls visit(point) for the point and those of its images that may have a point of the box within reach.
template <class Visit>
void for_each_image(std::array<double, 3> point, double reach, const ParticleSpace& space, int axis,
                    const Visit& visit) {
    if (axis == space.dimension) return visit(point);
    for_each_image(point, reach, space, axis + 1, visit);
    if (!space.periodic[axis]) return;
    const double low = space.box.low[axis], high = space.box.high[axis], x = point[axis];
    if (x < low + reach) {
        point[axis] = x + (high - low);
        for_each_image(point, reach, space, axis + 1, visit);
    }
    if (x >= high - reach) {
        point[axis] = x - (high - low);
        for_each_image(point, reach, space, axis + 1, visit);
    }
}

}  // namespace

std::vector<BondCandidate> find_bond_candidates(std::span<const ParticlePosition> seeds,
                                                std::span<const ParticlePosition> liquid, double reach,
                                                const ParticleSpace& space) {
    std::vector<BondCandidate> found;
    if (seeds.empty()) return found;
    Coordinates positions;
    for (const ParticlePosition& seed : seeds) {
        const auto inside = in_box(seed.position, space);
        for (int axis = 0; axis < space.dimension; ++axis) positions[axis].push_back(inside[axis]);
    }
    const CellGrid grid(positions, seeds.size(), space.dimension, reach);
    for (const ParticlePosition& particle : liquid)
        for_each_image(in_box(particle.position, space), reach, space, 0, [&](const std::array<double, 3>& image) {
            grid.for_each_near(image, reach, [&](int s) {
                double square = 0;
                for (int axis = 0; axis < space.dimension; ++axis)
                    square += std::pow(image[axis] - positions[axis][s], 2);
                if (square <= reach * reach) found.push_back({seeds[s].id, particle.id, std::sqrt(square)});
            });
        });
    return found;
}

void find_nearest(std::vector<BondCandidate>& candidates, double reach) {
    std::ranges::sort(candidates, {}, [](const BondCandidate& e) { return std::pair(e.liquid, e.seed); });
    const auto rank = [reach](const BondCandidate& e, std::int64_t other) {
        return std::pair(std::llround(e.distance / (1e-9 * reach)), other);
    };
    std::unordered_map<std::int64_t, BondCandidate*> of_liquid, of_seed;
    for (BondCandidate& e : candidates) {
        BondCandidate*& for_liquid = of_liquid[e.liquid];
        if (for_liquid == nullptr || rank(e, e.seed) < rank(*for_liquid, for_liquid->seed)) for_liquid = &e;
        BondCandidate*& for_seed = of_seed[e.seed];
        if (for_seed == nullptr || rank(e, e.liquid) < rank(*for_seed, for_seed->liquid)) for_seed = &e;
    }
    for (const auto& [id, nearest] : of_liquid) nearest->nearest_seed = true;
    for (const auto& [id, nearest] : of_seed) nearest->nearest_liquid = true;
}

Binds binding_rule(SolidifyRule rule, double probability) {
    const auto with = [](const auto& law) {
        return [law](const BondCandidate& candidate, const RandomTrial& trial) { return law.binds(candidate, trial); };
    };
    switch (rule) {
        case SolidifyRule::per_candidate:
            return with(PerCandidate{probability});
        case SolidifyRule::mutually_closest:
            return with(MutuallyClosest{probability});
        case SolidifyRule::per_pair:
            return with(PerPair{probability});
    }
    throw std::logic_error("a rule of solidifying without a law");
}

std::vector<BondCandidate> binding_ones(std::span<const BondCandidate> candidates, const Binds& binds,
                                        const RandomTrial& trial, std::unordered_map<std::int64_t, int> room,
                                        int most_bonds) {
    std::vector<BondCandidate> binding;
    for (const BondCandidate& e : candidates) {
        if (!binds(e, trial)) continue;
        int& of_seed = room.try_emplace(e.seed, most_bonds).first->second;
        int& of_liquid = room.try_emplace(e.liquid, most_bonds).first->second;
        if (of_seed <= 0 || of_liquid <= 0) continue;
        --of_seed;
        --of_liquid;
        binding.push_back(e);
    }
    return binding;
}

}  // namespace dmp::solver
