// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solver/elastic/spring_bodies.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The traction that the fluid exerts on the surfaces of elastic solids [Pa]:
///   t = sigma n,   sigma = -p I + mu (G + G^T)
/// with p at the surface, half a spacing outside the particle, and G at the particle, where the liquid does not slip:
/// the profile between a lid and a strip of two rows reaches the strip's velocity 0.07 to 0.1 spacings outside its row.
/// The outward normal n of a particle is opposite to the sum of the unit vectors towards the particles of the same body
/// that were within 1.6 spacings of it in the initial state, with their images behind planes of symmetry; where their
/// sum is shorter than 1/2, nothing is missing beside the particle and it has no surface.
///
/// p and G = grad v follow from the fluid within R = 4 spacings of the surface on the side of n, but for what is behind
/// other particles of elastic solids: functions that fit best (least squares, weighted with volume and (1 - r / R)^2),
/// of p the linear one (LinearFit), of v one that is quadratic along n and linear across it, so that a parabola has its
/// shear rate; linear along n too where fewer than three rows of fluid are there. The gradients that the scheme has of
/// the first row of fluid are not used: the solid's own velocity, which does not go on as the fluid's does, is part of
/// them.
///
/// So the two faces of a strip of two rows, and the two layers of a shell, have each their own traction.
class SurfaceTraction {
  public:
    /// Collects the fluid beside elastic solids on the first rank. All ranks together.
    SurfaceTraction(const ParticleStore& particles, const SpringBodies& springs, const Ranks& ranks);

    /// By body and node, on the first rank; none of particles without a surface, or without fluid within 1.5 spacings
    /// of it.
    [[nodiscard]] std::vector<std::vector<std::optional<Vec>>> on(const SpringBodies& springs) const;

  private:
    struct Sample {
        std::int64_t id;
        std::array<double, 3> position, velocity;  ///< as shown [m, m/s]
        double volume, pressure, viscosity;        ///< [m^3, Pa, Pa s]
    };
    struct Near {
        const Sample* sample;
        Vec x;  ///< from the surface [m]
        double weight;
    };
    [[nodiscard]] Vec traction(const std::vector<Near>& near, const Vec& normal) const;
    [[nodiscard]] Eigen::Matrix3d velocity_gradient(const std::vector<Near>& near, const Vec& normal) const;

    const ParticleSpace& space_;
    std::vector<Sample> samples_;  ///< in the order of ids
};

}  // namespace dmp::solver
