// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/uses.hpp"
#include "geometry/geometry.hpp"

namespace dmp::cli {

// What first scenes take for granted, in 3-D and in 2-D (docs/cad.md).
inline constexpr double reynolds_number = 10, particles_across = 20, most_particles = 2e5;
/// What the fluid speeds up to, over the speed that it is driven to in the empty section.
inline constexpr double faster = 1.5, faster_past_bodies = 2;

struct Liquid {
    const char* name;  ///< what part of the fluid's name says that it is this
    const char* what;
    double density, viscosity;  ///< [kg/m^3], [Pa s]
};

/// Blood or air where the name says so, else water.
[[nodiscard]] const Liquid& liquid_named(const std::string& name);
[[nodiscard]] bool sounds_like_a_fluid(const std::string& name);

/// A length as scenes have it; what is as good as 0 beside `size` is 0.
[[nodiscard]] std::string in_millimetres(double length, double size);
/// To two digits.
[[nodiscard]] double rounded(double value);

/// The name, made longer until nothing else has it.
[[nodiscard]] std::string name_that_is_free(std::string name, const std::vector<std::string>& taken);
/// "a", "b": as scenes have lists.
[[nodiscard]] std::string listed(const std::vector<std::string>& names);
/// A [[select]]; what of it is as good as 0 beside `size` is 0.
[[nodiscard]] std::string written_selection(const FaceSelection& selection, double size, int dimension);
/// A [[part]] of this liquid.
[[nodiscard]] std::string written_fluid(const std::string& name, const Liquid& liquid);
/// A [[part]] that is a wall at rest.
[[nodiscard]] std::string written_wall(const std::string& name);

/// All that a first scene is made of.
struct SceneDraft {
    const Geometry& geometry;
    bool unit_given = false;  ///< the scene states the geometry's unit
    std::string fluid;
    std::vector<std::string> assumptions;
    double spacing = 0;   ///< [m]
    std::string parts;    ///< selections and parts
    std::string flow;     ///< and accuracy
    double duration = 0;  ///< [s]

    [[nodiscard]] std::string text() const;
};

/// Parts of the geometry that the scene knows and leaves out.
[[nodiscard]] std::string written_left_out(const std::string& name, const std::string& why);

}  // namespace dmp::cli
