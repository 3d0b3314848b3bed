// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/velocity_gradient.hpp"

#include <Eigen/LU>
#include <cmath>

namespace dmp {

namespace {

Vec at(const ParticleGroup& group, Field field, std::int32_t i) {
    Vec value = Vec::Zero();
    for (int axis = 0; axis < group.dimension(); ++axis) value[axis] = group.data(field, axis)[i];
    return value;
}

}  // namespace

std::vector<double> shear_stress(const ParticleStore& particles, const ClusterList& list, const PairSweeps& sweeps) {
    const ParticleGroup& fluid = particles.fluid();
    std::vector<double> stress(fluid.owned(), 0.0);
    const auto clusters = list.clusters(ParticleKind::fluid);
    for (std::size_t c = 0; c < clusters.size(); ++c) {
        for (std::int32_t i = clusters[c].first; i < clusters[c].first + clusters[c].count; ++i) {
            const Vec x = at(fluid, Field::position, i), v = at(fluid, Field::velocity, i);
            Eigen::Matrix3d moments = Eigen::Matrix3d::Zero(), gradient = Eigen::Matrix3d::Zero();
            for (const std::int32_t j : list.neighbours(ParticleKind::fluid, c, ParticleKind::fluid)) {
                const Vec offset = at(fluid, Field::position, j) - x;
                const double weight = fluid.data(Field::volume)[j] * -sweeps.kernel_slope(offset.norm());
                if (weight == 0) continue;
                moments += weight * offset * offset.transpose();
                gradient += weight * (at(fluid, Field::velocity, j) - v) * offset.transpose();
            }
            if (particles.dimension() == 2) moments(2, 2) = 1;
            // The moments of a full neighbourhood are the unit matrix.
            if (moments.determinant() < 1e-3) continue;
            gradient = gradient * moments.inverse();
            const Eigen::Matrix3d rate = 0.5 * (gradient + gradient.transpose());
            stress[i] = fluid.data(Field::viscosity)[i] * std::sqrt(2 * rate.squaredNorm());
        }
    }
    return stress;
}

}  // namespace dmp
