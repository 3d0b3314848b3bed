// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/species_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "particles/periodic_images.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double quotient(double a, double b) { return b != 0 ? a / b : nothing; }

/// Slope of the straight line through (t, y) by least squares; not a number from fewer than two times.
double slope(const std::vector<double>& t, const std::vector<double>& y) {
    double mean_t = 0, mean_y = 0, above = 0, below = 0;
    for (std::size_t k = 0; k < t.size(); ++k) {
        mean_t += t[k] / static_cast<double>(t.size());
        mean_y += y[k] / static_cast<double>(t.size());
    }
    for (std::size_t k = 0; k < t.size(); ++k) {
        above += (t[k] - mean_t) * (y[k] - mean_y);
        below += (t[k] - mean_t) * (t[k] - mean_t);
    }
    return quotient(above, below);
}

}  // namespace

struct SpeciesMeasures::Rows {
    using Self = SpeciesMeasures;
    using Values = std::vector<double>;

    static constexpr auto all = std::to_array<MeasureRow<SpeciesMeasures, FluidMoment>>({
        {MeasureKind::amount,
         [](const Self& self, const Measure& measure, const FluidMoment& moment) {
             return Values{moment.step.species()->held_by_particles(moment.particles, self.scene_.species_of(measure))};
         }},
        {MeasureKind::mean_concentration,
         [](const Self& self, const Measure& measure, const FluidMoment& moment) {
             return Values{self.mean(measure, moment)};
         }},
        {MeasureKind::profile,
         [](const Self& self, const Measure& measure, const FluidMoment& moment) {
             return self.profile(measure, moment);
         }},
        {MeasureKind::spread,
         [](const Self& self, const Measure& measure, const FluidMoment& moment) {
             return self.spread(measure, moment);
         }},
        {MeasureKind::wall_flux,
         [](const Self& self, const Measure& measure, const FluidMoment& moment) {
             return self.wall_flux(measure, moment);
         }},
        {MeasureKind::peclet,
         [](const Self& self, const Measure& measure, const FluidMoment& moment) {
             return Values{quotient(moment.step.extremes().largest_speed * measure.length, self.diffusivity(measure))};
         }},
        {MeasureKind::uptake,
         [](const Self& self, const Measure& measure, const FluidMoment& moment) {
             return self.uptake(measure, moment);
         }},
    });
};

std::vector<double> SpeciesMeasures::values(const Measure& measure, const FluidMoment& moment) const {
    static_assert(has_row_for_each(Rows::all, {MeasureSubject::species}));
    return row_of(Rows::all, measure.kind).values(*this, measure, moment);
}

template <class Visit>
void SpeciesMeasures::for_each_in_box(const Measure& measure, const FluidMoment& moment, const Visit& visit) const {
    const std::size_t species = scene_.species_of(measure);
    const Vec low = measure.from->cwiseMin(*measure.to), high = measure.from->cwiseMax(*measure.to);
    const ParticleGroup& fluid = moment.particles.fluid();
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        Vec position = Vec::Zero();
        bool inside = true;
        for (int axis = 0; axis < space_.dimension; ++axis) {
            const double x = fluid.data(Field::position, axis)[i];
            position[axis] = space_.periodic[axis] ? wrapped(x, space_.box.low[axis], space_.box.high[axis])
                                                   : space_.mirrored_back(x, axis);
            inside = inside && (!measure.from.given() || (position[axis] >= low[axis] && position[axis] < high[axis]));
        }
        if (!inside) continue;
        visit(i, position, fluid.data(Field::species_amount, static_cast<int>(species))[i],
              moment.step.species()->rest_volume(fluid, i));
    }
}

double SpeciesMeasures::over_all_ranks(ExactSum sum) const {
    ranks_.sum(sum);
    return sum.value();
}

double SpeciesMeasures::mean(const Measure& measure, const FluidMoment& moment) const {
    ExactSum amounts, volumes;
    for_each_in_box(measure, moment, [&](std::size_t, const Vec&, double amount, double volume) {
        amounts.add(amount);
        volumes.add(volume);
    });
    return quotient(over_all_ranks(amounts), over_all_ranks(volumes));
}

std::vector<double> SpeciesMeasures::profile(const Measure& measure, const FluidMoment& moment) const {
    const auto axis = static_cast<int>(*measure.axis);
    const auto bins = static_cast<std::size_t>(*measure.bins);
    const bool boxed = measure.from.given();
    const double low = boxed ? std::min((*measure.from)[axis], (*measure.to)[axis]) : space_.box.low[axis];
    const double high = boxed ? std::max((*measure.from)[axis], (*measure.to)[axis]) : space_.box.high[axis];
    std::vector<ExactSum> amounts(bins), volumes(bins);
    for_each_in_box(measure, moment, [&](std::size_t, const Vec& position, double amount, double volume) {
        const double share = std::floor((position[axis] - low) / (high - low) * static_cast<double>(bins));
        const auto bin = static_cast<std::size_t>(std::clamp(share, 0.0, static_cast<double>(bins - 1)));
        amounts[bin].add(amount);
        volumes[bin].add(volume);
    });
    std::vector<double> values;
    for (std::size_t bin = 0; bin < bins; ++bin)
        values.push_back(quotient(over_all_ranks(amounts[bin]), over_all_ranks(volumes[bin])));
    return values;
}

std::vector<double> SpeciesMeasures::spread(const Measure& measure, const FluidMoment& moment) const {
    const MeasureSeries& series = moment.series;
    const auto axis = static_cast<int>(*measure.axis);
    ExactSum amounts, moments;
    for_each_in_box(measure, moment, [&](std::size_t, const Vec& position, double amount, double) {
        amounts.add(amount);
        moments.add(amount * position[axis]);
    });
    const double all = over_all_ranks(amounts), mean_position = quotient(over_all_ranks(moments), all);
    const double centre = measure.about.given() ? *measure.about : mean_position;
    ExactSum squares;
    for_each_in_box(measure, moment, [&](std::size_t, const Vec& position, double amount, double) {
        const double offset = position[axis] - centre;
        squares.add(amount * (offset * offset));
    });
    const double variance = quotient(over_all_ranks(squares), all);
    std::vector<double> times, variances;
    for (std::size_t row = 0; row < series.rows.size(); ++row) {
        if (!std::isfinite(series.rows[row][moment.first])) continue;
        times.push_back(series.time[row]);
        variances.push_back(series.rows[row][moment.first]);
    }
    times.push_back(moment.time);
    variances.push_back(variance);
    const double effective = 0.5 * slope(times, variances);
    return {variance, effective, quotient(effective, diffusivity(measure))};
}

/// What was taken since the last row, over the time; and in all.
std::vector<double> SpeciesMeasures::rate_and_total(double taken, const FluidMoment& moment) {
    const MeasureSeries& series = moment.series;
    const bool begun = !series.rows.empty();
    const double before = begun ? series.rows.back()[moment.first + 1] : 0, since = begun ? series.time.back() : 0;
    return {quotient(taken - before, moment.time - since), taken};
}

std::vector<double> SpeciesMeasures::uptake(const Measure& measure, const FluidMoment& moment) const {
    const std::size_t species = scene_.species_of(measure);
    if (measure.part->empty()) return rate_and_total(moment.step.species()->taken_up(species), moment);
    const int part = space_.part_named(measure.part);
    if (part < 0) return {nothing, nothing};
    return rate_and_total(moment.step.species()->taken_up(species, static_cast<std::uint16_t>(part)), moment);
}

std::vector<double> SpeciesMeasures::wall_flux(const Measure& measure, const FluidMoment& moment) const {
    const int part = space_.part_named(measure.part);
    if (part < 0) return std::vector<double>(measure_columns(scene_, measure).size(), nothing);
    const double taken = moment.step.species()->taken_by_surfaces(moment.particles, scene_.species_of(measure),
                                                                  static_cast<std::uint16_t>(part));
    std::vector<double> values = rate_and_total(taken, moment);
    if (!measure.length.given()) return values;
    const double difference = mean(measure, moment) - wall_concentration(measure, moment.particles);
    values.push_back(quotient(values.front() * measure.length, measure.area * diffusivity(measure) * difference));
    return values;
}

/// The mean over the wall's particles, as they were last shown.
double SpeciesMeasures::wall_concentration(const Measure& measure, const ParticleStore& particles) const {
    const int part = space_.part_named(measure.part);
    const ParticleGroup& group = particles.of(space_.parts[static_cast<std::size_t>(part)].kind);
    const auto species = static_cast<int>(scene_.species_of(measure));
    ExactSum sum;
    std::int64_t count = 0;
    for (std::size_t i = 0; i < group.owned(); ++i) {
        if (group.tags()[i].part != part) continue;
        sum.add(group.data(Field::concentration, species)[i]);
        ++count;
    }
    return quotient(over_all_ranks(sum), static_cast<double>(ranks_.sum(count)));
}

const Species& SpeciesMeasures::species_of(const Measure& measure) const {
    return scene_.species[scene_.species_of(measure)];
}

/// Of the first fluid.
double SpeciesMeasures::diffusivity(const Measure& measure) const {
    return **species_of(measure).diffusivity_in(*scene_.parts_of(PartKind::fluid).front());
}

}  // namespace dmp::solver
