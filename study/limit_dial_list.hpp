// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/limit_dials.hpp"

namespace dmp::study {

/// Digits of a value that is given to a run.
inline constexpr int rung_digits = 6;

/// A scene and what its plan says.
struct DialScene {
    const Scene& scene;
    const LimitFacts& facts;
};

/// The largest step of models whose name begins so goes with a power of the factor.
struct StepScaling {
    std::string model;
    double power = 0;
};

/// A row of the list of dials.
struct DialRow {
    std::string what;
    std::vector<DialSide> sides;
    bool is_physical = false;
    /// The keys of each dial that a scene has of this row; none: the scene does not use the model.
    std::function<std::vector<std::vector<DialKey>>(const DialScene&)> found;
    std::vector<StepScaling> steps{};
    /// It acts through the step alone: where another limit rules, nothing changes any more.
    bool acts_by_step = false;
    /// None: the program states none, but perhaps the check of the scene.
    std::function<std::optional<StatedLimit>(const DialScene&)> stated{};
};

/// All dials that dmp knows of.
[[nodiscard]] const std::vector<DialRow>& dial_list();

}  // namespace dmp::study
