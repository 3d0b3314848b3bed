// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/time/margins.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string_view>

#include "base/number_text.hpp"
#include "scene/step_margins.hpp"

namespace dmp::solver {

namespace {

/// Limits that are longer, or none, at other times of a run.
constexpr std::array<std::string_view, 3> passing{"body force", "driving", "shifting"};

/// How many times shorter the steps always are than this model allows; none where the steps have no such limit.
std::optional<double> held_shorter(const Plan& plan, const std::string& model) {
    double shortest = std::numeric_limits<double>::infinity(), its = shortest;
    for (const StepLimit& limit : plan.limits) {
        if (limit.model.starts_with(model)) its = std::min(its, limit.dt);
        if (std::ranges::find(passing, limit.model) == passing.end()) shortest = std::min(shortest, limit.dt);
    }
    if (its == std::numeric_limits<double>::infinity()) return {};
    return std::max(1.0, its / shortest);
}

/// What a margin of so many times means for the run.
std::string outlook(const StepMargin& key, double margin) {
    if (key.is_least) return "impacts are hardly resolved";
    return margin < 1 ? "expect the run to diverge" : "the run may diverge";
}

Warning small_margin(const StepMargin& key, double margin) {
    return {key.key, key.own.location,
            "is " + number_text(*key.own) +
                (margin < 1 ? ", beyond its stated limit, "
                            : ", within a factor of " + number_text(least_margin) + " of its stated limit, ") +
                number_text(key.stated.value, 3) + " (" + key.stated.formula + "): " + outlook(key, margin),
            "give " + number_text(key.with_least_margin(), 6) + (key.is_least ? " or more" : " or less") +
                ", or leave it out"};
}

}  // namespace

void add_margins(Plan& plan, const Scene& scene) {
    for (const StepMargin& key : step_margins(scene)) {
        const std::optional<double> held = key.model.empty() ? 1.0 : held_shorter(plan, key.model);
        if (!held && key.own.given())
            plan.warnings.push_back({key.key, key.own.location,
                                     "has no effect: the steps of this scene have no limit by " + key.model,
                                     "leave it out"});
        if (!held) continue;
        const double margin = key.margin() * *held;
        plan.margins.push_back({key.key, *key.own, key.stated.value, key.stated.formula, margin, *held > 1});
        if (key.own.given() && key.is_small(*held)) plan.warnings.push_back(small_margin(key, margin));
    }
}

}  // namespace dmp::solver
