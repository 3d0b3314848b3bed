// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"

namespace dmp::mesher {

/// Random displacements of fluid particles from their lattice.
struct Disorder {
    double amplitude = 0;    ///< largest displacement along each axis [spacings]; 0: none
    std::uint64_t seed = 1;  ///< another one, other displacements

    /// Displacement of particle `id` along an axis, evenly distributed in [-amplitude, amplitude) [spacings]. A hash of
    /// seed, id and axis, so it does not depend on how many particles there are or in which order they are asked for.
    [[nodiscard]] double displacement(std::uint64_t id, int axis) const;
    /// For the report: how far the fluid was displaced.
    [[nodiscard]] std::string text() const;
};

/// Displaces the fluid particles; one that may not stand in its new place stays in its old one.
void disturb(ParticleSet& set, const Disorder& disorder, const std::function<bool(std::size_t, const Vec&)>& may_stand);

}  // namespace dmp::mesher
