// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "cli/chosen.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/prepare.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "scene/read_scene.hpp"
#include "solver/model_costs.hpp"
#include "solver/simulation.hpp"

namespace dmp::cli {

namespace {

constexpr double measuring_seconds = 4;

bool names_a_scene(const std::string& subject) {
    return std::filesystem::exists(subject) || subject.ends_with(".toml") || subject.find('/') != std::string::npos;
}

const MeasuredTime* time_of(const std::string& model, const std::optional<ModelCosts>& costs) {
    if (!costs) return nullptr;
    const auto found = std::ranges::find(costs->models, model, &MeasuredTime::of);
    return found == costs->models.end() ? nullptr : &*found;
}

std::string time_text(const MeasuredTime& time) {
    if (time.ns > time.spread) return fmt::format("{:.3g} ns a particle and step (+- {:.2g})", time.ns, time.spread);
    return fmt::format("less than {:.3g} ns a particle and step: lost in the noise", std::abs(time.ns) + time.spread);
}

std::string models_text(const Plan& plan, const std::optional<ModelCosts>& costs) {
    std::string text = Style(Stream::output).strong("Models") + "\n";
    for (const auto& use : plan.models) {
        text += "  " + use.model + "\n";
        if (!use.source.empty()) text += "      source  " + use.source + "\n";
        text += "      why     " + use.reason + "\n";
        for (std::size_t k = 0; k < use.fields.size(); ++k)
            text += (k == 0 ? "      fields  " : "              ") + use.fields[k] + "\n";
        if (const MeasuredTime* time = time_of(use.model, costs))
            text += "      costs   " + time_text(*time) + ", with it less without it\n";
    }
    return text;
}

std::string costs_text(const Scene& scene, const ModelCosts& costs) {
    Listing list;
    list.add("whole step", time_text(costs.step));
    for (const MeasuredTime& stage : costs.stages) list.add(stage.of, fmt::format("{:.3g} ns", stage.ns));
    list.add("", fmt::format("fastest of some rounds on this machine as it is now, {}, in the scene's first {}",
                             count_text(static_cast<std::size_t>(costs.threads), "thread"),
                             count_text(static_cast<std::size_t>(costs.steps), "step")));
    if (!scene.parts_of(PartKind::fluid).empty())
        list.add("",
                 "'forces' holds pressure, viscosity, walls and repulsion, 'density' continuity, diffusion, shifting");
    return Style(Stream::output).strong("Measured") + "\n" + list.text();
}

std::string memory_text(const Plan& plan) {
    std::size_t total = 0;
    for (const auto& [kind, count] : plan.particles) total += count;
    std::string fields;
    for (const auto& field : plan.common_fields) fields += "  " + field + "\n";
    return Style(Stream::output).strong("Fields that several models need") + "\n" + fields +
           fmt::format("  {} a particle with those of the models, {} for {}\n",
                       bytes_text(static_cast<double>(plan.bytes_per_particle)),
                       bytes_text(static_cast<double>(plan.bytes_per_particle * total)), count_text(total, "particle"));
}

std::string warnings_text(const Plan& plan, const std::vector<std::string>& of_particles) {
    if (plan.warnings.empty() && of_particles.empty()) return "";
    std::string text = "\n" + Style(Stream::output).strong("Warnings") + "\n";
    for (const std::string& warning : of_particles) text += "  " + warning + "\n";
    for (const Warning& warning : plan.warnings) text += "  " + warning.text() + "\n";
    return text;
}

}  // namespace

int execute(const ExplainCommand& command) {
    refuse_several_ranks();
    const auto& subject = command.subject;
    if (!names_a_scene(subject.path)) {
        if (!subject.overrides.empty()) {
            throw InputError("--set needs a scene, and '" + subject.path + "' is a key",
                             "Give a scene file or folder, or leave --set out.");
        }
        print(explain_key(subject.path));
        return exit_done;
    }
    const Prepared prepared = prepare(subject);
    const std::string head = heading(prepared);
    const int threads = threads_for(prepared.scene, command.threads);
    const Simulation simulation(prepared.scene, prepared.particles, threads);
    const Plan plan = simulation.plan();
    std::optional<ModelCosts> costs;
    std::string measured;
    if (command.measure) {
        try {
            costs = measure_costs(prepared.scene, prepared.particles, threads, measuring_seconds);
            measured = "\n" + costs_text(prepared.scene, *costs);
        } catch (const DivergenceError& error) {
            measured = "\nNothing was measured: " + error.problem() + "\n  " + error.what_to_do() + "\n";
        }
    }
    print(head + "\n" + chosen_text(chosen_values(prepared.scene, plan, prepared.origin)) + "\n" +
          models_text(plan, costs) + "\n" + limits_text(plan) + "\n" + memory_text(plan) + measured +
          warnings_text(plan, prepared.origin.warnings));
    return exit_done;
}

}  // namespace dmp::cli
