// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/measure.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <sstream>

#include "bench/half_list.hpp"
#include "bench/uses.hpp"
#include "solver/simulation.hpp"

namespace dmp::bench {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double nanoseconds = 1e9;

/// A line of /proc/self/status, "VmRSS:" or "VmHWM:" [bytes].
std::optional<double> memory(const std::string& wanted) {
    std::ifstream status("/proc/self/status");
    std::string line;
    while (std::getline(status, line)) {
        std::istringstream words(line);
        std::string key;
        double kibibytes = 0;
        if (words >> key >> kibibytes && key == wanted) return kibibytes * 1024;
    }
    return std::nullopt;
}

/// Largest resident set from its making on, above what there was [bytes].
class ResidentGrowth {
  public:
    ResidentGrowth() {
        std::ofstream refs("/proc/self/clear_refs");
        refs << "5" << std::flush;  // forget the largest so far
        if (refs) before_ = memory("VmRSS:");
    }
    [[nodiscard]] std::optional<double> bytes() const {
        const auto largest = memory("VmHWM:");
        if (!before_ || !largest) return std::nullopt;
        return *largest - *before_;
    }

  private:
    std::optional<double> before_;
};

/// Wall time, and how much of it this process had processors for: on a shared machine the rest was lost to others.
class Stopwatch {
  public:
    [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    [[nodiscard]] double share(int threads) const { return (processor_seconds() - used_) / (seconds() * threads); }

  private:
    static double processor_seconds() {
        timespec used{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
        return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) / nanoseconds;
    }
    Clock::time_point start_ = Clock::now();
    double used_ = processor_seconds();
};

/// Repeats of the engine on one start, each from the beginning.
class EngineRuns {
  public:
    EngineRuns(const Options& options, const Scene& scene, const ParticleSet& set)
        : options_(options), scene_(scene), set_(set) {}

    void run() {
        const ResidentGrowth growth;
        Resources resources(options_.threads);
        resources.vector_unit = options_.vector_unit;
        Simulation simulation(scene_, set_, resources);
        const Plan plan = simulation.plan();
        RunOptions run;
        run.until = options_.steps * plan.dt;
        const Stopwatch monitor;
        const RunSummary summary = simulation.run(run);
        processor_.push_back(monitor.share(options_.threads));

        const auto per_particle = [&](double seconds) {
            return seconds * summary.threads * nanoseconds /
                   (static_cast<double>(summary.steps) * static_cast<double>(set_.size()));
        };
        double in_stages = 0;
        for (const auto& [stage, seconds] : summary.seconds_by_stage) {
            stages_[stage].push_back(per_particle(seconds));
            in_stages += seconds;
        }
        stages_["rest"].push_back(per_particle(summary.wall_s - in_stages));
        steps_.push_back(per_particle(summary.wall_s));
        times_.steps = summary.steps;
        times_.step_seconds = summary.simulated_s / static_cast<double>(summary.steps);
        times_.viscous_iterations = summary.viscous_solves.mean_iterations();
        times_.density_low = summary.density_low / Liquid::density;
        times_.density_high = summary.density_high / Liquid::density;
        times_.planned_bytes = plan.bytes_per_particle;
        if (steps_.size() > 1) return;  // later repeats find memory that earlier ones left
        if (const auto bytes = growth.bytes()) times_.resident_bytes = *bytes / static_cast<double>(set_.size());
    }

    [[nodiscard]] EngineTimes times() const {
        EngineTimes times = times_;
        times.step = spread_of(steps_);
        times.processor = spread_of(processor_).median;
        for (const auto& [stage, values] : stages_) times.stage[stage] = spread_of(values);
        return times;
    }

  private:
    const Options& options_;
    const Scene& scene_;
    const ParticleSet& set_;
    std::vector<double> steps_, processor_;
    std::map<std::string, std::vector<double>> stages_;
    EngineTimes times_;
};

/// Repeats of the yardstick.
class YardstickRuns {
  public:
    explicit YardstickRuns(std::size_t particles) : particles_(static_cast<double>(particles)) {}

    void run(HalfList& list, int sweeps) {
        list.sweep();  // into the cache, as a loop of steps would have it
        const Stopwatch monitor;
        for (int k = 0; k < sweeps; ++k) list.sweep();
        sweeps_.push_back(monitor.seconds() * nanoseconds / (sweeps * particles_));
        processor_.push_back(monitor.share(1));
    }
    [[nodiscard]] Spread sweep() const { return spread_of(sweeps_); }
    [[nodiscard]] double processor() const { return spread_of(processor_).median; }

  private:
    double particles_;
    std::vector<double> sweeps_, processor_;
};

}  // namespace

Spread spread_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    const double median = values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
    return {median, values.front(), values.back()};
}

Measured measure(const Options& options) {
    const ParticleSet set = make_particles(options.channel);
    std::optional<Scene> scene;
    std::optional<EngineRuns> engine;
    if (!options.yardstick_only) {
        scene = make_scene(options.channel);
        engine.emplace(options, *scene, set);
    }
    std::unique_ptr<HalfList> list;
    std::optional<YardstickRuns> yardstick;
    for (int k = 0; k < options.repeat; ++k) {
        if (engine) engine->run();
        // Made after the engine's first run, so that its memory is not the engine's.
        if (!list) list = make_half_list(set, options.channel.kernel, options.channel.support * set.spacing);
        if (!yardstick) yardstick.emplace(list->particles());
        yardstick->run(*list, options.steps);
    }

    Measured measured;
    measured.fluid = set.count(PartKind::fluid);
    measured.walls = set.count(PartKind::rigid);
    const auto per_particle = [&](std::size_t pairs) {
        return static_cast<double>(pairs) / static_cast<double>(set.size());
    };
    measured.pairs = per_particle(list->pairs_within_support());
    measured.pairs_listed = per_particle(list->pairs_listed());
    measured.yardstick = yardstick->sweep();
    measured.yardstick_processor = yardstick->processor();
    if (engine) measured.engine = engine->times();
    return measured;
}

}  // namespace dmp::bench
