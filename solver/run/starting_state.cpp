// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/starting_state.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/errors.hpp"

namespace dmp::solver {

namespace {

bool has_velocity(const Scene& scene) {
    const auto& axes = *scene.flow.initial_velocity;
    return !std::all_of(axes.begin(), axes.end(), [](const Expression& axis) { return axis.is_zero(); });
}

[[noreturn]] void refuse(const SourceLocation& location, const std::string& key, double value, const char* unit,
                         const Vec& at, const std::string& why, const std::string& what_to_do) {
    std::ostringstream problem;
    problem << key << " is " << value << ' ' << unit << " at x = " << at[0] << ", y = " << at[1] << ", z = " << at[2]
            << " m" << why;
    throw InputError(location, problem.str(), what_to_do);
}

/// Density at the starting pressure [kg/m^3].
double density_at(const Scene& scene, const LiquidState& state, const Vec& at) {
    const Expression& formula = scene.flow.initial_pressure;
    const double pressure = formula(0, at[0], at[1], at[2]);
    if (!(pressure > state.lowest_pressure() && std::isfinite(pressure))) {
        std::ostringstream why;
        why << "; the equation of state knows pressures above " << state.lowest_pressure() << " Pa";
        refuse(scene.flow.initial_pressure.location, "flow.initial_pressure", pressure, "Pa", at, why.str(),
               "correct the formula, or choose a higher numerics.sound_speed");
    }
    return state.density(pressure);
}

Vec velocity_at(const Scene& scene, const LiquidState& state, const Vec& at, int dimension) {
    Vec velocity = Vec::Zero();
    for (int axis = 0; axis < dimension; ++axis)
        velocity[axis] = (*scene.flow.initial_velocity)[static_cast<std::size_t>(axis)](0, at[0], at[1], at[2]);
    const double speed = velocity.norm();
    if (!(speed < state.sound_speed)) {
        std::ostringstream why;
        why << "; the fluid's sound travels at " << state.sound_speed << " m/s";
        refuse(scene.flow.initial_velocity.location, "the speed of flow.initial_velocity", speed, "m/s", at, why.str(),
               "correct the formula, or choose a higher numerics.sound_speed");
    }
    return velocity;
}

}  // namespace

bool has_starting_state(const Scene& scene) { return has_velocity(scene) || !scene.flow.initial_pressure->is_zero(); }

ParticleStore starting_particles(const Scene& scene, const ParticleSet& set, const std::vector<LiquidState>& states,
                                 const Ranks& ranks) {
    std::vector<double> rest_density;
    rest_density.reserve(states.size());
    for (const LiquidState& state : states) rest_density.push_back(state.rest_density);
    ParticleStore particles(set, rest_density, ranks);
    ParticleGroup& fluid = particles.fluid();
    const bool moves = has_velocity(scene), is_pressed = !scene.flow.initial_pressure->is_zero();
    for (std::size_t i = 0; (moves || is_pressed) && i < fluid.owned(); ++i) {
        const LiquidState& state = states[fluid.tags()[i].part];
        const Vec& at = set.position[static_cast<std::size_t>(fluid.tags()[i].id)];
        if (is_pressed) fluid.data(Field::mass)[i] = density_at(scene, state, at) * fluid.data(Field::volume)[i];
        if (!moves) continue;
        const Vec velocity = velocity_at(scene, state, at, set.dimension);
        for (int axis = 0; axis < set.dimension; ++axis) fluid.data(Field::velocity, axis)[i] = velocity[axis];
    }
    return particles;
}

void fill_starting_density(const Scene& scene, const ParticleSet& set, const std::vector<LiquidState>& states,
                           ParticleStore& particles) {
    ParticleGroup& fluid = particles.fluid();
    if (scene.flow.initial_pressure->is_zero() || !fluid.has(Field::density)) return;
    for (std::size_t i = 0; i < fluid.owned(); ++i)
        fluid.data(Field::density)[i] =
            density_at(scene, states[fluid.tags()[i].part], set.position[static_cast<std::size_t>(fluid.tags()[i].id)]);
}

}  // namespace dmp::solver
