// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/spheres/sphere_measures.hpp"
#include "solver/spheres/sphere_step.hpp"
#include "solver/spheres/steady_state.hpp"
#include "solver/spheres/step_by_hand.hpp"
#include "solver/state/schedule.hpp"
#include "solver/time/run.hpp"

namespace dmp::solver {

/// The run of spheres and their walls.
class SphereRun final : public Run {
  public:
    SphereRun(Scene scene, const ParticleSet& set, const Resources& resources);

    [[nodiscard]] Plan plan() const override;

  protected:
    [[nodiscard]] const Ranks& ranks() const override { return ranks_; }
    [[nodiscard]] double time() const override { return time_; }
    [[nodiscard]] double duration() const override { return scene_.run.duration; }
    [[nodiscard]] std::int64_t step() const override { return step_count_; }
    [[nodiscard]] long frames() const override { return static_cast<long>(frames_); }
    void start(FrameSink* sink) override;
    [[nodiscard]] Step next_step(const RunOptions& options) override;
    void advance(const RunOptions& options, const Step& step) override;
    void finish(FrameSink* sink) override;
    [[nodiscard]] bool finished() const override { return steady_state_.reached(); }
    void write_frame(FrameSink* sink) override;
    void take_measures() override { measures_.take(time_, step_); }
    void write_diverged_frame(FrameSink* sink) override { write_frame(sink); }
    void archive(Archive& file) override;
    [[nodiscard]] RunProgress progress(double until) const override;
    [[nodiscard]] const MeasureSeries& series() const override { return measures_.series(); }
    [[nodiscard]] RunSummary summary() const override;
    [[nodiscard]] RankShares shares(std::int64_t steps) const override;

  private:
    [[nodiscard]] std::vector<StepLimit> contact_limits() const;
    /// With the step by hand and what drives the scene.
    [[nodiscard]] std::vector<StepLimit> limits_without_shapes() const;
    /// The one that determines the step.
    [[nodiscard]] StepLimit ruling_of(std::vector<StepLimit> all) const;
    [[nodiscard]] std::vector<StepLimit> limits() const;
    [[nodiscard]] double longest_step(const RunOptions& options);
    [[nodiscard]] std::vector<Warning> warnings(const SphereEnergy& end) const;
    [[nodiscard]] Conserved conserved() const;
    [[nodiscard]] SphereEnergy energy() const;
    void archive_accounts(Archive& file);
    [[nodiscard]] std::array<double, 2> radii_of_all_ranks() const;
    void write_what_is_due(FrameSink* sink);
    void stop_if_diverged(FrameSink* sink);

    Scene scene_;
    Ranks ranks_;
    Resources resources_;
    ParticleSpace space_;
    SphereSetup setup_;
    StepByHand by_hand_{scene_, setup_};
    ParticleGroup group_;
    SphereStep step_;
    SphereMeasures measures_;
    SteadyState steady_state_;
    std::map<std::string, std::size_t> count_;

    double time_ = 0;  ///< [s]
    std::int64_t step_count_ = 0;
    Schedule frame_times_, measure_times_;
    std::int64_t frames_ = 0;
    double last_frame_ = 0;                         ///< [s]
    bool begun_ = false;                            ///< lists and forces are there
    double limited_speed_ = -1, longest_step_ = 0;  ///< the speed for which the longest step is known [m/s], [s]
    double fastest_ = 0;                            ///< of the speeds for which it was found [m/s]
    Conserved at_start_;
    SphereEnergy energy_at_start_;
};

}  // namespace dmp::solver
