// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/results/plan.hpp"
#include "solver/spheres/contact_list.hpp"
#include "solver/spheres/sphere_walls.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// A law between the spheres of two parts, or of a part and a wall, and what its largest steps depend on.
struct SpherePair {
    std::string parts;  ///< "'carrier' and 'api'"
    ContactModel model;
    ContactConstants<double> constants;
    double radius = 0, mass = 0;                  ///< smallest effective ones [m], [kg]
    double largest_radius = 0, largest_mass = 0;  ///< largest effective ones
    const ContactPair* asked = nullptr;           ///< in the scene
};

/// What a scene's spheres and walls do to each other.
struct SphereSetup {
    PairKinds kinds{0};
    std::vector<SpherePair> pairs;       ///< by kind
    std::vector<SpherePair> wall_pairs;  ///< for step limits
    WallPairs walls;
    std::vector<std::array<Expression, 3>> wall_velocity;    ///< by part number
    std::vector<double> smallest_by_part, lightest_by_part;  ///< by part number; 0: has no spheres [m], [kg]
    double reach = 0;                                        ///< largest gap across which a force acts [m]
    double smallest_radius = 0, largest_radius = 0, mean_radius = 0;
    std::size_t history_width = 0;                                ///< of the longest law
    double drive_time = std::numeric_limits<double>::infinity();  ///< in which what drives the scene changes [s]
};

/// Throws InputError where the scene does not say what happens, or what the engine cannot do.
SphereSetup sphere_setup(const Scene& scene, const ParticleSet& set);

/// The steps by name with which the shortest impact of each pair, for spheres this fast [m/s], takes `steps` steps, and
/// those of adhesion that belong to it.
std::vector<StepLimit> contact_step_limits(const SphereSetup& setup, double speed, double steps);
/// The largest steps, by name, for spheres this fast [m/s]; whether or not the scene sets one by hand.
std::vector<StepLimit> sphere_step_limits(const Scene& scene, const SphereSetup& setup, const ParticleSpace& space,
                                          double speed);

/// Which models run and why.
std::vector<ModelUse> sphere_models(const Scene& scene, const SphereSetup& setup, const ParticleSpace& space);

}  // namespace dmp::solver
