// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/forcing/driven.hpp"

#include <algorithm>

namespace dmp::solver {

bool is_driven(const Scene& scene) {
    const auto any = [](const std::array<Expression, 3>& formulas) {
        return !std::ranges::all_of(formulas, &Expression::is_zero);
    };
    return any(scene.flow.acceleration) || any(*scene.flow.pressure_gradient) || any(*scene.flow.initial_velocity) ||
           !scene.flow.initial_pressure->is_zero() || !scene.forces.empty() || !scene.moving_shapes.empty() ||
           std::ranges::any_of(scene.parts_of(PartKind::rigid),
                               [](const Part* wall) { return wall->slides() || wall->moves(); });
}

bool is_at_rest(const Scene& scene) {
    return !scene.species.empty() && !is_driven(scene) && !scene.may_have_elastic() && scene.solidify.empty();
}

}  // namespace dmp::solver
