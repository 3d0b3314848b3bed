// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/field_measure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "particles/periodic_images.hpp"
#include "solver/output/fluid_fields.hpp"
#include "solver/output/frame_groups.hpp"
#include "solver/output/surface_traction.hpp"

namespace dmp::solver {

namespace {

/// Values at places, and their range.
class Range {
  public:
    void add(double value, double weight, std::int64_t id, const Vec& place) {
        weighted_.add(weight * value);  // NaN, if one is
        weights_.add(weight);
        low_ = std::min(low_, value);
        const Highest here{value, id, {place[0], place[1], place[2]}};
        if (highest_.empty())
            highest_.push_back(here);
        else if (is_before(here, highest_.front()))
            highest_.front() = here;
    }

    /// Mean, lowest, highest and the place of the highest. All ranks together.
    [[nodiscard]] std::vector<double> values(const Ranks& ranks, int dimension) const {
        std::array<ExactSum, 2> sums{weighted_, weights_};
        ranks.sum(sums);
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        const std::vector<Highest> highest = ranks.all_gather(highest_);
        if (highest.empty()) return std::vector<double>(3 + static_cast<std::size_t>(dimension), none);
        const Highest& top = *std::ranges::min_element(highest, is_before);
        const double mean = sums[0].value() / sums[1].value(), low = ranks.smallest(low_);
        if (std::isnan(mean)) return std::vector<double>(3 + static_cast<std::size_t>(dimension), mean);
        std::vector<double> values{mean, low, top.value};
        values.insert(values.end(), top.place.begin(), top.place.begin() + dimension);
        return values;
    }

  private:
    struct Highest {
        double value;
        std::int64_t id;
        std::array<double, 3> place;  ///< [m]
    };
    static bool is_before(const Highest& a, const Highest& b) {
        return a.value != b.value ? a.value > b.value : a.id < b.id;
    }

    ExactSum weighted_, weights_;
    double low_ = std::numeric_limits<double>::infinity();
    std::vector<Highest> highest_;  ///< one, or none
};

/// The number itself, or the magnitude of a vector.
template <class Number>
double size_of(const std::vector<Number>& values, int components, std::size_t i) {
    if (components == 1) return static_cast<double>(values[i]);
    double square = 0;
    for (int c = 0; c < components; ++c) {
        const auto value =
            static_cast<double>(values[static_cast<std::size_t>(components) * i + static_cast<std::size_t>(c)]);
        square += value * value;
    }
    return std::sqrt(square);
}

const ResidenceRegion* region_of(const Scene& scene, const Measure& measure) {
    if (measure.region->empty()) return nullptr;
    return &*std::ranges::find(scene.regions, *measure.region, [](const auto& each) { return *each.name; });
}

/// Of a field's arrays, one for each region or species, that of the measure.
const FluidValues& chosen(const std::vector<FluidValues>& arrays, const Scene& scene, const Measure& measure) {
    if (*measure.field == FluidField::concentration) return arrays[scene.species_of(measure)];
    const ResidenceRegion* region = region_of(scene, measure);
    if (*measure.field != FluidField::residence_time || region == nullptr) return arrays.front();
    return arrays[static_cast<std::size_t>(region - scene.regions.data())];
}

Vec place_in_box(Vec place, const ParticleSpace& space) {
    for (int axis = 0; axis < space.dimension; ++axis)
        if (space.periodic[axis]) place[axis] = wrapped(place[axis], space.box.low[axis], space.box.high[axis]);
    return place;
}

Vec place_of(const FrameGroup& group, std::size_t i) {
    return {group.position[3 * i], group.position[3 * i + 1], group.position[3 * i + 2]};
}

/// Those that the particles of the measure's part have; each stands for the same share of the surface.
void add_tractions(Range& range, const Measure& measure, const ParticleStore& particles, const FluidStep& step) {
    const SpringBodies& springs = step.springs();
    const SurfaceTraction tractions(particles, springs, step.neighbours().ranks());
    if (!step.neighbours().ranks().is_first()) return;
    const auto origin = std::ranges::find(springs.names(), *measure.part) - springs.names().begin();
    const auto of_bodies = tractions.on(springs);
    for (std::size_t b = 0; b < of_bodies.size(); ++b) {
        const SpringBody& body = *springs.bodies()[b];
        for (std::size_t node = 0; node < body.nodes(); ++node)
            if (of_bodies[b][node] && body.origin(node) == origin)
                range.add(of_bodies[b][node]->norm(), 1, body.ids()[node],
                          place_in_box(body.position(node), particles.space()));
    }
}

/// The field of the particles or bonds of the measure's part.
void add_field(Range& range, const Measure& measure, const SolidGroup& solid, const ParticleSpace& space) {
    const FrameGroup& group = solid.group;
    const int part = space.part_named(*measure.part);
    if (!group.fields.empty()) {
        const FrameField& field = group.fields.front();
        for (std::size_t i = 0; i < group.size(); ++i)
            if (group.part[i] == part)
                range.add(size_of(field.values, field.components, i), static_cast<double>(solid.volume[i]), group.id[i],
                          place_of(group, i));
    }
    if (group.bond_fields.empty()) return;
    const FrameField& field = group.bond_fields.front();
    for (std::size_t bond = 0; bond < group.bonds(); ++bond) {
        const auto a = static_cast<std::size_t>(group.bond_ends[2 * bond]),
                   b = static_cast<std::size_t>(group.bond_ends[2 * bond + 1]);
        if (group.part[a] != part || group.part[b] != part) continue;
        const Vec apart = nearest_image(place_of(group, b) - place_of(group, a), space);
        range.add(static_cast<double>(field.values[bond]), 1, static_cast<std::int64_t>(bond),
                  place_in_box(place_of(group, a) + 0.5 * apart, space));
    }
}

}  // namespace

std::vector<double> range_in_fluid(const Scene& scene, const Measure& measure, const ParticleStore& particles,
                                   const FluidStep& step) {
    const ParticleGroup& fluid = particles.fluid();
    const std::vector<FluidValues> arrays = FluidFields(scene, particles, step).of(measure.field);
    const FluidValues& field = chosen(arrays, scene, measure);
    const ResidenceRegion* region = region_of(scene, measure);
    Range range;
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        const Vec place = shown_place(fluid, particles.space(), i);
        if (region == nullptr || region->contains(place, fluid.dimension()))
            range.add(size_of(field.values, field.components, i), fluid.data(Field::volume)[i], fluid.tags()[i].id,
                      place);
    }
    return range.values(step.neighbours().ranks(), fluid.dimension());
}

std::vector<double> range_in_solid(const Measure& measure, const ParticleStore& particles, const FluidStep& step) {
    const Ranks& ranks = step.neighbours().ranks();
    Range range;  // on the first rank, which has all
    if (*measure.solid_field == SolidField::traction)
        add_tractions(range, measure, particles, step);
    else
        add_field(range, measure, solid_group(particles, step, {measure.solid_field}, nullptr), particles.space());
    return range.values(ranks, particles.dimension());
}

}  // namespace dmp::solver
