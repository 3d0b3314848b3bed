// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/disorder.hpp"

#include <sstream>

#include "base/random_number.hpp"
#include "mesher/uses.hpp"
#include "particles/periodic_images.hpp"

namespace dmp::mesher {

double Disorder::displacement(std::uint64_t id, int axis) const {
    return amplitude * (2 * random_number({seed, id, static_cast<std::uint64_t>(axis)}) - 1);
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
        if (set.kind(i) != PartKind::fluid) continue;
        Vec moved = set.position[i];
        for (int axis = 0; axis < set.dimension; ++axis) {
            moved[axis] += set.spacing * disorder.displacement(i, axis);
            if (set.periodic[axis]) moved[axis] = wrapped(moved[axis], set.box.low[axis], set.box.high[axis]);
        }
        if (may_stand(i, moved)) set.position[i] = moved;
    }
}

}  // namespace dmp::mesher
