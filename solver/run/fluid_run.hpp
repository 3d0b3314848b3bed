// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "solver/monitor/concentration_monitor.hpp"
#include "solver/monitor/penetration_monitor.hpp"
#include "solver/monitor/stability_monitor.hpp"
#include "solver/monitor/void_monitor.hpp"
#include "solver/output/mean_displacement.hpp"
#include "solver/output/measures.hpp"
#include "solver/output/residence_times.hpp"
#include "solver/run/reached.hpp"
#include "solver/run/setup.hpp"
#include "solver/run/spring_strain.hpp"
#include "solver/run/velocity_change.hpp"
#include "solver/solidify/body_events.hpp"
#include "solver/state/schedule.hpp"
#include "solver/time/fluid_step.hpp"
#include "solver/time/run.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The run of a fluid with its walls and elastic solids.
class FluidRun final : public Run {
  public:
    FluidRun(Scene scene, const ParticleSet& set, const Resources& resources);

    [[nodiscard]] Plan plan() const override;

  protected:
    [[nodiscard]] const Ranks& ranks() const override { return ranks_; }
    [[nodiscard]] double time() const override { return time_; }
    [[nodiscard]] double duration() const override { return scene_.run.duration; }
    [[nodiscard]] std::int64_t step() const override { return step_; }
    [[nodiscard]] long frames() const override { return static_cast<long>(frames_); }
    void start(FrameSink* sink) override;
    [[nodiscard]] Step next_step(const RunOptions& options) override;
    void advance(const RunOptions& options, const Step& step) override;
    void finish(FrameSink* sink) override {
        stop_if_species_diverged(sink);
        fluid_.refresh_neighbours();
        strain_.add(fluid_.springs(), scene_);  // the summary has what it finds
    }
    void write_frame(FrameSink* sink) override;
    void take_measures() override;
    void write_diverged_frame(FrameSink* sink) override;
    void archive(Archive& file) override;
    [[nodiscard]] RunProgress progress(double until) const override;
    [[nodiscard]] const MeasureSeries& series() const override { return measures_.series(); }
    [[nodiscard]] RunSummary summary() const override;
    [[nodiscard]] RankShares shares(std::int64_t steps) const override;

  private:
    [[nodiscard]] Conserved conserved() const;
    [[nodiscard]] bool may_change_chambers() const;
    [[nodiscard]] bool watches_contact() const;
    /// Of the first chambers whose density drifts too far; then none any more.
    std::vector<Warning> new_chamber_warnings();
    [[nodiscard]] std::vector<Warning> chamber_warnings() const;
    [[nodiscard]] std::vector<StepLimit> limits_now(double largest_speed) const;
    /// The time at which what drives the scene changes, if that is before the target, else the target.
    [[nodiscard]] double next_change(double target) const;
    void archive_accounts(Archive& file);
    /// Accounts, the first row and the first frame of a run that starts from the state of another one.
    void start_from_state(FrameSink* sink);
    void write_what_is_due(FrameSink* sink);
    void stop_if_diverged(FrameSink* sink);
    void stop_if_species_diverged(FrameSink* sink);
    void add_fields(Plan& plan) const;
    void add_limits_of_elastic_solids(Plan& plan) const;

    SoundSpeed sound_;
    Scene scene_;
    std::vector<Warning> foreseen_;  ///< known before the first step, of what the results will be
    Ranks ranks_;
    std::map<std::string, std::size_t> count_;  ///< particles of all ranks by kind
    PairSettings settings_;                     // before the particles: the search for a free surface takes memory
    ParticleStore particles_;
    FluidStep fluid_;
    StepScales scales_;
    ResidenceTimes residence_times_;
    MeanDisplacement mean_displacement_;
    Measures measures_;
    BodyEvents events_;
    StabilityMonitor monitor_;
    ConcentrationMonitor concentrations_;
    VoidMonitor voids_;
    PenetrationMonitor penetration_;

    double time_ = 0;  ///< [s]
    std::int64_t step_ = 0;
    FluidExtremes extremes_{};  ///< of the last step
    Reached reached_;           ///< of all steps
    VelocityChange velocity_change_;
    SpringStrain strain_;
    Schedule frame_times_, measure_times_;
    std::int64_t frames_ = 0;
    std::int64_t warned_of_chambers_ = 0;  ///< 1 once there was one
    double last_frame_ = 0;                ///< time of the last frame [s]
    Conserved at_start_;
};

}  // namespace dmp::solver
