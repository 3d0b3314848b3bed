// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/time/implicit_system.hpp"

namespace dmp {

namespace {

/// Adds `share` of the symmetric part of F (x) r.
void add_product(std::array<double, 3>& virial, double share, const Vector<double, 2>& force,
                 const Vector<double, 2>& reach) {
    virial[0] += share * force[0] * reach[0];
    virial[1] += share * force[1] * reach[1];
    virial[2] += share * 0.5 * (force[0] * reach[1] + force[1] * reach[0]);
}

}  // namespace

std::vector<std::array<double, 3>> SpringBody::virial() const {
    std::vector<std::array<double, 3>> virial(ids_.size());
    const Vector<double, 2> at_rest{};
    for (const LocalBond& bond : bonds_) {
        const auto reach = position_[bond.a] - position_[bond.b];
        const auto force = bond.force.law(reach, at_rest);
        for (const int node : {bond.a, bond.b}) add_product(virial[node], 0.5, force, reach);
    }
    for (const LocalHinge& hinge : hinges_) {
        const auto a = position_[hinge.a] - position_[hinge.centre], b = position_[hinge.b] - position_[hinge.centre];
        const auto force = hinge.force.law({a, at_rest}, {b, at_rest});
        for (const int node : {hinge.a, hinge.centre, hinge.b}) {
            add_product(virial[node], 1.0 / 3, force.on_a, a);
            add_product(virial[node], 1.0 / 3, force.on_b, b);
        }
    }
    return virial;
}

}  // namespace dmp
