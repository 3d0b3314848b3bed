// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/field_measure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "particles/periodic_images.hpp"
#include "solver/output/fluid_fields.hpp"
#include "solver/output/frame_groups.hpp"

namespace dmp::solver {

namespace {

/// Values at places, and their range.
class Range {
  public:
    void add(double value, double weight, std::int64_t id, const Vec& place) {
        weighted_.add(weight * value);
        weights_.add(weight);
        if (!(value >= low_)) low_ = value;
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
        std::vector<double> values{sums[0].value() / sums[1].value(), ranks.smallest(low_), top.value};
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

/// Where a particle is shown.
Vec shown_place(const ParticleGroup& fluid, const ParticleSpace& space, std::size_t i) {
    Vec place = Vec::Zero();
    for (int axis = 0; axis < space.dimension; ++axis) {
        double x = fluid.data(Field::position, axis)[i];
        if (space.periodic[axis]) x = wrapped(x, space.box.low[axis], space.box.high[axis]);
        place[axis] = space.mirrored_back(x, axis);
    }
    return place;
}

/// Of a field's arrays, one for each region or species, that of the measure.
const FluidValues& chosen(const std::vector<FluidValues>& arrays, const Scene& scene, const Measure& measure) {
    if (*measure.field == FluidField::concentration) return arrays[scene.species_of(measure)];
    if (*measure.field != FluidField::residence_time || measure.region->empty()) return arrays.front();
    const auto found = std::ranges::find(scene.regions, *measure.region, [](const auto& each) { return *each.name; });
    return arrays[static_cast<std::size_t>(found - scene.regions.begin())];
}

Vec place_of(const FrameGroup& group, std::size_t i) {
    return {group.position[3 * i], group.position[3 * i + 1], group.position[3 * i + 2]};
}

}  // namespace

std::vector<double> range_in_fluid(const Scene& scene, const Measure& measure, const ParticleStore& particles,
                                   const FluidStep& step) {
    const ParticleGroup& fluid = particles.fluid();
    const std::vector<FluidValues> arrays = FluidFields(scene, particles, step).of(measure.field);
    const FluidValues& field = chosen(arrays, scene, measure);
    const auto region = std::ranges::find(scene.regions, *measure.region, [](const auto& each) { return *each.name; });
    const bool everywhere = measure.region->empty();
    Range range;
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        const Vec place = shown_place(fluid, particles.space(), i);
        bool inside = true;
        for (int axis = 0; axis < fluid.dimension() && !everywhere; ++axis) {
            const auto [low, high] = std::minmax({(*region->from)[axis], (*region->to)[axis]});
            inside = inside && place[axis] >= low && place[axis] < high;
        }
        if (inside)
            range.add(size_of(field.values, field.components, i), fluid.data(Field::volume)[i], fluid.tags()[i].id,
                      place);
    }
    return range.values(step.neighbours().ranks(), fluid.dimension());
}

std::vector<double> range_in_solid(const Measure& measure, const ParticleStore& particles, const FluidStep& step) {
    const SolidGroup solid = solid_group(particles, step, {measure.solid_field}, nullptr);
    const FrameGroup& group = solid.group;
    const auto& parts = particles.space().parts;
    const auto part =
        std::ranges::find(parts, *measure.part, [](const auto& each) { return each.name; }) - parts.begin();
    Range range;  // on the first rank, which has all
    if (!group.fields.empty()) {
        const FrameField& field = group.fields.front();
        for (std::size_t i = 0; i < group.size(); ++i) {
            if (group.part[i] != part) continue;
            const double value = size_of(field.values, field.components, i);
            const bool has_none = *measure.solid_field == SolidField::traction && value == 0;
            if (!has_none) range.add(value, static_cast<double>(solid.volume[i]), group.id[i], place_of(group, i));
        }
    }
    if (!group.bond_fields.empty()) {
        const FrameField& field = group.bond_fields.front();
        for (std::size_t bond = 0; bond < group.bonds(); ++bond) {
            const auto a = static_cast<std::size_t>(group.bond_ends[2 * bond]),
                       b = static_cast<std::size_t>(group.bond_ends[2 * bond + 1]);
            if (group.part[a] != part) continue;
            const Vec apart = nearest_image(place_of(group, b) - place_of(group, a), particles.space());
            range.add(static_cast<double>(field.values[bond]), 1, static_cast<std::int64_t>(bond),
                      place_of(group, a) + 0.5 * apart);
        }
    }
    return range.values(step.neighbours().ranks(), particles.dimension());
}

}  // namespace dmp::solver
