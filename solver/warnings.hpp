// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "scene/scene.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Something that a scene asks for and that does nothing, or that it lacks.
struct Warning {
    std::string key;         ///< the scene's key that it is about
    Place place;             ///< of its value; unknown where the scene leaves it out
    std::string problem;     ///< "drag = 0 switches nothing on"
    std::string what_to_do;  ///< "leave it out"

    /// In one line: place, key, problem, what to do.
    [[nodiscard]] std::string text() const;
};

/// What is odd about a scene with this many spring bodies, though it can run.
std::vector<Warning> warnings_of(const Scene& scene, std::size_t bodies);

}  // namespace dmp::solver
