// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/steady_state.hpp"

#include <cmath>

namespace dmp::solver {

namespace {

/// Looks in the time that nothing may change.
constexpr int prunings_in_window = 20;
constexpr double change_that_counts = 1e-3;

/// The last step of MurmurHash3.
std::uint64_t stirred(std::uint64_t bits) {
    for (const std::uint64_t factor : {0xff51afd7ed558ccdULL, 0xc4ceb9fe1a85ec53ULL}) {
        bits ^= bits >> 33;
        bits *= factor;
    }
    return bits ^ (bits >> 33);
}

}  // namespace

std::int64_t fingerprint_of_contacts(const SphereStep& step, const Ranks& ranks) {
    const ContactList& list = step.neighbours().list();
    const auto motion = step.rows().motion();
    const auto tags = step.group().tags();
    const auto owned = static_cast<std::int32_t>(step.rows().owned());
    std::uint64_t sum = 0;
    list.for_each([&](std::size_t k, std::int16_t) {
        const std::int32_t i = list.low()[k], j = list.high()[k];
        if (i >= owned) return;
        const double *a = motion[i].position.c, *b = motion[j].position.c;
        const double dx = a[0] - b[0], dy = a[1] - b[1], dz = a[2] - b[2], touch = a[3] + b[3] + step.setup().reach;
        if (dx * dx + dy * dy + dz * dz >= touch * touch) return;
        sum += stirred(stirred(static_cast<std::uint64_t>(tags[i].id)) + static_cast<std::uint64_t>(tags[j].id));
    });
    for (const WallContact& contact : step.walls().contacts())
        sum += stirred(~stirred(static_cast<std::uint64_t>(contact.id)) + static_cast<std::uint64_t>(contact.part));
    // Sums of ranks wrap around as they would on one.
    std::uint64_t all = 0;
    for (const std::uint64_t part : ranks.all_gather(std::vector{sum})) all += part;
    return static_cast<std::int64_t>(all >> 2);
}

SphereEnergy kinetic_energy(const SphereStep& step, const Ranks& ranks) {
    ExactSum translation, rotation;
    for (const SphereMotion& sphere : step.rows().motion().first(step.rows().owned())) {
        if (sphere.fixed()) continue;
        const double *v = sphere.velocity.c, *w = sphere.spin.c;
        translation.add(0.5 * v[3] * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
        rotation.add(0.2 * v[3] * sphere.radius() * sphere.radius() * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]));
    }
    ranks.sum(translation);
    ranks.sum(rotation);
    return {translation.value(), rotation.value()};
}

void SteadyState::update(double time, const SphereStep& step, const Ranks& ranks) {
    if (!wanted() || time < next_check_) return;
    next_check_ = time + window_ / prunings_in_window;
    const std::int64_t contacts = fingerprint_of_contacts(step, ranks);
    const double energy = kinetic_energy(step, ranks).kinetic();
    largest_energy_ = std::max(largest_energy_, energy);
    if (contacts != contacts_then_ || std::abs(energy - energy_then_) > change_that_counts * largest_energy_) {
        contacts_then_ = contacts;
        energy_then_ = energy;
        quiet_since_ = time;
    } else if (time >= quiet_since_ + window_) {
        reached_ = time;
    }
}

void SteadyState::archive(Archive& file) {
    if (!wanted()) return;
    file("stillness/next_look", next_check_);
    file("stillness/quiet_since", quiet_since_);
    file("stillness/energy_then", energy_then_);
    file("stillness/largest_energy", largest_energy_);
    file("stillness/contacts_then", contacts_then_);
    file("stillness/reached", reached_);
}

}  // namespace dmp::solver
