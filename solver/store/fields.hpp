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
    wall_slip,
    wall_acceleration,
    initial_position,
    initial_normal,
    contact_range,
    wall_contact_range,
    volume,
    residence_time,
    pressure,
    force,
    shift,
    correction,
    correction_off_diagonal,
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

struct FieldInfo {
    std::string_view name;
    std::string_view unit;
    bool is_vector;
    /// True: the value moves with the particle when it is sorted, sent to another rank or saved. False: it is
    /// recomputed before use.
    bool is_state;
    /// The model that needs the field, or a part of its name (ModelUse::model); empty if several need it.
    std::string_view needed_by{};
};

/// In the order of Field.
inline constexpr std::array<FieldInfo, static_cast<std::size_t>(Field::count)> field_info{{
    {"position", "m", true, true},
    {"velocity", "m/s", true, true},
    {"density", "kg/m^3", false, true},
    {"density_rate", "kg/m^3/s", false, true, "continuity"},
    {"mass", "kg", false, true},
    {"viscosity", "Pa*s", false, true, "viscous force"},
    {"wall_normal", "1", true, true, "walls"},
    {"wall_distance", "m", false, true, "walls"},
    {"wall_slip", "1", false, true, "walls"},
    {"wall_acceleration", "m/s^2", true, true, "walls"},
    {"drawn_position", "m", true, true, "walls"},
    {"drawn_normal", "1", true, true, "walls"},
    {"contact_range", "m", false, true, "short-range repulsion"},
    {"wall_contact_range", "m", false, true, "short-range repulsion"},
    {"volume", "m^3", false, true},
    {"residence_time", "s", false, true, "residence times"},
    {"pressure", "Pa", false, false, "equation of state"},
    {"force", "N", true, false},
    {"shift", "1/m", true, false, "shifting"},
    {"correction", "1", true, false, "gradient correction"},
    {"correction_off_diagonal", "1", true, false, "gradient correction"},
    {"transport_velocity", "m/s", true, true, "transport velocity"},
    {"viscous_force", "N", true, false, "implicit viscosity"},
    {"viscous_velocity", "m/s", true, false, "implicit viscosity"},
    {"viscous_residual", "N", true, false, "implicit viscosity"},
    {"viscous_direction", "m/s", true, false, "implicit viscosity"},
    {"viscous_diagonal", "kg/s", true, false, "implicit viscosity"},
    // Fields of species: one array per species, in its units.
    {"species_amount", "1", false, true, "diffusion of"},
    {"concentration", "1", false, false, "diffusion of"},
    {"species_diffusivity", "m^2/s", false, true, "diffusion of"},
    {"species_wall", "1", false, true, "diffusion of"},
    {"species_change", "1", false, false, "diffusion of"},
    {"species_residual", "1", false, false, "implicit diffusion"},
    {"species_direction", "1", false, false, "implicit diffusion"},
    {"species_diagonal", "m^3/s", false, false, "implicit diffusion"},
    {"radius", "m", false, true, "spheres"},
    {"angular_velocity", "rad/s", true, true, "spheres"},
    {"contact_force", "N", true, true, "spheres"},
    {"contact_torque", "N*m", true, true, "spheres"},
}};

constexpr const FieldInfo& info(Field field) { return field_info[static_cast<std::size_t>(field)]; }

}  // namespace dmp::solver
