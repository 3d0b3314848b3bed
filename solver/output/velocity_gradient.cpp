// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/velocity_gradient.hpp"

#include <Eigen/LU>
#include <cmath>

#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

namespace {

using Matrix = Eigen::Matrix3d;

/// One vector field of a group.
class Vectors {
  public:
    Vectors(const ParticleGroup& group, Field field)
        : x_(group.data(field, 0)),
          y_(group.data(field, 1)),
          z_(group.dimension() == 3 ? group.data(field, 2) : nullptr) {}
    Vec operator[](std::int32_t i) const { return {x_[i], y_[i], z_ != nullptr ? z_[i] : 0.0}; }

  private:
    const double *x_, *y_, *z_;
};

/// Adds a b^T, each number rounded, of the axes that there are.
void add_rounded(Matrix& sum, const ReproducibleSum& rounded, const Vec& a, const Vec& b, int dimension) {
    for (int row = 0; row < dimension; ++row)
        for (int column = 0; column < dimension; ++column) sum(row, column) += rounded(a[row] * b[column]);
}

/// Those that the corrected scheme keeps.
std::vector<Matrix> kept_gradients(const ParticleGroup& fluid) {
    const int dimension = fluid.dimension();
    std::vector<Matrix> gradients(fluid.owned(), Matrix::Zero());
    for (std::size_t i = 0; i < fluid.owned(); ++i)
        for (int k = 0; k < dimension * dimension; ++k)
            gradients[i](k / dimension, k % dimension) = fluid.data(Field::velocity_gradient, k)[i];
    return gradients;
}

}  // namespace

std::vector<Matrix> velocity_gradient(const ParticleStore& particles, const FluidStep& step) {
    if (particles.fluid().has(Field::velocity_gradient)) return kept_gradients(particles.fluid());
    const double largest_speed = step.extremes().largest_speed;
    const ParticleGroup& fluid = particles.fluid();
    std::vector<Matrix> gradients(fluid.owned(), Matrix::Zero());
    if (largest_speed == 0) return gradients;
    // The moments of a full neighbourhood are the unit matrix. A state that has diverged may hold anything.
    const ReproducibleSum round_moment(1);
    const ReproducibleSum round_gradient(std::isfinite(largest_speed) ? largest_speed / particles.space().spacing : 1);
    const int dimension = particles.dimension();
    const Vectors position(fluid, Field::position), velocity(fluid, Field::velocity);
    const double* const volume = fluid.data(Field::volume);
    const ClusterList& list = step.neighbours().list();
    const auto clusters = list.clusters(PartKind::fluid);
    const auto count = static_cast<std::ptrdiff_t>(clusters.size());
#pragma omp parallel for num_threads(step.threads()) schedule(static)
    for (std::ptrdiff_t c = 0; c < count; ++c) {
        for (std::int32_t i = clusters[c].first; i < clusters[c].first + clusters[c].count; ++i) {
            const Vec x = position[i], v = velocity[i];
            Matrix moments = Matrix::Zero(), sum = Matrix::Zero();
            for (const std::int32_t j :
                 list.neighbours(PartKind::fluid, static_cast<std::size_t>(c), PartKind::fluid)) {
                const Vec offset = position[j] - x;
                const double weight = volume[j] * -step.sweeps().kernel_slope(offset.norm());
                if (weight == 0) continue;
                add_rounded(moments, round_moment, weight * offset, offset, dimension);
                add_rounded(sum, round_gradient, velocity[j] - v, weight * offset, dimension);
            }
            if (dimension == 2) moments(2, 2) = 1;
            if (moments.determinant() < 1e-3) continue;
            gradients[i] = sum * moments.inverse();
        }
    }
    return gradients;
}

}  // namespace dmp::solver
