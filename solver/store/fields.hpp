// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace dmp::solver {

/// The per-particle arrays that a model can declare.
enum class Field {
    position,
    velocity,
    density,
    density_rate,
    mass,
    viscosity,
    wall_normal,
    wall_distance,
    opposite_distance,
    held,
    wall_slip,
    wall_acceleration,
    wall_motion,
    wall_sliding,
    surface_gradient,
    initial_position,
    initial_normal,
    contact_range,
    wall_contact_range,
    volume,
    residence_time,
    pressure,
    force,
    shift,
    off_walls,
    correction,
    correction_off_diagonal,
    mean_correction,
    velocity_gradient,
    density_gradient,
    next_density_gradient,
    fluid_number,
    reduced_pressure,
    whole_pressure,
    level_force,
    chamber,
    transport_velocity,
    viscous_force,
    viscous_velocity,
    viscous_residual,
    viscous_direction,
    viscous_diagonal,
    species_amount,
    concentration,
    species_diffusivity,
    species_wall,
    species_change,
    species_residual,
    species_direction,
    species_diagonal,
    radius,
    angular_velocity,
    contact_force,
    contact_torque,
    count  // number of fields
};

using FieldList = std::vector<Field>;

/// Scalar, vector or tensor of second order. A tensor has the arrays xx, xy, (xz,) yx, ...
enum class FieldShape { scalar, vector, tensor };

struct FieldInfo {
    std::string_view name;
    std::string_view unit;
    FieldShape shape;
    /// True: the value moves with the particle when it is sorted, sent to another rank or saved. False: it is
    /// recomputed before use.
    bool is_state;
    /// The model that needs the field, or a part of its name (ModelUse::model); empty if several need it.
    std::string_view needed_by{};
};

inline constexpr std::array<FieldInfo, static_cast<std::size_t>(Field::count)> make_field_info() {
    using enum FieldShape;
    return {{
        {"position", "m", vector, true},
        {"velocity", "m/s", vector, true},
        {"density", "kg/m^3", scalar, true},
        {"density_rate", "kg/m^3/s", scalar, true, "continuity"},
        {"mass", "kg", scalar, true},
        {"viscosity", "Pa*s", scalar, true, "viscous force"},
        {"wall_normal", "1", vector, true, "walls"},
        {"wall_distance", "m", scalar, true, "walls"},
        {"opposite_distance", "m", scalar, true, "walls"},
        {"held", "1", scalar, true, "walls"},
        {"wall_slip", "1", scalar, true, "walls"},
        {"wall_acceleration", "m/s^2", vector, true, "walls"},
        {"wall_motion", "m/s", vector, true, "walls"},
        {"wall_sliding", "1", scalar, true, "walls"},
        {"surface_gradient", "1/s", tensor, true, "walls"},
        {"drawn_position", "m", vector, true, "walls"},
        {"drawn_normal", "1", vector, true, "walls"},
        {"contact_range", "m", scalar, true, "short-range repulsion"},
        {"wall_contact_range", "m", scalar, true, "short-range repulsion"},
        {"volume", "m^3", scalar, true},
        {"residence_time", "s", scalar, true, "residence times"},
        {"pressure", "Pa", scalar, false, "equation of state"},
        {"force", "N", vector, false},
        {"shift", "1/m", vector, false, "shifting"},
        {"off_walls", "1", vector, false, "shifting"},
        {"correction", "1", vector, false, "gradient correction"},
        {"correction_off_diagonal", "1", vector, false, "gradient correction"},
        {"mean_correction", "1", scalar, true, "velocity gradient"},
        {"velocity_gradient", "1/s", tensor, true, "velocity gradient"},
        {"density_gradient", "kg/m^4", vector, true, "density diffusion"},
        {"next_density_gradient", "kg/m^4", vector, false, "density diffusion"},
        {"fluid_number", "1", scalar, true, "density diffusion"},
        {"reduced_pressure", "Pa", scalar, false, "pressure level"},
        {"whole_pressure", "1", scalar, true, "pressure level"},
        {"level_force", "N", vector, false, "pressure level"},
        {"chamber", "1", scalar, true, "pressure level"},
        {"transport_velocity", "m/s", vector, true, "transport velocity"},
        {"viscous_force", "N", vector, false, "implicit viscosity"},
        {"viscous_velocity", "m/s", vector, false, "implicit viscosity"},
        {"viscous_residual", "N", vector, false, "implicit viscosity"},
        {"viscous_direction", "m/s", vector, false, "implicit viscosity"},
        {"viscous_diagonal", "kg/s", vector, false, "implicit viscosity"},
        // Fields of species: one array per species, in its units.
        {"species_amount", "1", scalar, true, "diffusion of"},
        {"concentration", "1", scalar, false, "diffusion of"},
        {"species_diffusivity", "m^2/s", scalar, true, "diffusion of"},
        {"species_wall", "1", scalar, true, "diffusion of"},
        {"species_change", "1", scalar, false, "diffusion of"},
        {"species_residual", "1", scalar, false, "implicit diffusion"},
        {"species_direction", "1", scalar, false, "implicit diffusion"},
        {"species_diagonal", "m^3/s", scalar, false, "implicit diffusion"},
        {"radius", "m", scalar, true, "spheres"},
        {"angular_velocity", "rad/s", vector, true, "spheres"},
        {"contact_force", "N", vector, true, "spheres"},
        {"contact_torque", "N*m", vector, true, "spheres"},
    }};
}

/// In the order of Field.
inline constexpr std::array<FieldInfo, static_cast<std::size_t>(Field::count)> field_info = make_field_info();

constexpr const FieldInfo& info(Field field) { return field_info[static_cast<std::size_t>(field)]; }

/// Number of arrays of a field in a space of `dimension` axes.
constexpr int arrays_of(Field field, int dimension) {
    switch (info(field).shape) {
        case FieldShape::scalar:
            return 1;
        case FieldShape::vector:
            return dimension;
        case FieldShape::tensor:
            return dimension * dimension;
    }
    return 0;
}

/// Whether an array of a field changes its sign in a mirror image along the axes that are `mirrored`.
constexpr bool changes_sign(Field field, int array, int dimension, const std::array<bool, 3>& mirrored) {
    switch (info(field).shape) {
        case FieldShape::scalar:
            return false;
        case FieldShape::vector:
            return mirrored[array];
        case FieldShape::tensor:
            return mirrored[array / dimension] != mirrored[array % dimension];
    }
    return false;
}

}  // namespace dmp::solver
