// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/sphere_measures.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

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

SphereMeasures::SphereMeasures(const Scene& scene, const ParticleSet& set, const Ranks& ranks)
    : space_(set), initial_(set.position), part_of_id_(set.part), ranks_(ranks) {
    const auto columns = [&](const std::string& name, const std::vector<std::string>& endings, const char* unit) {
        for (const std::string& ending : endings) {
            series_.names.push_back(name + ending);
            series_.units.emplace_back(unit);
        }
    };
    const std::vector<std::string> axes{"_x", "_y", "_z"};
    for (const Measure& measure : scene.measures) {
        if (measure.part.given() && set.part_named(measure.part) < 0) continue;  // not enabled
        measures_.push_back(measure);
        switch (*measure.kind) {
            case MeasureKind::largest_speed:
                columns(measure.name, {""}, "m/s");
                break;
            case MeasureKind::kinetic_energy:
                columns(measure.name, {""}, "J");
                break;
            case MeasureKind::velocity:
                columns(measure.name, axes, "m/s");
                break;
            case MeasureKind::spin:
                columns(measure.name, axes, "rad/s");
                break;
            case MeasureKind::wall_force:
                columns(measure.name, axes, "N");
                break;
            case MeasureKind::detached:
                columns(measure.name, {"", "_upper", "_lower"}, "1");
                break;
            default:
                measures_.pop_back();  // the scene's checks have refused it
        }
    }
}

void SphereMeasures::take(double time, const SphereStep& step) {
    std::vector<double> row;
    const auto add = [&](const auto& values) { row.insert(row.end(), values.begin(), values.end()); };
    for (const Measure& measure : measures_) {
        switch (*measure.kind) {
            case MeasureKind::largest_speed: {
                double largest = 0;
                for (const SphereMotion& sphere : step.rows().motion().first(step.rows().owned()))
                    largest =
                        std::max(largest, Vec(sphere.velocity.c[0], sphere.velocity.c[1], sphere.velocity.c[2]).norm());
                row.push_back(ranks_.largest(largest));
                break;
            }
            case MeasureKind::kinetic_energy:
                row.push_back(solver::kinetic_energy(step, ranks_).kinetic());
                break;
            case MeasureKind::wall_force:
                for (ExactSum force : step.walls().total_force()) {
                    ranks_.sum(force);
                    row.push_back(force.value());
                }
                break;
            case MeasureKind::detached:
                add(detached(measure, step));
                break;
            default:
                add(mean_of(measure, step));
        }
    }
    series_.time.push_back(time);
    series_.rows.push_back(std::move(row));
}

std::vector<double> SphereMeasures::mean_of(const Measure& measure, const SphereStep& step) const {
    std::array<ExactSum, 3> sum;
    std::int64_t count = 0;
    for (std::size_t i = 0; i < step.rows().owned(); ++i) {
        if (space_.parts[step.group().tags()[i].part].name != *measure.part) continue;
        const SphereMotion& sphere = step.rows().motion()[i];
        const Row& value = *measure.kind == MeasureKind::spin ? sphere.spin : sphere.velocity;
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
