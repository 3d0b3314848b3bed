// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/velocity_gradient.hpp"

#include <Eigen/LU>
#include <cmath>

namespace dmp {

namespace {

Vec at(const ParticleStore& particles, Field field, int i) {
    Vec value = Vec::Zero();
    for (int axis = 0; axis < particles.dimension(); ++axis) value[axis] = particles.data(field, axis)[i];
    return value;
}

}  // namespace

std::vector<double> shear_stress(const ParticleStore& particles, const ClusterList& list, const PairSweeps& sweeps) {
    const int dimension = particles.dimension();
    std::vector<double> by_particle(particles.owned(), 0.0);
    for (const Cluster& cluster : list.clusters(ParticleKind::fluid)) {
        for (std::size_t k = 0; k < cluster.count; ++k) {
            const int i = cluster.member[k];
            const Vec x = at(particles, Field::position, i), v = at(particles, Field::velocity, i);
            Eigen::Matrix3d moments = Eigen::Matrix3d::Zero(), gradient = Eigen::Matrix3d::Zero();
            for (const int j : list.neighbours(cluster, ParticleKind::fluid)) {
                const Vec offset = at(particles, Field::position, j) - x;
                const double weight = particles.data(Field::volume)[j] * -sweeps.kernel_slope(offset.norm());
                if (weight == 0) continue;
                moments += weight * offset * offset.transpose();
                gradient += weight * (at(particles, Field::velocity, j) - v) * offset.transpose();
            }
            if (dimension == 2) moments(2, 2) = 1;
            // The moments of a full neighbourhood are the unit matrix.
            if (moments.determinant() < 1e-3) continue;
            gradient = gradient * moments.inverse();
            const Eigen::Matrix3d rate = 0.5 * (gradient + gradient.transpose());
            by_particle[i] = particles.data(Field::viscosity)[i] * std::sqrt(2 * rate.squaredNorm());
        }
    }
    std::vector<double> stress;
    for (const int i : particles.ids(ParticleKind::fluid)) stress.push_back(by_particle[i]);
    return stress;
}

}  // namespace dmp
