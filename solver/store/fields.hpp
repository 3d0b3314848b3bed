// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace dmp {

/// The per-particle arrays a model may ask for.
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
    drawn_position,
    drawn_normal,
    contact_range,
    wall_contact_range,
    volume,
    pressure,
    force,
    shift,
    count  // how many there are
};

using FieldList = std::vector<Field>;

struct FieldInfo {
    std::string_view name;
    std::string_view unit;
    bool is_vector;
    /// True: a particle takes its value along when it is sorted, sent to another rank or saved. False: it is worked out
    /// anew before it is used.
    bool is_state;
};

/// By Field, in its order.
inline constexpr std::array<FieldInfo, static_cast<std::size_t>(Field::count)> field_info{{
    {"position", "m", true, true},
    {"velocity", "m/s", true, true},
    {"density", "kg/m^3", false, true},
    {"density_rate", "kg/m^3/s", false, true},
    {"mass", "kg", false, true},
    {"viscosity", "Pa*s", false, true},
    {"wall_normal", "1", true, true},
    {"wall_distance", "m", false, true},
    {"wall_slip", "1", false, true},
    {"wall_acceleration", "m/s^2", true, true},
    {"drawn_position", "m", true, true},
    {"drawn_normal", "1", true, true},
    {"contact_range", "m", false, true},
    {"wall_contact_range", "m", false, true},
    {"volume", "m^3", false, true},
    {"pressure", "Pa", false, false},
    {"force", "N", true, false},
    {"shift", "1/m", true, false},
}};

constexpr const FieldInfo& info(Field field) { return field_info[static_cast<std::size_t>(field)]; }

}  // namespace dmp
