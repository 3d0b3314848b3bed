// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/sphere_energy.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/number_text.hpp"

namespace dmp::solver {

namespace {

constexpr double growth_that_counts = 0.01;

}  // namespace

double energy_in_contacts(const SphereStep& step, const Ranks& ranks) {
    const ContactList& list = step.neighbours().list();
    const auto motion = step.rows().motion();
    const auto owned = static_cast<std::int32_t>(step.rows().owned());
    ExactSum energy = step.walls().contact_energy(step.rows(), step.group().tags());
    list.for_each([&](std::size_t k, std::int16_t kind) {
        const std::int32_t i = list.low()[k], j = list.high()[k];
        if (i >= owned) return;  // counted by the rank that owns the sphere of the lower id
        const double *a = motion[i].position.c, *b = motion[j].position.c;
        const double overlap = a[3] + b[3] - std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
        const SpherePair& pair = step.setup().pairs[static_cast<std::size_t>(kind)];
        energy.add(
            contact_energy(pair.model, pair.constants, overlap, a[3] * b[3] / (a[3] + b[3]), list.history_of(k)));
    });
    ranks.sum(energy);
    return energy.value();
}

namespace {

/// A pair whose tangential law adds energy of its own, with any step; null if there is none.
const ContactPair* pair_that_gains(const SphereSetup& setup) {
    for (const auto* pairs : {&setup.pairs, &setup.wall_pairs})
        for (const SpherePair& pair : *pairs)
            if (!pair.model.tangential.visit([]<class Law>() { return Law::conserves_energy; })) return pair.asked;
    return nullptr;
}

}  // namespace

std::optional<Warning> grown_energy(const Scene& scene, const SphereSetup& setup, const SphereEnergy& start,
                                    const SphereEnergy& end) {
    const double grown = end.total() - start.total();
    if (!(grown > growth_that_counts * std::max(start.kinetic(), end.kinetic()))) return std::nullopt;
    const std::string from_to = "the energy of spheres and contacts grew from " + number_text(start.total(), 4) +
                                " J to " + number_text(end.total(), 4) + " J, though nothing drives them";
    if (const ContactPair* pair = pair_that_gains(setup))
        return Warning{
            "contact_pair.tangential", pair->tangential.location,
            "is \"" + to_string(*pair->tangential) + "\", which adds energy to contacts that grow: " + from_to,
            "write \"mindlin\", unless another program's results are to be reproduced"};
    const auto& numerics = scene.numerics;
    const bool by_hand = *numerics.contact_step > 0;
    const std::string problem = (by_hand ? "is too long, at " + number_text(numerics.contact_step) + " s"
                                         : "is too small, at " + number_text(numerics.steps_per_contact)) +
                                ": " + from_to;
    return Warning{by_hand ? "numerics.contact_step" : "numerics.steps_per_contact",
                   by_hand ? numerics.contact_step.location : numerics.steps_per_contact.location, problem,
                   by_hand ? "give half of it, or \"auto\"" : "give twice as many"};
}

}  // namespace dmp::solver
