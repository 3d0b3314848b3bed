// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/uses.hpp"
#include "scene/scene.hpp"
#include "study/limit_bisection.hpp"
#include "study/limit_study.hpp"

namespace dmp::cli {

/// Limits of a scene as they were asked for.
struct LimitsRequest {
    std::vector<std::string> overrides;  ///< of all runs, as --set takes it
    std::vector<std::string> common;     ///< those of them that the user gave
    std::vector<std::string> added;      ///< measures that the scene has not got
    Scene read;                          ///< the scene with them
    double duration = 0;                 ///< of the scene without --until [s]
    long steps = 0;                      ///< of a run with the scene's own settings, about
    std::optional<double> budget;        ///< [s]
    double tolerance = 0.05;             ///< from which on a measure departs
    study::LimitStudy study;
    std::vector<bool> asked;  ///< each dial: it is to be turned
};

/// Makes the scene's particles, to learn its step. Throws InputError where an option cannot have its value, a dial is
/// named that the scene does not have, or the scene cannot be run.
[[nodiscard]] LimitsRequest limits_request(const LimitsCommand& command);

/// Of each dial, whether one of its keys is named, in full or by its last words; all without names. Throws InputError
/// where no dial has a name.
[[nodiscard]] std::vector<bool> asked_dials(const std::vector<study::Dial>& dials,
                                            const std::vector<std::string>& names);

/// For a dry run: the dials, with their values and how many runs they take at most.
[[nodiscard]] std::string dials_text(const LimitsRequest& request);

/// "0.003 Pa*s", for people.
[[nodiscard]] std::string dial_value_text(double value, const std::string& unit);

}  // namespace dmp::cli
