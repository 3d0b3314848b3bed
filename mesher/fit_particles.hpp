// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "base/unlisted_value.hpp"
#include "geometry/geometry.hpp"
#include "mesher/features.hpp"
#include "mesher/mesh.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

/// The nearest point of the walls' surfaces.
struct NearestWall {
    int wall = -1;  ///< index into FitBounds::walls; -1: no wall reaches the place
    Vec point = Vec::Zero();
    double distance = 0;  ///< [m]
    int triangle = -1;    ///< in 3-D: of that wall's surface
};

/// What bounds the particles that a builder made: the same questions in 2-D and in 3-D. Any number of threads
/// asks at once.
struct FitBounds {
    struct Wall {
        const Part* part;
        bool is_body;  ///< in the fluid, not the fluid's edge
    };
    std::vector<Wall> walls;
    /// No further than the walls were built thick, across periodic sides too.
    std::function<NearestWall(const Vec& position)> nearest_wall;
    /// The unit vector from a place on a surface into the fluid.
    std::function<Vec(const Vec& position, const NearestWall& there)> into_fluid;
    std::vector<FeaturePosition> features;  ///< at corners and edges of the walls
    double cell_volume = 0;                 ///< what a lattice point stands for [m^2 x 1 m or m^3]
};

/// Whether particles are moved until they follow the surfaces.
[[nodiscard]] inline bool is_fitted(FillKind fill) {
    switch (fill) {
        case FillKind::lattice:
            return false;
        case FillKind::relaxed:
        case FillKind::sampled:
            return true;
    }
    unlisted_value(fill);
}

/// Layers that walls are given beyond those asked for until they are fitted: what stands still behind what moves.
[[nodiscard]] inline int spare_layers(const Scene& scene) {
    return is_fitted(scene.particles.fill) ? static_cast<int>(std::ceil(scene.numerics.support)) : 0;
}

/// particles.fill = "relaxed" or "sampled": takes the nearest particles to the places at corners and edges, where they
/// stay, and moves fluid and walls until they follow the walls' surfaces and the borders of fluids
/// and of solids with bonds_within (fit_to_surfaces.hpp); cuts walls to the layers asked for, by where their particles
/// are then. Other spring bodies stay where they are. Without bodies the particles of each fluid share its volume
/// equally.
void fit_particles(MeshResult& result, const Geometry& geometry, const Scene& scene, const FitBounds& bounds);

}  // namespace dmp::mesher
