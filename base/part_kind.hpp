// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "base/enum_names.hpp"

namespace dmp {

/// What a part is, and each of its particles: a fluid, a rigid wall, an elastic solid of masses and springs, or spheres
/// in contact. Planes and surfaces are walls for spheres and have no particles.
enum class PartKind : std::uint8_t { fluid, rigid, elastic, spheres, plane, surface };

template <>
inline constexpr auto enum_names<PartKind> = std::to_array<std::string_view>({"fluid", "rigid", "elastic", "spheres",
                                                                              "plane", "surface"});

}  // namespace dmp
