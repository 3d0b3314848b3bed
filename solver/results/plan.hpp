// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "base/errors.hpp"

namespace dmp::solver {

/// The largest stable step of one model.
struct StepLimit {
    std::string model;    ///< "sound", "viscosity", "body force", "contact", "elastic (leaflets)"
    double dt = 0;        ///< [s]
    std::string formula;  ///< how it is computed
};

/// Steps of dt [s] that a duration [s] takes; of more than can be counted the largest number.
[[nodiscard]] inline long steps_of(double duration, double dt) {
    const double steps = std::ceil(duration / dt);
    constexpr long most = std::numeric_limits<long>::max();
    return steps < static_cast<double>(most) ? static_cast<long>(steps) : most;
}

/// A model that the scene uses, and why.
struct ModelUse {
    std::string model;                  ///< "Tait equation of state", "Morris viscosity", ...
    std::string source;                 ///< equation and paper
    std::string reason;                 ///< the line of the scene that requires it, or "default"
    std::vector<std::string> fields{};  ///< per-particle arrays that it needs
    std::size_t bytes = 0;              ///< of these arrays, for one particle of each kind that has them
};

/// The speed of sound of a scene, and its origin. The density of a weakly compressible fluid stays within Ma^2 of its
/// rest density (Ma = numerics.mach_number) if c0 >= U / Ma (the dynamic pressure rho U^2, Monaghan 1994) and c0^2 >=
/// p / (Ma^2 rho) (any other pressure; Morris, Fox & Zhu 1997, eq. 9).
struct SoundSpeed {
    enum class Origin {
        scene,            ///< numerics.sound_speed
        largest_speed,    ///< flow.largest_speed
        given_pressure,   ///< flow.largest_pressure
        column_pressure,  ///< of the fluid's extent under the body acceleration
        viscous_pressure  ///< next to a body of a few spacings that moves at flow.largest_speed
    };
    [[nodiscard]] bool is_from_pressure() const { return origin != Origin::scene && origin != Origin::largest_speed; }
    double value = 0;             ///< c0 [m/s]
    double largest_pressure = 0;  ///< expected, given or estimated [Pa]
    Origin origin = Origin::scene;
};

/// A setting of the scene that has no effect, or one that is missing.
struct Warning {
    std::string key;          ///< key of the scene
    SourceLocation location;  ///< of its value; unknown if the scene leaves it out
    std::string problem;      ///< "drag = 0 switches nothing on"
    std::string what_to_do;   ///< "leave it out"

    /// In one line: location, key, problem, what to do.
    [[nodiscard]] std::string text() const {
        return (location.known() ? location.text() + ": " : "") + key + " " + problem + "; " + what_to_do;
    }
};

/// How far a key that sets the length of steps is from a limit that the program states.
struct Margin {
    std::string key;  ///< "numerics.step_factor"
    double own = 0, stated = 0;
    std::string formula;       ///< what the stated limit is
    double times = 0;          ///< by which the steps could be longer
    bool is_by_other = false;  ///< another limit keeps the steps shorter than the key does: part of `times`
};

/// A preview of a run.
struct Plan {
    std::map<std::string, std::size_t> particles;  ///< by kind
    std::size_t bytes_per_particle = 0;
    double sound_speed = 0;    ///< c0 [m/s]
    SoundSpeed sound;          ///< the same, and its origin
    double largest_speed = 0;  ///< expected [m/s]
    bool at_rest = false;      ///< nothing moves, and only species are stepped
    double dt = 0;             ///< fluid step [s]
    int spring_substeps = 0;   ///< spring steps per fluid step; 0: no springs
    long steps = 0;
    std::vector<StepLimit> limits;  ///< of the fluid step and the spring step
    std::string ruling_limit;       ///< the limit that determines the fluid step
    std::vector<Margin> margins;    ///< of the keys that set steps
    std::vector<ModelUse> models;
    std::vector<std::string> fields;         ///< per-particle arrays that are allocated, with their bytes
    std::vector<std::string> common_fields;  ///< those of them that several models share
    std::vector<Warning> warnings;
};

}  // namespace dmp::solver
