// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "scene/scene.hpp"
#include "solver/output/displacement_measure.hpp"
#include "solver/output/gap_measure.hpp"
#include "solver/output/measure_series.hpp"
#include "solver/output/species_measures.hpp"
#include "solver/results/frame.hpp"
#include "solver/time/fluid_step.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Follows the scene's measures over time.
///   flux           volume per second through the line from -> to, positive to the right of who walks along it [m^3/s];
///                  particles count with a hat of one support radius across the line, so the sum does not jump
///   gap            smallest distance between centres of particles of different pieces of an elastic solid [m]
///   displacement   of an elastic solid (DisplacementMeasure), a column for each component [m]
///   body           place, velocity, angle, length and stretches of an elastic solid (BodyMeasure)
///   contact        force, area and largest pressure of what an elastic solid touches (SurfaceContact)
///   field          mean and extremes of a fluid field in a region (range_in_fluid)
///   solid_field    the same of an elastic solid (range_in_solid)
///   largest_speed  of the fluid [m/s]
///   density        lowest and highest density of the fluid over its rest density, two columns [-]
///   kinetic_energy of the fluid, SUM m |v|^2 / 2 [J]
///   probe          a fluid field at a point (Probe); vectors and tensors have a column for each component,
///                  residence_time for each region, concentration for each species; NaN where no fluid is
///   line           the same at points along a line, those of each point one after the other, NAME_1 ...
///   mode           factors of cos and sin in such a field, two columns for each component (FourierMode)
/// Those of a species: SpeciesMeasures.
class Measures {
  public:
    Measures(const Scene& scene, const ParticleSet& set, const PairSettings& settings, const Ranks& ranks);

    /// Adds a row. Throws InputError when a probe or line finds no fluid in the first one.
    void take(double time, const ParticleStore& particles, const FluidStep& fluid);

    [[nodiscard]] const MeasureSeries& series() const { return series_; }
    void archive(Archive& file);
    /// Whether a measure reads what follows from neighbours.
    [[nodiscard]] bool need_neighbours() const;

  private:
    struct Rows;

    /// Calls visit(i, nearest offset from `from`) for this rank's fluid.
    template <class Visit>
    void for_each_offset(const ParticleGroup& fluid, const Vec& from, const Visit& visit) const;
    [[nodiscard]] double over_all_ranks(ExactSum sum) const;
    [[nodiscard]] double flux(const Measure& measure, const FluidMoment& moment) const;
    /// Liquid that a particle of a thin strip stands in for.
    struct SheetLiquid {
        std::int64_t id;
        std::array<double, 3> middle;  ///< of the liquid [m]
        double volume;                 ///< [m^3]
    };
    [[nodiscard]] std::vector<SheetLiquid> liquid_in_strips(const ParticleStore& particles) const;
    [[nodiscard]] double kinetic_energy(const ParticleGroup& fluid) const;
    /// The columns of the field at each of the points. Throws InputError, with this location, when none finds fluid at
    /// first.
    [[nodiscard]] std::vector<double> field_at(const std::vector<Vec>& points, const SourceLocation& location,
                                               const Measure& measure, const FluidMoment& moment) const;
    [[nodiscard]] std::vector<double> mode(const Measure& measure, const FluidMoment& moment) const;

    const Scene& scene_;
    ParticleSpace space_;
    PairSettings settings_;
    const Ranks& ranks_;
    std::vector<const Measure*> measures_;
    std::map<const Measure*, GapMeasure> gaps_;
    std::map<const Measure*, DisplacementMeasure> displacements_;
    MeasureSeries series_;
};

}  // namespace dmp::solver
