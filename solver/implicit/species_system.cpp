// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/implicit/species_system.hpp"

#include <algorithm>
#include <cmath>

#include "solver/store/sums_over.hpp"

namespace dmp::solver {

SpeciesSystem::SpeciesSystem(const Around& around, const SpeciesSums& sums) : on_(around), sums_(sums) {
    for (ParticleGroup& group : on_.particles.groups())
        if (group.has(Field::species_change)) groups_.push_back(&group);
    // Walls are no unknowns: their directions are 0.
    for (ParticleGroup* group : groups_) std::fill_n(group->data(Field::species_direction), group->total(), 0.0);

    sums_.adds = false;
    sums_.array_of_result = 0;
    sums_.of = SpeciesSums::Of::conductances;
    sums_.result = Field::species_diagonal;
    on_.sweeps.species(on_.particles, {on_.neighbours.list(), on_.neighbours.within_solids()}, sums_);
    sums_.of = SpeciesSums::Of::amounts;
    sums_.result = Field::species_change;

    std::array<double, 2> largest{};
    for (ParticleGroup* group : groups_) {
        const Arrays a = arrays_of(*group);
        for (std::size_t i = 0; i < group->owned(); ++i) {
            if (a.diffusivity != nullptr && group->kind() != PartKind::fluid && a.diffusivity[i] == 0) continue;
            largest[0] = std::max(largest[0], a.diagonal[i]);
            largest[1] = std::max(largest[1], a.diagonal[i] / on_.volume(*group, i));
        }
    }
    on_.ranks.largest(largest);
    largest_diagonal_ = largest[0];
    condition_ = 1 + 2 * largest[1];
}

SpeciesSystem::Arrays SpeciesSystem::arrays_of(ParticleGroup& group) const {
    return {group.data(Field::concentration, sums_.species),
            group.data(Field::species_amount, sums_.species),
            group.data(Field::species_change),
            group.data(Field::species_residual),
            group.data(Field::species_direction),
            group.data(Field::species_diagonal),
            group.has(Field::species_diffusivity) ? group.data(Field::species_diffusivity, sums_.species) : nullptr};
}

template <std::size_t Count, class Visit>
std::array<double, Count> SpeciesSystem::sums_over_unknowns(const Visit& visit) {
    std::array<ExactSum, Count> all;
    for (ParticleGroup* group : groups_) {
        const Arrays a = arrays_of(*group);
        const bool is_fluid = group->kind() == PartKind::fluid;
        const auto of_group = sums_over<Count>(*group, on_.threads, [&](std::ptrdiff_t i, auto& sums) {
            if (!is_fluid && a.diffusivity[i] == 0) return;
            visit(a, i, on_.volume(*group, static_cast<std::size_t>(i)), sums);
        });
        for (std::size_t k = 0; k < Count; ++k) all[k].add(of_group[k]);
    }
    on_.ranks.sum(all);
    std::array<double, Count> values{};
    for (std::size_t k = 0; k < Count; ++k) values[k] = all[k].value();
    return values;
}

template <class Visit>
void SpeciesSystem::for_each_unknown(const Visit& visit) {
    for (ParticleGroup* group : groups_) {
        const Arrays a = arrays_of(*group);
        const bool is_fluid = group->kind() == PartKind::fluid;
        const auto count = static_cast<std::ptrdiff_t>(group->owned());
#pragma omp parallel for num_threads(on_.threads) schedule(static)
        for (std::ptrdiff_t i = 0; i < count; ++i)
            if (is_fluid || a.diffusivity[i] != 0) visit(a, i, on_.volume(*group, static_cast<std::size_t>(i)));
    }
}

double SpeciesSystem::largest(Field values, int array) const {
    double largest = 0;
    for (const ParticleGroup* group : groups_) {
        const double* value = group->data(values, array);
        for (std::size_t i = 0; i < group->owned(); ++i) {
            const double size = std::abs(value[i]);
            largest = size <= largest ? largest : size;  // NaN too
        }
    }
    return on_.ranks.largest(largest);
}

void SpeciesSystem::find_change(Field values, int array, double largest_value) {
    on_.neighbours.exchange(on_.particles, {values});
    sums_.values = values;
    sums_.array_of_values = array;
    // No sum is larger than the diagonal times twice the largest value, and no term is.
    sums_.largest_term = at_least_something(largest_diagonal_ * largest_value / 16);
    on_.sweeps.species(on_.particles, {on_.neighbours.list(), on_.neighbours.within_solids()}, sums_);
}

double SpeciesSystem::true_error() {
    const double highest = largest(Field::concentration, sums_.species);
    find_change(Field::concentration, sums_.species, highest);
    const auto sums = sums_over_unknowns<3>([&](const Arrays& a, std::ptrdiff_t i, double volume, auto& sum) {
        const double c = a.concentration[i], r = a.amount[i] - volume * c + a.change[i];
        a.residual[i] = r;
        sum[0].add(r * r / volume);
        sum[1].add(volume * c * c);
        sum[2].add(volume);
    });
    scale_ = std::max({scale_, std::sqrt(sums[1]), 1e-3 * highest * std::sqrt(sums[2])});
    return std::sqrt(sums[0]);
}

Residual SpeciesSystem::start() {
    turn(0);
    return residual_sums();
}

double SpeciesSystem::curvature() {
    find_change(Field::species_direction, 0, largest(Field::species_direction, 0));
    return sums_over_unknowns<1>([&](const Arrays& a, std::ptrdiff_t i, double volume, auto& sum) {
        sum[0].add(a.direction[i] * (volume * a.direction[i] - a.change[i]));
    })[0];
}

Residual SpeciesSystem::step(double alpha) {
    for_each_unknown([&](const Arrays& a, std::ptrdiff_t i, double volume) {
        a.concentration[i] += alpha * a.direction[i];
        a.residual[i] -= alpha * (volume * a.direction[i] - a.change[i]);
    });
    return residual_sums();
}

Residual SpeciesSystem::residual_sums() {
    const auto sums = sums_over_unknowns<2>([&](const Arrays& a, std::ptrdiff_t i, double volume, auto& sum) {
        const double r = a.residual[i];
        sum[0].add(r * r / (volume + a.diagonal[i]));
        sum[1].add(r * r / volume);
    });
    return {sums[0], std::sqrt(sums[1])};
}

void SpeciesSystem::turn(double beta) {
    for_each_unknown([&](const Arrays& a, std::ptrdiff_t i, double volume) {
        const double preconditioned = a.residual[i] / (volume + a.diagonal[i]);
        a.direction[i] = beta == 0 ? preconditioned : preconditioned + beta * a.direction[i];
    });
}

}  // namespace dmp::solver
