// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/disorder.hpp"

#include <sstream>

#include "particles/periodic_images.hpp"

namespace dmp {

namespace {

/// The mixing function of the generator SplitMix64 (Steele, Lea & Flood 2014).
std::uint64_t mixed(std::uint64_t bits) {
    bits += 0x9e3779b97f4a7c15U;
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31U);
}

}  // namespace

double Disorder::displacement(std::uint64_t id, int axis) const {
    const std::uint64_t bits = mixed(mixed(mixed(seed) ^ id) ^ static_cast<std::uint64_t>(axis));
    const double in_unit_interval = static_cast<double>(bits >> 11U) * 0x1p-53;
    return amplitude * (2 * in_unit_interval - 1);
}

std::string Disorder::text() const {
    std::ostringstream text;
    text << "fluid particles displaced at random by up to " << amplitude << " spacings along each axis, seed " << seed;
    return text.str();
}

void disturb(ParticleSet& set, const Disorder& disorder,
             const std::function<bool(std::size_t, const Vec&)>& may_stand) {
    if (disorder.amplitude == 0) return;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != ParticleKind::fluid) continue;
        Vec moved = set.position[i];
        for (int axis = 0; axis < set.dimension; ++axis) {
            moved[axis] += set.spacing * disorder.displacement(i, axis);
            if (set.periodic[axis]) moved[axis] = wrapped(moved[axis], set.box.low[axis], set.box.high[axis]);
        }
        if (may_stand(i, moved)) set.position[i] = moved;
    }
}

}  // namespace dmp
