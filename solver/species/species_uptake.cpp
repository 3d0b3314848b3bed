// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/species/species_uptake.hpp"

#include <cstddef>

#include "solver/store/sums_over.hpp"
#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

SpeciesUptake::SpeciesUptake(int species, const std::vector<double>& rates, double largest_amount, int threads)
    : species_(species), largest_amount_(largest_amount), threads_(threads) {
    for (std::size_t part = 0; part < rates.size(); ++part)
        if (rates[part] > 0) parts_.push_back({static_cast<std::uint16_t>(part), {rates[part]}, {}});
}

void SpeciesUptake::take(ParticleStore& particles, double dt, When when) {
    const ReproducibleSum whole(largest_amount_);
    for (OfPart& of : parts_) {
        const double lost = 1 - (when == When::before_supply ? of.law.left_before(dt) : of.law.left_after(dt));
        for (ParticleGroup& group : particles.groups()) {
            if (!group.has(Field::species_amount)) continue;
            double* amount = group.data(Field::species_amount, species_);
            const auto [sum] = sums_of_multiples<1>(group, threads_, [&, amount](std::ptrdiff_t i, auto& taken) {
                if (group.tags()[static_cast<std::size_t>(i)].part != of.part) return;
                const double share = whole(lost * amount[i]);
                amount[i] -= share;
                taken[0] += share;
            });
            of.taken.add(sum);
        }
    }
}

double SpeciesUptake::share_kept(std::uint16_t part, double dt) const {
    for (const OfPart& of : parts_)
        if (of.part == part) return of.law.left_after(dt);
    return 1;
}

double SpeciesUptake::taken(const Ranks& ranks, std::optional<std::uint16_t> part) const {
    ExactSum sum;
    for (const OfPart& of : parts_)
        if (!part || of.part == *part) sum.add(of.taken);
    ranks.sum(sum);
    return sum.value();
}

void SpeciesUptake::archive(Archive& file, const std::string& name, const Ranks& ranks) {
    // Whole quanta in two doubles: up to 2^60 of the largest amounts.
    for (OfPart& of : parts_) {
        ExactSum all = of.taken;
        ranks.sum(all);
        const double most = all.value();
        all.add(-most);
        std::vector<double> values{most, all.value()};
        file("taken_up/" + name + "/" + std::to_string(of.part), values);
        // Once in the sum over ranks.
        if (file.loading()) of.taken = ranks.is_first() ? ExactSum(values) : ExactSum();
    }
}

}  // namespace dmp::solver
