// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/run_loop.hpp"
#include "solver/spheres/sphere_measures.hpp"
#include "solver/spheres/sphere_step.hpp"
#include "solver/spheres/stillness.hpp"
#include "solver/time/schedule.hpp"

namespace dmp::solver {

/// A scene of spheres and their walls in motion: what Simulation is for such scenes.
class SphereRun final : public Steps {
  public:
    SphereRun(Scene scene, const ParticleSet& set, const Resources& resources);

    [[nodiscard]] Plan plan() const;
    long resume(const Hdf5Reader& reader);
    RunSummary run(const RunOptions& options);

    [[nodiscard]] double time() const override { return time_; }
    [[nodiscard]] std::int64_t step() const override { return step_count_; }
    void advance(const RunOptions& options, double until) override;
    void write_frame(FrameSink* sink) override;
    void archive(Archive& file) override;
    [[nodiscard]] RunProgress progress(double until) const override;
    [[nodiscard]] bool finished() const override { return stillness_.reached(); }

  private:
    [[nodiscard]] std::vector<StepLimit> contact_limits() const;
    [[nodiscard]] std::vector<StepLimit> limits() const;
    [[nodiscard]] double longest_step();
    [[nodiscard]] Conserved conserved() const;
    [[nodiscard]] SphereEnergy energy() const;
    void write_what_is_due(FrameSink* sink);
    void look(FrameSink* sink);
    [[nodiscard]] RunSummary summary() const;

    Scene scene_;
    Ranks ranks_;
    Resources resources_;
    ParticleSpace space_;
    SphereSetup setup_;
    ParticleGroup group_;
    SphereStep step_;
    SphereMeasures measures_;
    Stillness stillness_;
    std::map<std::string, std::size_t> count_;

    double time_ = 0;  ///< [s]
    std::int64_t step_count_ = 0;
    Schedule frame_times_, measure_times_;
    std::int64_t frames_ = 0;
    double last_frame_ = 0;                         ///< [s]
    bool begun_ = false;                            ///< lists and forces are there
    double limited_speed_ = -1, longest_step_ = 0;  ///< the speed for which the longest step is known [m/s], [s]
    Conserved at_start_;
    SphereEnergy energy_at_start_;
};

}  // namespace dmp::solver
