// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/limits/limits_request.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "base/number_text.hpp"
#include "cli/prepare.hpp"
#include "cli/sweep/study_options.hpp"
#include "cli/text.hpp"
#include "report/limits_facts.hpp"
#include "scene/read_scene.hpp"
#include "solver/run/setup.hpp"
#include "solver/run/sound_speed.hpp"
#include "solver/simulation.hpp"
#include "study/written_study.hpp"

namespace dmp::cli {

namespace {

/// Of a run with the scene's own settings, where nothing else is asked for: some seconds of a processor.
constexpr double least_steps = 400, particle_steps = 2e7;
/// Times at which something is written shape the steps: rows are far apart.
constexpr double rows_of_a_run = 10;

study::LimitFacts facts_of(const Scene& scene, const Plan& plan, const Resources& resources) {
    study::LimitFacts facts;
    facts.at_rest = plan.at_rest;
    facts.dt = plan.dt;
    if (scene.parts_of(PartKind::spheres).empty())
        // "auto" is by the speed of sound that the run has.
        facts.contact_strength = pair_settings(with_sound_speed(scene, plan.sound), resources).repulsion_strength;
    for (const StepLimit& limit : plan.limits) {
        if (limit.formula.find("not binding") != std::string::npos) continue;
        // The fluid's step does not follow from those that are sub-cycled.
        if (limit.model.starts_with("elastic"))
            facts.subcycled.push_back(limit.model);
        else
            facts.step_limits[limit.model] = limit.dt;
    }
    return facts;
}

/// Its own settings must run: what is wrong with them is the scene's error.
[[noreturn]] void fails_at_its_own(const InputError& error) {
    throw InputError(error.where(), "the scene does not run at its own settings: " + error.problem(),
                     error.what_to_do());
}

/// What the plan of a scene says, and how many particles it has.
struct Learnt {
    study::LimitFacts facts;
    double particles = 0;
};

Learnt learnt_from(const Scene& scene, const std::string& path) {
    try {
        SceneChoice choice;
        choice.path = path;
        Resources resources;
        resources.threads = std::max(1, *scene.run.threads);
        const Prepared prepared = prepare(scene, choice, resources.ranks);
        const Plan plan = Simulation(prepared.scene, prepared.particles, resources).plan();
        return {facts_of(prepared.scene, plan, resources), static_cast<double>(prepared.particles.size())};
    } catch (const InputError& error) {
        fails_at_its_own(error);
    }
}

bool sets(const std::vector<std::string>& overrides, const std::string& key) {
    return std::ranges::any_of(overrides, [&](const auto& each) { return study::key_set_by(each) == key; });
}

/// Downwards, to two digits.
double rounded(double time) {
    const double digit = std::pow(10, std::floor(std::log10(time)) - 1);
    return std::floor(time / digit * (1 + 1e-9)) * digit;
}

std::string seconds(double time) { return "\"" + number_text(time, 9) + " s\""; }

}  // namespace

std::vector<bool> asked_dials(const std::vector<study::Dial>& dials, const std::vector<std::string>& names) {
    std::vector<bool> asked(dials.size(), names.empty());
    for (const std::string& name : names) {
        bool found = false;
        std::vector<std::string> known;
        for (std::size_t k = 0; k < dials.size(); ++k)
            for (const study::DialKey& key : dials[k].keys) {
                if (std::ranges::find(known, key.key) == known.end()) known.push_back(key.key);
                if (key.key == name || key.key.ends_with("." + name)) asked[k] = found = true;
            }
        if (found) continue;
        const std::string nearest = nearest_name(name, known);
        throw InputError(
            {"--dials", 0, 0}, "the scene has no dial '" + name + "'",
            (nearest.empty() ? "" : "Did you mean '" + nearest + "'? ") + "Its dials are " + quoted_list(known) + ".");
    }
    return asked;
}

LimitsRequest limits_request(const LimitsCommand& command) {
    if (command.slurm)
        throw InputError({"--slurm", 0, 0}, "limits are not found in jobs of Slurm: each run depends on those before",
                         "Leave it out; started in a job, 'dmp limits' uses that job's processors.");
    std::optional<double> budget, until;
    if (!command.budget.empty()) budget = time_of(command.budget, "--budget");
    if (!command.until.empty()) until = time_of(command.until, "--until");
    const double tolerance = command.tolerance.empty() ? 0.05 : tolerance_of(command.tolerance);
    const Scene scene = read_scene(command.scene, command.overrides);
    const auto [facts, particles] = learnt_from(scene, command.scene);
    const double steps = std::max(least_steps, particle_steps / particles);
    if (!until) until = std::min(*scene.run.duration, rounded(steps * facts.dt));

    std::vector<std::string> overrides = command.overrides;
    const std::vector<std::string> added = measures_to_add(scene);
    for (std::string& each : overrides_that_add(added)) overrides.push_back(std::move(each));
    overrides.push_back("run.duration=" + seconds(*until));
    if (!sets(command.overrides, "output.every")) overrides.push_back("output.every=" + seconds(*until));
    if (!sets(command.overrides, "output.measure_every"))
        overrides.push_back("output.measure_every=" + seconds(*until / rows_of_a_run));
    Scene read = read_scene(command.scene, overrides);
    need_two_rows(read, command.until);
    std::vector<study::Dial> dials = study::limit_dials(read, command.scene, overrides, facts);
    std::vector<bool> asked = asked_dials(dials, command.dials);
    study::LimitStudy study(std::move(dials), study::repeat_of(read, facts));
    return {std::move(overrides),
            command.overrides,
            added,
            std::move(read),
            *scene.run.duration,
            steps_of(*until, facts.dt),
            budget,
            tolerance,
            std::move(study),
            std::move(asked)};
}

std::string dial_value_text(double value, const std::string& unit) {
    return number_text(value, 4) + (unit.empty() ? "" : " " + unit);
}

std::string dials_text(const LimitsRequest& request) {
    std::vector<std::vector<std::string>> rows{{"dial", "", "own", "stated", "values", "runs", "what"}};
    for (std::size_t k = 0; k < request.study.dials().size(); ++k) {
        if (!request.asked[k]) continue;
        const study::Dial& dial = request.study.dials()[k];
        const std::vector<study::RungState> none(dial.rungs.size(), study::RungState::unknown);
        rows.push_back(
            {dial.name, to_string(dial.side), dial_value_text(dial.own(), dial.unit()),
             dial.stated ? stated_text(dial_value_text(dial.stated->value, dial.unit()), dial.stated_margin()) : "-",
             dial.rungs.empty() ? "none" : "to " + dial_value_text(dial.rungs.back().value, dial.unit()),
             std::to_string(study::most_runs_left(none)), dial.what});
    }
    return table_text(rows);
}

}  // namespace dmp::cli
