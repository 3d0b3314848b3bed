// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace dmp {

/// The per-particle arrays a model may ask for.
enum class Field {
    position,
    velocity,
    force,
    shift,
    density,
    density_rate,
    pressure,
    volume,
    mass,
    viscosity,
    wall_normal,
    wall_distance,
    contact_range,
    wall_contact_range,
    count  // how many there are
};

struct FieldInfo {
    std::string_view name;
    std::string_view unit;
    bool is_vector;
};

/// By Field, in its order.
inline constexpr std::array<FieldInfo, static_cast<std::size_t>(Field::count)> field_info{{
    {"position", "m", true},
    {"velocity", "m/s", true},
    {"force", "N", true},
    {"shift", "m", true},
    {"density", "kg/m^3", false},
    {"density_rate", "kg/m^3/s", false},
    {"pressure", "Pa", false},
    {"volume", "m^3", false},
    {"mass", "kg", false},
    {"viscosity", "Pa*s", false},
    {"wall_normal", "1", true},
    {"wall_distance", "m", false},
    {"contact_range", "m", false},
    {"wall_contact_range", "m", false},
}};

constexpr const FieldInfo& info(Field field) { return field_info[static_cast<std::size_t>(field)]; }

}  // namespace dmp
