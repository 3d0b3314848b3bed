// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "base/errors.hpp"

namespace dmp::solver {

/// The largest stable step of one model.
struct StepLimit {
    std::string model;    ///< "sound", "viscosity", "body force", "contact", "elastic (leaflets)"
    double dt = 0;        ///< [s]
    std::string formula;  ///< how it comes about
};

/// A model the scene makes run, and why.
struct ModelUse {
    std::string model;                  ///< "Tait equation of state", "Morris viscosity", ...
    std::string source;                 ///< equation and paper
    std::string reason;                 ///< the scene's line that asks for it, or "default"
    std::vector<std::string> fields{};  ///< per-particle arrays that are there for it
    std::size_t bytes = 0;              ///< of them, for one particle of each kind that has them
};

/// The speed of sound that a scene runs with, and what it follows from. A weakly compressible liquid stays within Ma^2
/// of its rest density (Ma = numerics.mach_number) when c0 >= U / Ma (the dynamic pressure rho U^2, Monaghan 1994) and
/// c0^2 >= p / (Ma^2 rho) (any other pressure; Morris, Fox & Zhu 1997, eq. 9).
struct SoundSpeed {
    double value = 0;                    ///< c0 [m/s]
    double largest_pressure = 0;         ///< expected, by flow.largest_pressure or the estimate [Pa]
    bool pressure_is_estimated = false;  ///< from the body acceleration and the fluid's extent
    bool pressure_rules = false;         ///< else the largest speed does, or the scene gives c0
};

/// Something that a scene asks for and that does nothing, or that it lacks.
struct Warning {
    std::string key;          ///< the scene's key that it is about
    SourceLocation location;  ///< of its value; unknown where the scene leaves it out
    std::string problem;      ///< "drag = 0 switches nothing on"
    std::string what_to_do;   ///< "leave it out"

    /// In one line: place, key, problem, what to do.
    [[nodiscard]] std::string text() const;
};

/// What a run will be, before it runs.
struct Plan {
    std::map<std::string, std::size_t> particles;  ///< by kind
    std::size_t bytes_per_particle = 0;
    double sound_speed = 0;    ///< c0 [m/s]
    SoundSpeed sound;          ///< the same, and why
    double largest_speed = 0;  ///< expected [m/s]
    double dt = 0;             ///< fluid step [s]
    int spring_substeps = 0;   ///< spring steps in one fluid step; 0: no springs
    long steps = 0;
    std::vector<StepLimit> limits;  ///< of the fluid step and the spring step
    std::string ruling_limit;       ///< which of them sets the fluid step
    std::vector<ModelUse> models;
    std::vector<std::string> fields;         ///< per-particle arrays that are allocated, with their bytes
    std::vector<std::string> common_fields;  ///< those of them that no model alone asked for
    std::vector<Warning> warnings;
};

}  // namespace dmp::solver
