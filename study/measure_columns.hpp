// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "scene/items.hpp"
#include "scene/scene.hpp"
#include "study/uses.hpp"

namespace dmp::study {

/// What is known of a measure's columns in measures.csv before any run.
struct MeasureColumns {
    /// one: with the measure's name; several: with endings, "density_low"; depends: either, or both.
    enum class Count { one, several, depends };
    Count count = Count::depends;
    std::string unit;  ///< of all of them; "": depends on the scene
};

[[nodiscard]] MeasureColumns columns_of(MeasureKind kind);

/// Whether a column of measures.csv is one of this measure's: not of another, "flux_in" beside "flux", whose name is
/// longer.
[[nodiscard]] bool is_column_of(const Scene& scene, const std::string& measure, const std::string& column);

/// The name of the vector that a column is a component of, "flow_" for flow_x; else the column's.
[[nodiscard]] std::string vector_of(const std::string& column);

/// Whether a column of measures.csv counts particles or bonds, of which a smaller spacing has more.
[[nodiscard]] bool counts_particles(const Scene& scene, const std::string& column);

}  // namespace dmp::study
