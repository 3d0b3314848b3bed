// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace dmp::scene {

/// A limit that the program states, by theory or as measured.
struct StatedLimit {
    double value = 0;     ///< in SI
    std::string formula;  ///< what it is, and where it is from
};

/// How far a key that sets the length of steps is from where they become unstable.
struct StepMargin {
    std::string key;    ///< "numerics.step_factor"
    std::string model;  ///< names of the step limits that it sets begin so: "sound"; "": none of the fluid's
    Value<double> own;
    StatedLimit stated;
    bool is_least = false;  ///< the limit is the least value, not the largest one

    /// How many times the value may grow, or shrink where its limit is the least one.
    [[nodiscard]] double margin() const { return is_least ? *own / stated.value : stated.value / *own; }
    /// Less than least_margin, and not by rounding, where steps are held so many times shorter by something else.
    [[nodiscard]] bool is_small(double held_shorter = 1) const;
    /// "numerics.step_factor = 0.9 is too large; its stated limit is 0.7"
    [[nodiscard]] std::string too_large_text() const;
    /// The value with least_margin, to three decimals on the safe side.
    [[nodiscard]] double with_least_margin() const;
};

/// A default has at least this margin; a smaller one of a value that is given is warned of.
inline constexpr double least_margin = 1.2;

/// numerics.steps_per_contact may not be less.
inline constexpr double least_steps_per_contact = 5;

/// Of the keys that set steps in this scene. What the limits depend on are its scheme and the solids that it may have;
/// step_factor's is that of fluid at rest, whose steps are the longest: c0 dt / R = step_factor / (1 + U / c0).
[[nodiscard]] std::vector<StepMargin> step_margins(const Scene& scene);

/// A key that is given for nothing.
struct IdleKey {
    std::string key;
    SourceLocation location;
    std::string reason;  ///< "no viscosity is stepped explicitly"
};

/// Keys that set steps of models that the scene does not have.
[[nodiscard]] std::vector<IdleKey> idle_step_keys(const Scene& scene);

/// Gives least_margin to those defaults that have less in this scene.
void lower_defaults(Scene& scene);

/// "lowered from 0.5 to 1 / 1.2 of its stated limit, c0 dt / R = 0.33, measured, ..."; "" where the value of the key is
/// given, or not lowered.
[[nodiscard]] std::string lowered_text(const Scene& scene, const std::string& key);

}  // namespace dmp::scene
