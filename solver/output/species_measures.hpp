// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "solver/output/measure_row.hpp"
#include "solver/results/frame.hpp"
#include "solver/time/fluid_step.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// What measures of a fluid are taken from.
struct FluidMoment {
    double time;  ///< [s]
    const ParticleStore& particles;
    const FluidStep& step;
    const MeasureSeries& series;  ///< the earlier rows
    std::size_t first;            ///< where the measure's columns begin in them
};

/// Measures of a species. Means are over the fluid's volume at rest, in the measure's box or everywhere.
///   amount              in all particles that carry the species
///   mean_concentration  SUM w / SUM V
///   profile             the same in each of `bins` equal parts along the axis, a column each, numbered from the low
///   end;
///                       no number where there is no fluid
///   spread              variance of the place along the axis, weighted with the amounts [m^2]; NAME_diffusivity, half
///   of
///                       its slope by least squares over all rows so far, the effective diffusivity [m^2/s]; and
///                       NAME_sherwood, that over the species' own diffusivity in the scene's first fluid
///   wall_flux           what a wall took since the last row, over the time [1/s]; NAME_total, what it has taken in
///   all;
///                       with length L and area A, NAME_sherwood = J L / (A D (c - c_w)), c the fluid's mean
///                       concentration, c_w the wall's, D as above
///   uptake              what a part, or all, took up since the last row, over the time [1/s]; NAME_total, since the
///                       start
///   peclet              U L / D, U the fluid's largest speed, D as above
class SpeciesMeasures {
  public:
    SpeciesMeasures(const Scene& scene, const ParticleSpace& space, const Ranks& ranks)
        : scene_(scene), space_(space), ranks_(ranks) {}

    [[nodiscard]] std::vector<double> values(const Measure& measure, const FluidMoment& moment) const;

  private:
    struct Rows;

    /// Calls visit(i, place, amount, volume) for this rank's fluid in the measure's box.
    template <class Visit>
    void for_each_in_box(const Measure& measure, const FluidMoment& moment, const Visit& visit) const;
    [[nodiscard]] double over_all_ranks(ExactSum sum) const;
    [[nodiscard]] double mean(const Measure& measure, const FluidMoment& moment) const;
    [[nodiscard]] std::vector<double> profile(const Measure& measure, const FluidMoment& moment) const;
    [[nodiscard]] std::vector<double> spread(const Measure& measure, const FluidMoment& moment) const;
    [[nodiscard]] static std::vector<double> rate_and_total(double taken, const FluidMoment& moment);
    [[nodiscard]] std::vector<double> uptake(const Measure& measure, const FluidMoment& moment) const;
    [[nodiscard]] std::vector<double> wall_flux(const Measure& measure, const FluidMoment& moment) const;
    [[nodiscard]] double wall_concentration(const Measure& measure, const ParticleStore& particles) const;
    [[nodiscard]] const Species& species_of(const Measure& measure) const;
    [[nodiscard]] double diffusivity(const Measure& measure) const;

    const Scene& scene_;
    const ParticleSpace& space_;
    const Ranks& ranks_;
};

}  // namespace dmp::solver
