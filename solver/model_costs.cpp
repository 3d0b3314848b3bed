// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/model_costs.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>

#include "base/errors.hpp"
#include "base/wall_clock.hpp"
#include "scene/measure_subject.hpp"
#include "solver/simulation.hpp"

namespace dmp::solver {

namespace {

/// A model that a scene runs with, and the scene without it.
struct Omission {
    std::string model;
    Scene without;
};

std::vector<Omission> omissions(const Scene& scene) {
    std::vector<Omission> all;
    const auto leave_out = [&](bool runs, const std::string& model, const std::function<void(Scene&)>& change) {
        if (!runs) return;
        all.push_back({model, scene});
        change(all.back().without);
    };
    const auto& numerics = scene.numerics;
    const bool fluid = !scene.parts_of(PartKind::fluid).empty();
    const auto walls = scene.parts_of(PartKind::rigid);
    const bool solid = !walls.empty() || !scene.parts_of(PartKind::elastic).empty();
    const bool summation = *numerics.density == DensityModel::summation;
    leave_out(fluid && *numerics.viscosity_stepping == ViscosityStepping::implicitly, "implicit viscosity",
              [](Scene& s) { s.numerics.viscosity_stepping = ViscosityStepping::explicitly; });
    leave_out(fluid && *numerics.gradient_correction, "gradient correction",
              [](Scene& s) { s.numerics.gradient_correction = false; });
    leave_out(fluid && *numerics.density_diffusion > 0 && !summation, "density diffusion",
              [](Scene& s) { s.numerics.density_diffusion = 0.0; });
    leave_out(fluid && *numerics.shifting > 0 && !*numerics.transport_velocity, "particle shifting",
              [](Scene& s) { s.numerics.shifting = 0.0; });
    leave_out(fluid && *numerics.transport_velocity, "transport velocity", [](Scene& s) {
        s.numerics.transport_velocity = false;
        s.numerics.shifting = 0.0;
    });
    // What plain walls cannot have is refused with them.
    const bool may_be_plain = std::ranges::none_of(walls, [](const Part* wall) { return *wall->slip; });
    leave_out(fluid && !walls.empty() && *numerics.walls == WallModel::extrapolated && !summation &&
                  !*numerics.gradient_correction && may_be_plain,
              "extrapolated walls", [](Scene& s) { s.numerics.walls = WallModel::plain; });
    leave_out(solid && *scene.contact.range > 0, "short-range repulsion", [](Scene& s) { s.contact.range = 0.0; });
    leave_out(!scene.regions.empty() && scene.asks_for(FluidField::residence_time), "residence times",
              [](Scene& s) { std::erase(s.output.fields, FluidField::residence_time); });
    for (std::size_t number = 0; number < scene.species.size(); ++number)
        leave_out(true, "diffusion of '" + *scene.species[number].name + "'", [number, &scene](Scene& s) {
            std::erase_if(s.measures, [&](const Measure& measure) {
                const bool of_any = is_of_species(*measure.kind) ||
                                    (reads_a_field(measure.kind) && *measure.field == FluidField::concentration);
                return of_any && scene.species_of(measure) == number;
            });
            s.species.erase(s.species.begin() + static_cast<std::ptrdiff_t>(number));
            if (s.species.empty()) std::erase(s.output.fields, FluidField::concentration);
        });
    for (std::size_t number = 0; number < scene.species.size(); ++number)
        leave_out(!scene.takers_of(scene.species[number]).empty(), "uptake of '" + *scene.species[number].name + "'",
                  [number, &scene](Scene& s) {
                      std::erase_if(s.measures, [&](const Measure& measure) {
                          return *measure.kind == MeasureKind::uptake && scene.species_of(measure) == number;
                      });
                      s.species[number].uptake = {};
                  });
    return all;
}

/// A scene that runs some steps at a time.
class Trial {
  public:
    Trial(const Scene& scene, const ParticleSet& particles, const Resources& resources)
        : simulation_(scene, particles, resources),
          dt_(simulation_.plan().dt),
          particles_(static_cast<double>(particles.size())) {}

    struct Round {
        long steps = 0;
        int threads = 1;
        double ns = 0;                         ///< a particle and step
        std::map<std::string, double> stages;  ///< of which [ns]
    };
    Round run(long steps) {
        RunOptions options;
        options.until = time_ + static_cast<double>(steps) * dt_;
        const RunSummary summary = simulation_.run(options);
        time_ = summary.simulated_s;
        Round round;
        round.steps = summary.steps - steps_;
        steps_ = summary.steps;
        round.threads = summary.threads;
        const double to_ns = 1e9 / (static_cast<double>(std::max(1L, round.steps)) * particles_);
        for (const auto& [stage, seconds] : summary.seconds_by_stage) {
            round.stages[stage] = (seconds - seconds_[stage]) * to_ns;
            round.ns += round.stages[stage];
            seconds_[stage] = seconds;
        }
        return round;
    }

  private:
    Simulation simulation_;
    double dt_, particles_, time_ = 0;
    long steps_ = 0;
    std::map<std::string, double> seconds_;
};

MeasuredTime fastest_of(const std::string& of, const std::vector<Trial::Round>& rounds) {
    std::vector<double> ns;
    ns.reserve(rounds.size());
    for (const Trial::Round& round : rounds) ns.push_back(round.ns);
    std::ranges::sort(ns);
    return {of, ns.front(), ns[std::min<std::size_t>(2, ns.size() - 1)] - ns.front()};
}

/// The scene without what a trial has no use for.
Scene for_trials(Scene scene) {
    // Probes may ask for fields; their rows may not come in between.
    scene.output.every = scene.output.measure_every = 1e3 * *scene.run.duration;
    return scene;
}

}  // namespace

double wall_time() { return std::chrono::duration<double>(WallClock::now().time_since_epoch()).count(); }

ModelCosts measure_costs(const Scene& scene, const ParticleSet& particles, const Resources& resources, double seconds,
                         const std::function<double()>& clock) {
    const double start = clock();
    const Scene whole_scene = for_trials(scene);
    Trial whole(whole_scene, particles, resources);
    (void)whole.run(2);  // lists and memory
    const double first = clock();
    (void)whole.run(2);
    const double step_seconds = std::max(1e-6, (clock() - first) / 2);

    std::vector<Omission> left_out = omissions(whole_scene);
    std::vector<std::unique_ptr<Trial>> without;
    for (const Omission& omission : left_out) {
        if (clock() - start > 0.4 * seconds) break;
        without.push_back(std::make_unique<Trial>(omission.without, particles, resources));
        (void)without.back()->run(2);
    }
    // Ten rounds, so that a disturbance of the machine hits all alike or few rounds only.
    constexpr int rounds = 10;
    const double left = std::max(0.0, seconds - (clock() - start));
    const double a_round = left / (rounds * static_cast<double>(1 + without.size()));
    const long steps = std::clamp(static_cast<long>(a_round / step_seconds), 1L, 1000L);

    std::vector<Trial::Round> of_whole;
    std::vector<std::vector<Trial::Round>> of_others(without.size());
    for (int round = 0; round < rounds && (round < 1 || clock() - start < seconds); ++round) {
        of_whole.push_back(whole.run(steps));
        for (std::size_t k = 0; k < without.size(); ++k) of_others[k].push_back(without[k]->run(steps));
    }
    ModelCosts costs;
    costs.step = fastest_of("step", of_whole);
    costs.threads = of_whole.front().threads;
    for (const Trial::Round& round : of_whole) costs.steps += round.steps;
    for (const auto& [stage, ns] : std::ranges::min_element(of_whole, {}, &Trial::Round::ns)->stages)
        costs.stages.push_back({stage, ns, 0});
    std::ranges::sort(costs.stages, std::greater{}, &MeasuredTime::ns);
    for (std::size_t k = 0; k < without.size(); ++k) {
        const MeasuredTime other = fastest_of(left_out[k].model, of_others[k]);
        costs.models.push_back({other.of, costs.step.ns - other.ns, costs.step.spread + other.spread});
    }
    return costs;
}

}  // namespace dmp::solver
