// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/fourier_mode.hpp"

#include <cmath>
#include <numbers>

#include "solver/output/probe.hpp"
#include "solver/parallel/exact_sum.hpp"

namespace dmp::solver {

double FourierMode::spacings() const {
    double square = 0;  // of the waves in a length of 1 m
    for (int axis = 0; axis < space_.dimension; ++axis) {
        const double waves = waves_[axis] / (space_.box.high[axis] - space_.box.low[axis]);
        square += waves * waves;
    }
    return 1 / (std::sqrt(square) * space_.spacing);
}

std::vector<double> FourierMode::of(const FluidValues& array, const ParticleGroup& fluid, const Ranks& ranks) const {
    const double* volume = fluid.data(Field::volume);
    const auto phase = [&](std::size_t i) {
        double turns = 0;
        for (int axis = 0; axis < space_.dimension; ++axis)
            turns += waves_[axis] * (fluid.data(Field::position, axis)[i] - space_.box.low[axis]) /
                     (space_.box.high[axis] - space_.box.low[axis]);
        return 2 * std::numbers::pi * turns;
    };
    const auto total = [&ranks](ExactSum& sum) {
        ranks.sum(sum);
        return sum.value();
    };
    ExactSum all;
    for (std::size_t i = 0; i < fluid.owned(); ++i) all.add(volume[i]);
    const double whole = total(all);

    std::vector<double> factors;
    for (const std::size_t c : probed_components(array.components, space_.dimension)) {
        const auto value = [&](std::size_t i) { return array.values[i * array.components + c]; };
        ExactSum sum, with_cos, with_sin;
        for (std::size_t i = 0; i < fluid.owned(); ++i) sum.add(volume[i] * value(i));
        const double mean = total(sum) / whole;
        for (std::size_t i = 0; i < fluid.owned(); ++i) {
            const double weighted = volume[i] * (value(i) - mean);
            const double angle = phase(i);
            with_cos.add(weighted * std::cos(angle));
            with_sin.add(weighted * std::sin(angle));
        }
        factors.push_back(2 * total(with_cos) / whole);
        factors.push_back(2 * total(with_sin) / whole);
    }
    return factors;
}

}  // namespace dmp::solver
