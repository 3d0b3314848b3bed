// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "solver/output/velocity_gradient.hpp"

namespace dmp {

namespace {

const char* unit_of(FluidField field) {
    switch (field) {
        case FluidField::velocity:
            return "m/s";
        case FluidField::density:
            return "kg/m^3";
        case FluidField::pressure:
        case FluidField::shear_stress:
            break;
    }
    return "Pa";
}

/// A gap is between bodies.
void check_two_bodies(const Measure& measure, const ParticleSet& set) {
    int body = -1;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.parts[set.part[i]].name != measure.part.value) continue;
        if (body >= 0 && set.body[i] != body) return;
        body = set.body[i];
    }
    throw InputError(measure.part.place,
                     "'" + measure.part.value + "' is one body, and the gap '" + measure.name.value +
                         "' is measured between two of one part",
                     "leave the measure out, or draw the part as two curves");
}

bool is_about_enabled_parts(const Scene& scene, const Measure& measure) {
    if (measure.kind.value != MeasureKind::gap) return true;
    const auto parts = scene.parts_of(PartKind::springs);
    return std::any_of(parts.begin(), parts.end(),
                       [&](const Part* part) { return part->name.value == measure.part.value; });
}

}  // namespace

Measures::Measures(const Scene& scene, const ParticleSet& set, const PairSettings& settings)
    : set_(set), settings_(settings) {
    const auto column = [&](const std::string& name, const char* unit) {
        series_.names.push_back(name);
        series_.units.emplace_back(unit);
    };
    for (const Measure& measure : scene.measures) {
        if (!is_about_enabled_parts(scene, measure)) continue;  // the part was left out, and so is what is asked of it
        measures_.push_back(&measure);
        const std::string& name = measure.name;
        switch (measure.kind.value) {
            case MeasureKind::flux:
                column(name, "m^3/s");
                break;
            case MeasureKind::gap:
                check_two_bodies(measure, set);
                column(name, "m");
                break;
            case MeasureKind::largest_speed:
                column(name, "m/s");
                break;
            case MeasureKind::density:
                column(name + "_low", "1");
                column(name + "_high", "1");
                break;
            case MeasureKind::probe:
                if (measure.field.value == FluidField::velocity) {
                    for (int axis = 0; axis < set.dimension; ++axis)
                        column(name + "_" + std::string(1, "xyz"[axis]), unit_of(measure.field));
                } else {
                    column(name, unit_of(measure.field));
                }
        }
    }
}

void Measures::take(double time, const ParticleStore& particles, const FluidStep& fluid) {
    std::vector<double> row;
    for (const Measure* measure : measures_) {
        switch (measure->kind.value) {
            case MeasureKind::flux:
                row.push_back(flux(*measure, particles));
                break;
            case MeasureKind::gap:
                row.push_back(gap(*measure, particles));
                break;
            case MeasureKind::largest_speed:
                row.push_back(fluid.extremes().largest_speed);
                break;
            case MeasureKind::density: {
                const FluidExtremes extremes = fluid.extremes();
                row.push_back(extremes.density_low);
                row.push_back(extremes.density_high);
                break;
            }
            case MeasureKind::probe: {
                const auto values = probe(*measure, particles, fluid);
                if (series_.rows.empty() && std::isnan(values[0]))
                    throw InputError(measure->point.place,
                                     "the probe '" + measure->name.value + "' stands where there is no fluid",
                                     "move its point into the fluid: no particle is within the kernel's support of it");
                row.insert(row.end(), values.begin(), values.end());
            }
        }
    }
    series_.time.push_back(time);
    series_.rows.push_back(std::move(row));
}

Vec Measures::nearest_offset(const ParticleStore& particles, int i, const Vec& from) const {
    Vec offset = Vec::Zero();
    for (int axis = 0; axis < set_.dimension; ++axis) {
        offset[axis] = particles.data(Field::position, axis)[i] - from[axis];
        if (!set_.periodic[axis]) continue;
        const double period = set_.box.high[axis] - set_.box.low[axis];
        offset[axis] -= period * std::round(offset[axis] / period);
    }
    return offset;
}

double Measures::flux(const Measure& measure, const ParticleStore& particles) const {
    const Vec along = measure.to.value - measure.from.value;
    const double length = along.norm();
    const Vec tangent = along / length;
    const Vec normal(tangent[1], -tangent[0], 0);
    const Vec middle = 0.5 * (measure.from.value + measure.to.value);
    const double half_width = settings_.support;
    double sum = 0;
    for (const int i : particles.ids(ParticleKind::fluid)) {
        const Vec offset = nearest_offset(particles, i, middle);
        const double across = std::abs(offset.dot(normal));
        if (across >= half_width || std::abs(offset.dot(tangent)) > length / 2) continue;
        double speed = 0;
        for (int axis = 0; axis < set_.dimension; ++axis)
            speed += normal[axis] * particles.data(Field::velocity, axis)[i];
        sum += particles.data(Field::volume)[i] * speed * (1 - across / half_width) / half_width;
    }
    return sum;
}

double Measures::gap(const Measure& measure, const ParticleStore& particles) const {
    std::vector<int> ids;
    for (const int i : particles.ids(ParticleKind::springs))
        if (set_.parts[set_.part[i]].name == measure.part.value) ids.push_back(i);
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < ids.size(); ++a) {
        Vec here = Vec::Zero();
        for (int axis = 0; axis < set_.dimension; ++axis) here[axis] = particles.data(Field::position, axis)[ids[a]];
        for (std::size_t b = a + 1; b < ids.size(); ++b)
            if (set_.body[ids[a]] != set_.body[ids[b]])
                smallest = std::min(smallest, nearest_offset(particles, ids[b], here).squaredNorm());
    }
    return std::sqrt(smallest);
}

std::vector<double> Measures::probe(const Measure& measure, const ParticleStore& particles,
                                    const FluidStep& fluid) const {
    const FluidField field = measure.field;
    const auto& ids = particles.ids(ParticleKind::fluid);
    const std::vector<double> stress = field == FluidField::shear_stress
                                           ? shear_stress(particles, fluid.list(), fluid.sweeps())
                                           : std::vector<double>();
    std::vector<double> sum(field == FluidField::velocity ? static_cast<std::size_t>(set_.dimension) : 1, 0.0);
    double weights = 0;
    for (std::size_t k = 0; k < ids.size(); ++k) {
        const int i = ids[k];
        const double distance = nearest_offset(particles, i, measure.point).norm();
        if (distance >= settings_.support) continue;
        const double weight = particles.data(Field::volume)[i] * fluid.sweeps().kernel_value(distance);
        weights += weight;
        switch (field) {
            case FluidField::velocity:
                for (std::size_t axis = 0; axis < sum.size(); ++axis)
                    sum[axis] += weight * particles.data(Field::velocity, static_cast<int>(axis))[i];
                break;
            case FluidField::pressure:
                sum[0] += weight * particles.data(Field::pressure)[i];
                break;
            case FluidField::density:
                sum[0] += weight * particles.data(Field::density)[i];
                break;
            case FluidField::shear_stress:
                sum[0] += weight * stress[k];
        }
    }
    // No fluid there now: not a number, which the tables write as empty.
    for (double& value : sum) value = weights > 0 ? value / weights : std::numeric_limits<double>::quiet_NaN();
    return sum;
}

}  // namespace dmp
