// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic/implicit_system.hpp"

namespace dmp::solver {

namespace {

/// Adds the symmetric part of share F (x) r.
void add_product(std::array<double, 6>& virial, double share, const Vec& force, const Vec& reach) {
    const auto part = [&](int i, int j) { return share * 0.5 * (force[i] * reach[j] + force[j] * reach[i]); };
    for (int axis = 0; axis < 3; ++axis) {
        virial[axis] += part(axis, axis);
        virial[3 + axis] += axis < 2 ? part(axis, axis + 1) : part(0, 2);
    }
}

}  // namespace

template <int D>
std::vector<std::array<double, 6>> SpringNetwork<D>::virial() const {
    std::vector<std::array<double, 6>> virial(ids_.size());
    for_each_spring([&](const auto& spring) {
        const auto arms = spring.arms_at(position_);
        const auto [value, gradient] = spring.law.deviation(arms);
        const double tension = 2 * spring.law.stiffness * value, share = 1.0 / static_cast<double>(spring.node.size());
        for (const int node : spring.node)
            for (std::size_t k = 0; k < arms.size(); ++k)
                add_product(virial[node], -tension * share, in_space(gradient[k]), in_space(arms[k]));
    });
    return virial;
}

template class SpringNetwork<2>;
template class SpringNetwork<3>;

}  // namespace dmp::solver
