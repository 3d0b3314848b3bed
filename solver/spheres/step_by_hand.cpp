// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/step_by_hand.hpp"

#include <algorithm>
#include <string>

#include "base/errors.hpp"
#include "base/number_text.hpp"
#include "models/dem/contact_steps.hpp"
#include "solver/time/step_limits.hpp"

namespace dmp::solver {

namespace {

constexpr const char* key = "numerics.contact_step";

std::string seconds(double value) { return number_text(value, 3) + " s"; }

/// Never more than the value itself.
std::string at_most(double value) { return "give at most \"" + seconds(0.995 * value) + "\""; }

}  // namespace

std::vector<StepLimit> StepByHand::added_to(std::vector<StepLimit> limits) const {
    if (!given()) return limits;
    for (StepLimit& limit : limits) limit.formula += "; not binding, the step is set by hand";
    limits.push_back({"contact_step", scene_.numerics.contact_step, "set by hand"});
    return limits;
}

std::optional<StepLimit> StepByHand::limit_at(double speed, double steps) const {
    std::vector<StepLimit> limits =
        contact_step_limits(setup_, std::max<double>(speed, scene_.flow.largest_speed), steps);
    // What was measured is of impacts.
    std::erase_if(limits, [](const StepLimit& limit) { return !limit.model.starts_with("contact of"); });
    if (!given() || limits.empty()) return std::nullopt;
    return ruling_limit(limits);
}

std::optional<Warning> StepByHand::too_long_at(double speed) const {
    const auto& step = scene_.numerics.contact_step;
    const std::optional<StepLimit> limit = limit_at(speed, StepsPerContact::least);
    if (!limit || *step <= limit->dt) return std::nullopt;
    return Warning{
        key, step.location,
        "is too long, at " + seconds(step) + ": impacts gain more than 4 % of energy with steps of more than " +
            seconds(limit->dt) + " (" + limit->model + ": " + limit->formula + ")",
        at_most(limit_at(speed, scene_.numerics.steps_per_contact)->dt) + ", or \"auto\", which follows the speeds"};
}

void StepByHand::check(double speed) const {
    if (const std::optional<Warning> warning = too_long_at(speed))
        throw InputError(warning->location, warning->key + " " + warning->problem, warning->what_to_do);
}

std::optional<Warning> StepByHand::inaccurate_at(double speed) const {
    const auto& step = scene_.numerics.contact_step;
    const double asked = scene_.numerics.steps_per_contact;
    const std::optional<StepLimit> limit = limit_at(speed, asked);
    if (!limit || *step <= limit->dt || too_long_at(speed)) return std::nullopt;
    const double steps = asked * limit->dt / step;
    return Warning{key, step.location,
                   "is " + seconds(step) + ", longer than the " + seconds(limit->dt) +
                       " of numerics.steps_per_contact (" + limit->model + "): with " + number_text(steps, 2) +
                       " steps in an impact, the spin after it is wrong by about " +
                       number_text(100 * StepsPerContact::error(steps), 2) + " % of the speed (docs/contact.md)",
                   at_most(limit->dt)};
}

}  // namespace dmp::solver
