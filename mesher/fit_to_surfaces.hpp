// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"

namespace dmp::mesher {

/// The nearest point of the surface that a particle may not cross, and the unit vector from it to the particle's side.
struct SurfaceHold {
    Vec point = Vec::Zero();
    Vec to_particle = Vec::UnitX();
};
/// Of particle i at a place; nothing where no surface is nearer than two spacings.
using HoldOf = std::function<std::optional<SurfaceHold>(std::size_t i, const Vec& position)>;

/// How a fit ended.
struct Fit {
    int iterations = 0;
    double spread = 0;         ///< standard deviation of SUM V W over the fluid, as a share of the mean
    double last_move = 0;      ///< root mean square of the last moves [spacings]
    double surface_error = 0;  ///< root mean square of how far the layer at a surface is from half a spacing [spacings]
    double largest_surface_error = 0;  ///< [spacings]
    std::size_t at_surface = 0;        ///< particles of that layer
};

/// Moves particles until they follow the surfaces that bound them: what was at most a spacing
/// from a surface goes to half a spacing from it, on both of its sides, and all spread evenly. Steepest descent on the
/// sum that particle shifting uses, as in the relaxation of Zhu, Zhang & Hu, J. Hydrodyn. 33 (2021) 195, with the layer
/// at the surface held in place along the surface's normal instead of pushed there. Ends when the moves are small,
/// `settled`, and the fluid's kernel sums even to within 1 %, or after `most_iterations`.
/// @param support  the kernel's support radius [m]
/// @param held     by particle: 1 stays where it is
Fit fit_to_surfaces(ParticleSet& set, double support, const std::vector<std::uint8_t>& held, const HoldOf& hold_of,
                    int threads, double settled = 2e-3, int most_iterations = 250);

}  // namespace dmp::mesher
