// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/sphere_measures.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "solver/output/measure_row.hpp"
#include "solver/output/measure_series.hpp"
#include "solver/spheres/steady_state.hpp"

namespace dmp::solver {

namespace {

/// Which ids hang together.
class Pieces {
  public:
    explicit Pieces(std::size_t ids) : parent_(ids) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
    std::size_t of(std::size_t id) {
        while (parent_[id] != id) id = parent_[id] = parent_[parent_[id]];
        return id;
    }
    void join(std::size_t a, std::size_t b) { parent_[of(a)] = of(b); }

  private:
    std::vector<std::size_t> parent_;
};

/// Pairs of ids of all ranks' spheres between which a force may act now.
std::vector<std::array<std::int64_t, 2>> touching_ids(const SphereStep& step, const Ranks& ranks) {
    std::vector<std::array<std::int64_t, 2>> own;
    const ContactList& list = step.neighbours().list();
    const auto motion = step.rows().motion();
    list.for_each([&](std::size_t k, std::int16_t) {
        const std::int32_t i = list.low()[k], j = list.high()[k];
        const double *a = motion[i].position.c, *b = motion[j].position.c;
        const double dx = a[0] - b[0], dy = a[1] - b[1], dz = a[2] - b[2], touch = a[3] + b[3] + step.setup().reach;
        if (dx * dx + dy * dy + dz * dz < touch * touch)
            own.push_back({step.group().tags()[i].id, step.group().tags()[j].id});
    });
    return ranks.all_gather(own);
}

}  // namespace

struct SphereMeasures::Rows {
    using Values = std::vector<double>;

    static constexpr auto
        all =
            std::
                to_array<MeasureRow<SphereMeasures, SphereStep>>(
                    {
                        {MeasureKind::largest_speed,
                         [](const SphereMeasures& self, const Measure&, const SphereStep& step) {
                             double largest = 0;
                             for (const SphereMotion& sphere : step.rows().motion().first(step.rows().owned()))
                                 largest = std::max(
                                     largest,
                                     Vec(sphere.velocity.c[0], sphere.velocity.c[1], sphere.velocity.c[2]).norm());
                             return Values{self.ranks_.largest(largest)};
                         }},
                        {MeasureKind::kinetic_energy,
                         [](const SphereMeasures& self, const Measure&, const SphereStep& step) {
                             return Values{solver::kinetic_energy(step, self.ranks_).kinetic()};
                         }},
                        {MeasureKind::velocity,
                         [](const SphereMeasures& self, const Measure& measure, const SphereStep& step) {
                             return self.mean_of(measure, step, &SphereMotion::velocity);
                         }},
                        {MeasureKind::spin,
                         [](const SphereMeasures& self, const Measure& measure, const SphereStep& step) {
                             return self.mean_of(measure, step, &SphereMotion::spin);
                         }},
                        {MeasureKind::wall_force,
                         [](const SphereMeasures& self, const Measure&, const SphereStep& step) {
                             Values values;
                             for (ExactSum force : step.walls().total_force()) {
                                 self.ranks_.sum(force);
                                 values.push_back(force.value());
                             }
                             return values;
                         }},
                        {MeasureKind::detached, [](const SphereMeasures& self, const Measure& measure,
                                                   const SphereStep& step) { return self.detached(measure, step); }},
                    });
};

SphereMeasures::SphereMeasures(const Scene& scene, const ParticleSet& set, const Ranks& ranks)
    : space_(set), initial_(set.position), part_of_id_(set.part), ranks_(ranks) {
    static_assert(has_row_for_each(Rows::all, {MeasureSubject::any, MeasureSubject::spheres}));
    for (const Measure& measure : scene.measures) {
        if (measure.part.given() && set.part_named(measure.part) < 0) continue;  // not enabled
        measures_.push_back(measure);
        for (const auto& [name, unit] : measure_columns(scene, measure)) {
            series_.names.push_back(name);
            series_.units.push_back(unit);
        }
    }
}

void SphereMeasures::take(double time, const SphereStep& step) {
    std::vector<double> row;
    for (const Measure& measure : measures_) {
        const std::vector<double> values = row_of(Rows::all, measure.kind).values(*this, measure, step);
        row.insert(row.end(), values.begin(), values.end());
    }
    series_.time.push_back(time);
    series_.rows.push_back(std::move(row));
}

std::vector<double> SphereMeasures::mean_of(const Measure& measure, const SphereStep& step,
                                            Row SphereMotion::*quantity) const {
    std::array<ExactSum, 3> sum;
    std::int64_t count = 0;
    for (std::size_t i = 0; i < step.rows().owned(); ++i) {
        if (space_.parts[step.group().tags()[i].part].name != *measure.part) continue;
        const Row& value = step.rows().motion()[i].*quantity;
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis].add(value.c[axis]);
        ++count;
    }
    const auto all = static_cast<double>(std::max<std::int64_t>(1, ranks_.sum(count)));
    ranks_.sum(sum);
    std::vector<double> mean;
    for (const ExactSum& axis : sum) mean.push_back(axis.value() / all);
    return mean;
}

std::vector<double> SphereMeasures::detached(const Measure& measure, const SphereStep& step) const {
    Pieces pieces(initial_.size());
    for (const auto& [a, b] : touching_ids(step, ranks_))
        pieces.join(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    const auto is_it = [&](int part) { return space_.parts[static_cast<std::size_t>(part)].name == *measure.part; };
    const auto carrier = static_cast<std::size_t>(std::ranges::find_if(part_of_id_, is_it) - part_of_id_.begin());
    double upper = 0, lower = 0;
    for (std::size_t id = 0; id < initial_.size(); ++id) {
        if (pieces.of(id) == pieces.of(carrier)) continue;
        (measure.direction->dot(initial_[id] - initial_[carrier]) > 0 ? upper : lower) += 1;
    }
    return {upper + lower, upper, lower};
}

void SphereMeasures::archive(Archive& file) { archive_series(file, series_); }

}  // namespace dmp::solver
