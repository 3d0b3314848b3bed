// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/measure.hpp"
#include "cli/text.hpp"

namespace dmp::bench {

namespace {

using Json = nlohmann::ordered_json;
using cli::count_text;
using cli::Listing;

constexpr double nanosecond = 1e-9;

std::string spread_text(const Spread& spread, double processor) {
    return fmt::format("{:.1f} ns per particle ({:.1f} to {:.1f}), with a processor for {:.0f} % of the time",
                       spread.median, spread.smallest, spread.largest, 100 * processor);
}

std::string heading(const Options& options, const Measured& measured) {
    const Channel& channel = options.channel;
    return fmt::format(
        "{}: {} + {} in walls; support {} dx, {}, {} walls, diffusion {}, shifting {}, on {}\n"
        "{} of {} steps on {}, and of as many yardstick sweeps on 1 thread, in turns; medians (extremes)\n",
        options.name, count_text(measured.fluid, "fluid particle"), count_text(measured.walls), channel.support,
        to_string(channel.kernel), to_string(channel.walls), channel.density_diffusion, channel.shifting,
        to_string(options.vector_unit), count_text(static_cast<std::size_t>(options.repeat), "repeat"), options.steps,
        count_text(static_cast<std::size_t>(options.threads), "thread"));
}

std::string stages_text(const EngineTimes& engine) {
    std::vector<std::pair<double, std::string>> stages;
    for (const auto& [stage, spread] : engine.stage) stages.emplace_back(spread.median, stage);
    std::ranges::sort(stages, std::greater());
    Listing list(4);
    for (const auto& [median, stage] : stages)
        list.add(stage, fmt::format("{:6.2f} ns  {:3.0f} %", median, 100 * median / engine.step.median));
    return list.text();
}

std::string engine_text(const Measured& measured) {
    const EngineTimes& engine = *measured.engine;
    const double steps_per_second = 1 / (engine.step.median * nanosecond);
    Listing list;
    list.add("step", spread_text(engine.step, engine.processor));
    list.add("speed", fmt::format("{:.3g} particle-steps/s/core", steps_per_second));
    list.add("sweeps", fmt::format("{:.3g} particle-sweeps/s/core, {} a step", sweeps_per_step * steps_per_second,
                                   sweeps_per_step));
    list.add("pairs", fmt::format("{:.3g} pairs within the support/s/core, {:.2f} per particle and sweep",
                                  sweeps_per_step * steps_per_second * measured.pairs, measured.pairs));
    list.add("memory", fmt::format("{} bytes per particle planned, {} resident", engine.planned_bytes,
                                   engine.resident_bytes ? fmt::format("{:.0f}", *engine.resident_bytes) : "unknown"));
    list.add("run", fmt::format("{} steps of {:.3g} s, density {:.4f} to {:.4f} of that at rest", engine.steps,
                                engine.step_seconds, engine.density_low, engine.density_high));
    if (engine.viscous_iterations > 0)
        list.add("viscosity", fmt::format("{:.1f} iterations a step", engine.viscous_iterations));
    return "engine\n" + list.text() + "  stages\n" + stages_text(engine);
}

std::string text_of(const Options& options, const Measured& measured) {
    Listing yardstick;
    yardstick.add("sweep", spread_text(measured.yardstick, measured.yardstick_processor));
    yardstick.add("speed", fmt::format("{:.3g} particle-sweeps/s/core", 1 / (measured.yardstick.median * nanosecond)));
    yardstick.add("pairs", fmt::format("{:.2f} of {:.2f} listed per particle are within the support", measured.pairs,
                                       measured.pairs_listed));
    std::string text = heading(options, measured);
    if (measured.engine) text += engine_text(measured);
    text += "yardstick\n" + yardstick.text();
    if (!measured.engine) return text;
    const double step = measured.engine->step.median;
    return text + fmt::format("the yardstick's sweep takes {:.2f} of the engine's step, {:.2f} of a sweep's share\n",
                              measured.yardstick.median / step, sweeps_per_step * measured.yardstick.median / step);
}

Json json_of(const Spread& spread) {
    return {{"median", spread.median}, {"smallest", spread.smallest}, {"largest", spread.largest}};
}

Json json_of(const Measured& measured) {
    const EngineTimes& engine = *measured.engine;
    const double steps_per_second = 1 / (engine.step.median * nanosecond);
    Json stages = Json::object();
    for (const auto& [stage, spread] : engine.stage) {
        stages[stage] = json_of(spread);
        stages[stage]["percent"] = 100 * spread.median / engine.step.median;
    }
    Json json{{"ns_per_particle_step", json_of(engine.step)},
              {"particle_steps_per_s_core", steps_per_second},
              {"sweeps_per_step", sweeps_per_step},
              {"particle_sweeps_per_s_core", sweeps_per_step * steps_per_second},
              {"pairs_per_s_core", sweeps_per_step * steps_per_second * measured.pairs},
              {"viscous_iterations_per_step", engine.viscous_iterations},
              {"bytes_per_particle_planned", engine.planned_bytes},
              {"bytes_per_particle_resident", nullptr},
              {"processor_percent", 100 * engine.processor},
              {"steps", engine.steps},
              {"step_seconds", engine.step_seconds},
              {"density_low", engine.density_low},
              {"density_high", engine.density_high},
              {"ns_by_stage", stages}};
    if (engine.resident_bytes) json["bytes_per_particle_resident"] = *engine.resident_bytes;
    return json;
}

std::string json_text(const Options& options, const Measured& measured) {
    const Channel& channel = options.channel;
    Json json{{"case", options.name},
              {"fluid_particles", measured.fluid},
              {"wall_particles", measured.walls},
              {"dimension", channel.dimension},
              {"support", channel.support},
              {"kernel", to_string(channel.kernel)},
              {"walls", to_string(channel.walls)},
              {"density_diffusion", channel.density_diffusion},
              {"shifting", channel.shifting},
              {"contact_range", channel.contact_range},
              {"implicit_viscosity", channel.implicit_viscosity},
              {"vector_unit", to_string(options.vector_unit)},
              {"scheme", to_string(channel.scheme)},
              {"threads", options.threads},
              {"repeat", options.repeat},
              {"pairs_per_particle", measured.pairs},
              {"engine", nullptr},
              {"yardstick",
               {{"ns_per_particle_sweep", json_of(measured.yardstick)},
                {"particle_sweeps_per_s_core", 1 / (measured.yardstick.median * nanosecond)},
                {"processor_percent", 100 * measured.yardstick_processor},
                {"pairs_listed_per_particle", measured.pairs_listed}}}};
    if (measured.engine) {
        json["engine"] = json_of(measured);
        json["yardstick_sweep_over_engine_step"] = measured.yardstick.median / measured.engine->step.median;
        json["yardstick_sweep_over_engine_sweep"] =
            sweeps_per_step * measured.yardstick.median / measured.engine->step.median;
    }
    return json.dump(2) + "\n";
}

}  // namespace

std::string report(const Options& options, const Measured& measured) {
    return options.json ? json_text(options, measured) : text_of(options, measured);
}

}  // namespace dmp::bench
