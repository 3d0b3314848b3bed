// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solver/time/fluid_step.hpp"

namespace dmp::solver {

/// Velocity gradient of each fluid particle of this rank, G_kl = dv_k/dx_l [1/s], in the store's order. With the
/// corrected scheme it is that of its viscous force (models/sph/velocity_gradient.hpp), in which walls and elastic
/// solids take part. With the plain scheme
///   G_i = [SUM_j V_j (v_j - v_i) (x) grad_i W_ij] M_i^-1,   M_i = SUM_j V_j (x_j - x_i) (x) grad_i W_ij
/// Exact for linear fields, however the particles lie (kernel-gradient correction of Bonet & Lok 1999). It uses fluid
/// neighbours alone, so it is one-sided at walls. Particles with too few neighbours for a gradient (a droplet of one or
/// two) have none: 0. The same bits for any order of neighbours; all ranks take part.
std::vector<Eigen::Matrix3d> velocity_gradient(const ParticleStore& particles, const FluidStep& step);

}  // namespace dmp::solver
