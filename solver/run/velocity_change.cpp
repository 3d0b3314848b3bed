// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/velocity_change.hpp"

#include <array>
#include <cmath>

#include "base/number_text.hpp"
#include "solver/parallel/exact_sum.hpp"

namespace dmp::solver {

namespace {

constexpr double coarse = 0.4;
constexpr double many_times = 10;

/// 2 D : D of a particle's velocity gradient.
double rate_square(const ParticleGroup& fluid, std::size_t i) {
    const int dimension = fluid.dimension();
    double sum = 0;
    for (int a = 0; a < dimension; ++a)
        for (int b = 0; b < dimension; ++b) {
            const double rate = 0.5 * (fluid.data(Field::velocity_gradient, a * dimension + b)[i] +
                                       fluid.data(Field::velocity_gradient, b * dimension + a)[i]);
            sum += 2 * rate * rate;
        }
    return sum;
}

double speed_square(const ParticleGroup& fluid, std::size_t i) {
    double sum = 0;
    for (int axis = 0; axis < fluid.dimension(); ++axis) {
        const double v = fluid.data(Field::velocity, axis)[i];
        sum += v * v;
    }
    return sum;
}

}  // namespace

void VelocityChange::add(const ParticleStore& particles, const Ranks& ranks, double t) {
    const ParticleGroup& fluid = particles.fluid();
    if (!fluid.has(Field::velocity_gradient)) return;
    std::array<ExactSum, 2> sums;
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        sums[0].add(rate_square(fluid, i));
        sums[1].add(speed_square(fluid, i));
    }
    ranks.sum(sums);
    rates_ += sums[0].value() * (t - added_until_);
    speeds_ += sums[1].value() * (t - added_until_);
    added_until_ = t;
}

std::optional<double> VelocityChange::value(double spacing) const {
    if (!(speeds_ > 0)) return std::nullopt;
    return spacing * std::sqrt(rates_ / speeds_);
}

std::optional<Warning> VelocityChange::warning(const Scene& scene) const {
    const std::optional<double> change = value(scene.particles.spacing);
    if (!change || *change <= coarse) return std::nullopt;
    return Warning{"particles.spacing", scene.particles.spacing.location,
                   "is coarse for this flow: from one particle to the next the velocity changed by " +
                       (*change < many_times ? number_text(100 * *change, 3) + " % of itself" : "many times itself") +
                       " (root mean square over fluid and time)",
                   "compare with half the spacing (docs/accuracy.md, \"How coarse\")"};
}

void VelocityChange::archive(Archive& file) {
    file("velocity_change/rates", rates_);
    file("velocity_change/speeds", speeds_);
    file("velocity_change/until", added_until_);
}

}  // namespace dmp::solver
