// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "base/errors.hpp"
#include "solver/contact/surface_contact.hpp"
#include "solver/output/aggregates.hpp"
#include "solver/output/body_measure.hpp"
#include "solver/output/field_measure.hpp"
#include "solver/output/fluid_fields.hpp"
#include "solver/output/fourier_mode.hpp"
#include "solver/output/probe.hpp"

namespace dmp::solver {

namespace {

bool is_about_enabled_parts(const Scene& scene, const Measure& measure) {
    if (!is_of_elastic_part(measure.kind)) return true;
    const auto is_there = [&](const std::string& name) {
        const Part* part = scene.part_named(name);
        return part == nullptr || *part->enabled;  // what is no part is a [[solidify]]
    };
    return is_there(measure.part) && is_there(measure.against);
}

/// A region that never holds fluid is a slip of the pen.
void need_region_in_box(const Scene& scene, const Measure& measure, const ParticleSpace& space) {
    for (const ResidenceRegion& region : scene.regions)
        for (int axis = 0; axis < space.dimension; ++axis) {
            const auto [low, high] = std::minmax({(*region.from)[axis], (*region.to)[axis]});
            if (*region.name == *measure.region && (high < space.box.low[axis] || low > space.box.high[axis]))
                throw InputError(
                    region.from.location,
                    "region '" + *region.name + "' of measure '" + *measure.name + "' lies outside of all particles",
                    "correct its corners; 'dmp mesh' says where the particles are");
        }
}

void need_surfaces(const Measure& measure, const PairSettings& settings) {
    if (settings.surface_contact) return;
    throw InputError(
        measure.kind.location,
        "measure '" + *measure.name + "' is of contact between surfaces, and the particles come without them",
        "let the mesher make the particles from the geometry");
}

void need_long_waves(const Measure& measure, const ParticleSpace& space) {
    if (FourierMode(measure.waves, space).spacings() >= 4) return;
    throw InputError(
        measure.waves.location,
        "the waves of measure '" + *measure.name + "' are shorter than 4 spacings: particles cannot show them",
        "give fewer waves, or a smaller particles.spacing");
}

}  // namespace

struct Measures::Rows {
    using Values = std::vector<double>;

    static constexpr auto all = std::to_array<MeasureRow<Measures, FluidMoment>>({
        {MeasureKind::flux,
         [](const Measures& self, const Measure& measure, const FluidMoment& moment) {
             return Values{self.flux(measure, moment)};
         }},
        {MeasureKind::gap,
         [](const Measures& self, const Measure& measure, const FluidMoment& moment) {
             return Values{self.gaps_.at(&measure).smallest(moment.step.springs())};
         }},
        {MeasureKind::displacement,
         [](const Measures& self, const Measure& measure, const FluidMoment& moment) {
             const Vec mean = self.displacements_.at(&measure).mean(moment.step.springs());
             return Values(mean.data(), mean.data() + self.space_.dimension);
         }},
        {MeasureKind::body,
         [](const Measures& self, const Measure& measure, const FluidMoment& moment) {
             const auto& rows = moment.series.rows;
             const BodyMeasure body(self.scene_, measure, moment.step.springs());
             // Its column is behind those of position and velocity.
             const std::size_t angle = moment.first + 2 * static_cast<std::size_t>(self.space_.dimension);
             return body.values(rows.empty() ? 0 : rows.back().at(angle));
         }},
        {MeasureKind::contact,
         [](const Measures& self, const Measure& measure, const FluidMoment& moment) {
             const auto [force, area, pressure] = moment.step.surface_contact()->sums(*measure.part, *measure.against);
             Values values(force.data(), force.data() + self.space_.dimension);
             values.insert(values.end(), {area, pressure});
             return values;
         }},
        {MeasureKind::field,
         [](const Measures& self, const Measure& measure, const FluidMoment& moment) {
             return range_in_fluid(self.scene_, measure, moment.particles, moment.step);
         }},
        {MeasureKind::solid_field,
         [](const Measures&, const Measure& measure, const FluidMoment& moment) {
             return range_in_solid(measure, moment.particles, moment.step);
         }},
        {MeasureKind::largest_speed,
         [](const Measures&, const Measure&, const FluidMoment& moment) {
             return Values{moment.step.extremes().largest_speed};
         }},
        {MeasureKind::density,
         [](const Measures&, const Measure&, const FluidMoment& moment) {
             const FluidExtremes extremes = moment.step.extremes();
             return Values{extremes.density_low, extremes.density_high};
         }},
        {MeasureKind::kinetic_energy,
         [](const Measures& self, const Measure&, const FluidMoment& moment) {
             return Values{self.kinetic_energy(moment.particles.fluid())};
         }},
        {MeasureKind::aggregate,
         [](const Measures&, const Measure& measure, const FluidMoment& moment) {
             const SpringBodies& springs = moment.step.springs();
             const auto origin = std::ranges::find(springs.names(), *measure.part) - springs.names().begin();
             return values_of(aggregate_of(springs, static_cast<int>(origin)));
         }},
        {MeasureKind::probe,
         [](const Measures& self, const Measure& measure, const FluidMoment& moment) {
             return self.field_at({measure.point}, measure.point.location, measure, moment);
         }},
        {MeasureKind::line,
         [](const Measures& self, const Measure& measure, const FluidMoment& moment) {
             std::vector<Vec> points;
             for (int k = 0; k < *measure.points; ++k)
                 points.push_back(measure.from.value +
                                  (measure.to.value - measure.from.value) * k / (*measure.points - 1));
             return self.field_at(points, measure.from.location, measure, moment);
         }},
        {MeasureKind::mode,
         [](const Measures& self, const Measure& measure, const FluidMoment& moment) {
             return self.mode(measure, moment);
         }},
    });
};

Measures::Measures(const Scene& scene, const ParticleSet& set, const PairSettings& settings, const Ranks& ranks)
    : scene_(scene), space_(static_cast<const ParticleSpace&>(set)), settings_(settings), ranks_(ranks) {
    static_assert(has_row_for_each(Rows::all, {MeasureSubject::any, MeasureSubject::flow, MeasureSubject::solids}));
    for (const Measure& measure : scene.measures) {
        if (!is_about_enabled_parts(scene, measure)) continue;  // the part was left out, and so is what is asked of it
        measures_.push_back(&measure);
        if (*measure.kind == MeasureKind::mode) need_long_waves(measure, space_);
        if (*measure.kind == MeasureKind::contact) need_surfaces(measure, settings);
        if (*measure.kind == MeasureKind::gap) gaps_.try_emplace(&measure, measure, set);
        if (*measure.kind == MeasureKind::displacement) displacements_.try_emplace(&measure, measure, set);
        if (*measure.kind == MeasureKind::body) BodyMeasure::need_ends(measure, set);
        if (*measure.kind == MeasureKind::field) need_region_in_box(scene, measure, space_);
        for (const auto& [name, unit] : measure_columns(scene, measure)) {
            series_.names.push_back(name);
            series_.units.push_back(unit);
        }
    }
}

void Measures::take(double time, const ParticleStore& particles, const FluidStep& fluid) {
    std::vector<double> row;
    for (const Measure* measure : measures_) {
        const FluidMoment moment{time, particles, fluid, series_, row.size()};
        const std::vector<double> values = is_of_species(measure->kind)
                                               ? SpeciesMeasures(scene_, space_, ranks_).values(*measure, moment)
                                               : row_of(Rows::all, measure->kind).values(*this, *measure, moment);
        row.insert(row.end(), values.begin(), values.end());
    }
    series_.time.push_back(time);
    series_.rows.push_back(std::move(row));
}

void Measures::archive(Archive& file) { archive_series(file, series_); }

template <class Visit>
void Measures::for_each_offset(const ParticleGroup& fluid, const Vec& from, const Visit& visit) const {
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        Vec offset = Vec::Zero();
        for (int axis = 0; axis < space_.dimension; ++axis)
            offset[axis] = fluid.data(Field::position, axis)[i] - from[axis];
        visit(i, nearest_image(offset, space_));
    }
}

double Measures::over_all_ranks(ExactSum sum) const {
    ranks_.sum(sum);
    return sum.value();
}

/// Two rows of particles stand to both sides of a strip, each a spacing thick, where its surface is nearer to the
/// middle: what is beyond it is liquid (docs/elastic.md).
std::vector<Measures::SheetLiquid> Measures::liquid_in_strips(const ParticleStore& particles) const {
    std::vector<SheetLiquid> liquids;
    const ParticleGroup& bodies = particles.of(PartKind::elastic);
    const double row = space_.spacing;
    for (std::size_t i = 0; i < bodies.owned() && bodies.has(Field::opposite_distance); ++i) {
        const ParticleTag& tag = bodies.tags()[i];
        const double depth = bodies.data(Field::wall_distance)[i], thickness = row / 2 - depth;
        const bool is_strip = scene_.part_of_particles(space_.parts[tag.part].name).mass_per_length > 0;
        const bool fills_its_rows = depth + bodies.data(Field::opposite_distance)[i] >= (2 - 1e-9) * row;
        if (!is_strip || fills_its_rows || !(thickness > 0)) continue;
        SheetLiquid liquid{tag.id, {}, bodies.data(Field::volume)[i] * thickness / row};
        for (int axis = 0; axis < space_.dimension; ++axis)
            liquid.middle.at(static_cast<std::size_t>(axis)) =
                bodies.data(Field::position, axis)[i] +
                (depth + thickness / 2) * bodies.data(Field::wall_normal, axis)[i];
        liquids.push_back(liquid);
    }
    return liquids;
}

double Measures::flux(const Measure& measure, const FluidMoment& moment) const {
    const Vec along = measure.to.value - measure.from.value;
    const double length = along.norm();
    const Vec tangent = along / length;
    const Vec normal(tangent[1], -tangent[0], 0);
    const Vec middle = 0.5 * (measure.from.value + measure.to.value);
    const double half_width = settings_.support;
    /// What a volume counts, by its place from the middle [1/m].
    const auto weight = [&](const Vec& offset) {
        const double across = std::abs(offset.dot(normal));
        if (across >= half_width || std::abs(offset.dot(tangent)) > length / 2) return 0.0;
        return (1 - across / half_width) / half_width;
    };
    const ParticleGroup& fluid = moment.particles.fluid();
    ExactSum sum;
    for_each_offset(fluid, middle, [&](std::size_t i, const Vec& offset) {
        double speed = 0;
        for (int axis = 0; axis < space_.dimension; ++axis)
            speed += normal[axis] * fluid.data(Field::velocity, axis)[i];
        sum.add(fluid.data(Field::volume)[i] * speed * weight(offset));
    });
    std::vector<SheetLiquid> beside_line;
    for (const SheetLiquid& liquid : liquid_in_strips(moment.particles))
        if (weight(nearest_image(Vec(liquid.middle[0], liquid.middle[1], liquid.middle[2]) - middle, space_)) > 0)
            beside_line.push_back(liquid);
    beside_line = ranks_.all_gather(beside_line);
    double of_strips = 0;
    std::ranges::sort(beside_line, {}, &SheetLiquid::id);
    const std::vector<FluidValues> velocity =
        beside_line.empty() ? std::vector<FluidValues>{}
                            : FluidFields(scene_, moment.particles, moment.step).of(FluidField::velocity);
    for (const SheetLiquid& liquid : beside_line) {
        const Vec place(liquid.middle[0], liquid.middle[1], liquid.middle[2]);
        const Probe probe(place, FluidField::velocity, moment.particles, moment.step, settings_, ranks_);
        const std::vector<double> found = probe.of(velocity.front());
        if (!probe.is_in_fluid()) continue;  // pressed against something
        double speed = 0;
        for (int axis = 0; axis < space_.dimension; ++axis)
            speed += normal[axis] * found[static_cast<std::size_t>(axis)];
        of_strips += liquid.volume * speed * weight(nearest_image(place - middle, space_));
    }
    return over_all_ranks(sum) + of_strips;
}

double Measures::kinetic_energy(const ParticleGroup& fluid) const {
    ExactSum sum;
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        double square = 0;
        for (int axis = 0; axis < space_.dimension; ++axis) {
            const double speed = fluid.data(Field::velocity, axis)[i];
            square += speed * speed;
        }
        sum.add(0.5 * fluid.data(Field::mass)[i] * square);
    }
    return over_all_ranks(sum);
}

std::vector<double> Measures::mode(const Measure& measure, const FluidMoment& moment) const {
    const FourierMode mode(measure.waves, space_);
    std::vector<double> factors;
    for (const FluidValues& array : FluidFields(scene_, moment.particles, moment.step).of(measure.field))
        std::ranges::move(mode.of(array, moment.particles.fluid(), ranks_), std::back_inserter(factors));
    return factors;
}

bool Measures::need_neighbours() const {
    return std::ranges::any_of(measures_, [](const Measure* measure) {
        return reads_a_field(measure->kind) && FluidFields::need_neighbours(measure->field);
    });
}

std::vector<double> Measures::field_at(const std::vector<Vec>& points, const SourceLocation& location,
                                       const Measure& measure, const FluidMoment& moment) const {
    const std::vector<FluidValues> arrays = FluidFields(scene_, moment.particles, moment.step).of(measure.field);
    bool any_in_fluid = false;
    std::vector<double> values;
    for (const Vec& point : points) {
        const Probe probe(point, measure.field, moment.particles, moment.step, settings_, ranks_);
        any_in_fluid = any_in_fluid || probe.is_in_fluid();
        for (const FluidValues& array : arrays) std::ranges::move(probe.of(array), std::back_inserter(values));
    }
    if (moment.series.rows.empty() && !any_in_fluid)
        throw InputError(location,
                         "the " + to_string(*measure.kind) + " '" + *measure.name + "' stands where there is no fluid",
                         "move it into the fluid: no particle is within 1.5 spacings of it");
    return values;
}

}  // namespace dmp::solver
