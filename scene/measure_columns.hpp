// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace dmp::scene {

/// A column of measures.csv.
struct MeasureColumn {
    std::string name, unit;  ///< "flow_x", "m/s"; "1" of plain numbers
};

/// The measure with this name. Throws InputError, at the name's location, where the scene has none.
[[nodiscard]] const Measure& measure_called(const Scene& scene, const Value<std::string>& name);

/// The columns of a measure, in their order.
[[nodiscard]] std::vector<MeasureColumn> measure_columns(const Scene& scene, const Measure& measure);

/// Endings of the columns of a vector and of a symmetric tensor.
inline constexpr std::array<const char*, 3> vector_components{"x", "y", "z"};
inline constexpr std::array<const char*, 6> tensor_components{"xx", "yy", "zz", "xy", "yz", "xz"};

/// Components of a vector (3) or tensor (6) that probes have columns for: in 2-D those that are not 0.
[[nodiscard]] std::vector<std::size_t> probed_components(int components, int dimension);

}  // namespace dmp::scene
