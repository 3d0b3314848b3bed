// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/modules.hpp"
#include "tests/unit/solver/layered_channel.hpp"

namespace dmp::tests {

constexpr double clot_spacing = 1e-3;

/// A [[solidify]] that binds for certain the four nearest of a square lattice.
inline Solidify clot_of(const std::string& liquid) {
    Solidify clot;
    clot.name = std::string("clot");
    clot.liquid = liquid;
    clot.rule = SolidifyRule::per_pair;
    clot.reach = 1.2 * clot_spacing;
    clot.probability = 1.0;
    clot.interval = 0.01;
    clot.bond_stiffness = 20.0;
    return clot;
}

inline ResidenceRegion region_of(const std::string& name, const Vec& from, const Vec& to) {
    ResidenceRegion region;
    region.name = name;
    region.from = from;
    region.to = to;
    return region;
}

inline Measure size_of_clot() {
    Measure size;
    size.name = std::string("clot");
    size.kind = MeasureKind::aggregate;
    size.part = std::string("clot");
    return size;
}

/// Blood between two walls 16 rows apart, `columns` wide, periodic along x; it is driven by `acceleration`.
inline SceneAndParticles blood_channel(int columns = 24, const std::string& acceleration = "0") {
    LayeredChannel channel;
    channel.layers = {{"blood", 16, 0.05}};
    channel.spacing = clot_spacing;
    channel.columns = columns;
    channel.speed = 0.05;
    channel.acceleration = acceleration;
    channel.duration = 0.05;
    SceneAndParticles made = layered(channel);
    made.scene.numerics.viscosity_stepping = ViscosityStepping::explicitly;
    made.scene.contact.range = 1.0;
    return made;
}

/// Around the particle in the middle of the channel.
inline ResidenceRegion middle_of(const SceneAndParticles& made) {
    const double dx = clot_spacing, x = 0.5 * made.particles.box.high[0];
    return region_of("nidus", Vec(x + 0.25 * dx, 8.25 * dx, 0), Vec(x + 0.75 * dx, 8.75 * dx, 0));
}

/// Value of a column of the measures in a row.
inline double measured(const MeasureSeries& series, const std::string& column, std::size_t row) {
    const auto found = std::ranges::find(series.names, column);
    return series.rows.at(row).at(static_cast<std::size_t>(found - series.names.begin()));
}

/// The bonds of a frame's solid, by ids.
inline std::set<std::pair<std::int64_t, std::int64_t>> bonds_of(const Frame& frame) {
    std::set<std::pair<std::int64_t, std::int64_t>> bonds;
    const FrameGroup* solid = group_of(frame, "solid");
    for (std::size_t bond = 0; solid != nullptr && bond < solid->bonds(); ++bond) {
        const auto [low, high] =
            std::minmax(solid->id[solid->bond_ends[2 * bond]], solid->id[solid->bond_ends[2 * bond + 1]]);
        bonds.emplace(low, high);
    }
    return bonds;
}

}  // namespace dmp::tests
