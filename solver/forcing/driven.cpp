// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/forcing/driven.hpp"

#include <algorithm>

namespace dmp::solver {

bool elastic_solids_start_moving(const Scene& scene) {
    return std::ranges::any_of(scene.parts_of(PartKind::elastic), [](const Part* part) {
        return !std::ranges::all_of(*part->initial_velocity, &Expression::is_zero);
    });
}

bool is_driven(const Scene& scene) {
    const auto any = [](const std::array<Expression, 3>& formulas) {
        return !std::ranges::all_of(formulas, &Expression::is_zero);
    };
    const auto moves = [](const Part* wall) { return wall->slides() || wall->moves(); };
    const auto any_moves = [&](PartKind kind) { return std::ranges::any_of(scene.parts_of(kind), moves); };
    return any(scene.flow.acceleration) || any(*scene.flow.pressure_gradient) || any(*scene.flow.initial_velocity) ||
           !scene.flow.initial_pressure->is_zero() || !scene.forces.empty() || !scene.moving_shapes.empty() ||
           elastic_solids_start_moving(scene) || any_moves(PartKind::rigid) || any_moves(PartKind::plane) ||
           any_moves(PartKind::surface);
}

bool is_at_rest(const Scene& scene) {
    return !scene.species.empty() && *scene.numerics.species_stepping == SpeciesStepping::explicitly &&
           !is_driven(scene) && !scene.may_have_elastic() && scene.solidify.empty();
}

}  // namespace dmp::solver
