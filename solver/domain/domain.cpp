// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/domain/domain.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "base/errors.hpp"
#include "particles/periodic_images.hpp"
#include "solver/domain/bisection.hpp"
#include "solver/domain/migration.hpp"
#include "solver/parallel/select.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

/// A particle farther away than this has left the simulation; moving it back would lose digits.
constexpr double most_periods = 1e6;

Box everything(const ParticleSpace& space) {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        const bool periodic = axis < space.dimension && space.periodic[axis];
        const bool ends_low = periodic || (axis < space.dimension && space.mirrored[axis][0]);
        const bool ends_high = periodic || (axis < space.dimension && space.mirrored[axis][1]);
        box.low[axis] = ends_low ? space.box.low[axis] : -std::numeric_limits<double>::infinity();
        box.high[axis] = ends_high ? space.box.high[axis] : std::numeric_limits<double>::infinity();
    }
    return box;
}

std::array<double, 3> position_of(const ParticleGroup& group, std::size_t i) {
    std::array<double, 3> position{};
    for (int axis = 0; axis < group.dimension(); ++axis) position[axis] = group.data(Field::position, axis)[i];
    return position;
}

std::string lost(const ParticleGroup& group, std::size_t i) {
    std::ostringstream text;
    text << "particle " << group.tags()[i].id << " has left the simulation: its position is (";
    for (int axis = 0; axis < group.dimension(); ++axis)
        text << (axis > 0 ? ", " : "") << group.data(Field::position, axis)[i];
    text << ") m";
    return text.str();
}

}  // namespace

Domain::Domain(const Ranks& ranks, const ParticleSpace& space, int threads)
    : ranks_(ranks),
      dimension_(space.dimension),
      threads_(threads),
      periodic_(space.periodic),
      mirrored_(space.mirrored),
      space_(everything(space)),
      regions_(space_, ranks.size()) {}

void Domain::divide(const GroupList& groups, const KindWeights& weights) {
    if (ranks_.size() == 1) return;
    move_into_box(groups);
    WeightedPoints points{dimension_, {}, {}};
    for (const ParticleGroup* group : groups) {
        const auto weight = static_cast<float>(weights.of(group->kind()));
        points.weights.insert(points.weights.end(), group->owned(), weight);
        for (std::size_t i = 0; i < group->owned(); ++i)
            for (int axis = 0; axis < dimension_; ++axis)
                points.coordinates.push_back(group->data(Field::position, axis)[i]);
    }
    std::optional<Regions> divided;
    if (ranks_.sum(static_cast<std::int64_t>(points.weights.size())) > 0)
        divided = Regions::along(space_, bisect(ranks_, points));
    if (divided) divided->divide_ties(ranks_, points);
    regions_ = divided.value_or(Regions(space_, ranks_.size()));
}

int Domain::owner(const Vec& point) const {
    std::array<double, 3> position{};
    for (int axis = 0; axis < dimension_; ++axis)
        position[axis] = periodic_[axis] ? wrapped(point[axis], space_.low[axis], space_.high[axis]) : point[axis];
    return regions_.owner(position);
}

/// Swaps a particle with its mirror image. The fluid stays the same, as each is the other's image.
void Domain::mirror_back(ParticleGroup& fluid) const {
    for (int axis = 0; axis < dimension_; ++axis)
        for (const bool high : {false, true}) {
            if (!mirrored_[axis][high ? 1 : 0]) continue;
            const double plane = high ? space_.high[axis] : space_.low[axis];
            std::array<bool, 3> across{};
            across[axis] = true;
            double* x = fluid.data(Field::position, axis);
            const auto beyond =
                select(fluid.owned(), threads_, [=](std::size_t i) { return high ? x[i] > plane : x[i] < plane; });
            for (const std::int32_t i : beyond) {
                x[i] = 2 * plane - x[i];
                for (const Field field : fluid.state())
                    for (int array = 0; array < fluid.axes(field); ++array)
                        if (field != Field::position && changes_sign(field, array, dimension_, across))
                            fluid.data(field, array)[i] = -fluid.data(field, array)[i];
            }
        }
}

void Domain::move_into_box(const GroupList& groups) const {
    std::string trouble;
    for (ParticleGroup* group : groups)
        if (group->kind() == PartKind::fluid) mirror_back(*group);
    for (ParticleGroup* group : groups)
        for (int axis = 0; axis < dimension_; ++axis) {
            double* x = group->data(Field::position, axis);
            const double low = space_.low[axis], high = space_.high[axis];
            const bool periodic = periodic_[axis];
            const double farthest =
                periodic ? most_periods * (high - low) : std::numeric_limits<double>::max();  // infinity is too far
            // Most particles are inside, which a single comparison shows.
            const auto outside = select(group->owned(), threads_, [=](std::size_t i) {
                return periodic ? !(x[i] >= low && x[i] < high) : !(std::abs(x[i]) <= farthest);
            });
            for (const std::int32_t i : outside)
                if (!periodic || !(std::abs(x[i] - low) <= farthest))
                    trouble = trouble.empty() ? lost(*group, i) : trouble;
                else
                    x[i] = wrapped(x[i], low, high);
        }
    const double teller = ranks_.smallest(trouble.empty() ? ranks_.size() : ranks_.rank());
    if (teller == ranks_.size()) return;
    if (teller != ranks_.rank()) trouble.clear();
    const std::vector<char> told = ranks_.all_gather(std::vector<char>(trouble.begin(), trouble.end()));
    throw DivergenceError(std::string(told.begin(), told.end()), "Use a smaller time step or a higher sound speed.");
}

void Domain::migrate(const GroupList& groups) const {
    move_into_box(groups);
    if (ranks_.size() == 1) {
        for (ParticleGroup* group : groups) group->resize(group->owned(), 0);
        return;
    }
    std::vector<Departures> departures;
    const Box& own = box(ranks_.rank());
    for (const ParticleGroup* group : groups) {
        std::array<const double*, 3> x{};
        for (int axis = 0; axis < dimension_; ++axis) x[axis] = group->data(Field::position, axis);
        Departures leaving;
        // Only owner() decides about points on a side of the box; hardly any particle is there.
        const std::vector<std::int32_t> outside =
            select(group->owned(), threads_, [&, dimension = dimension_](std::size_t i) {
                int inside = 1;
                for (int axis = 0; axis < dimension; ++axis)
                    inside &=
                        static_cast<int>(x[axis][i] > own.low[axis]) & static_cast<int>(x[axis][i] < own.high[axis]);
                return inside == 0;
            });
        for (const std::int32_t i : outside)
            if (const int rank = regions_.owner(position_of(*group, i)); rank != ranks_.rank()) {
                leaving.particles.push_back(i);
                leaving.to.push_back(rank);
            }
        departures.push_back(std::move(leaving));
    }
    send_particles(ranks_, groups, departures);
}

double Domain::imbalance(const GroupList& groups, const KindWeights& weights) const {
    double load = 0;
    for (const ParticleGroup* group : groups) load += weights.of(group->kind()) * static_cast<double>(group->owned());
    ExactSum total;
    total.add(load);
    ranks_.sum(total);
    return total.value() > 0 ? ranks_.largest(load) * ranks_.size() / total.value() : 1;
}

}  // namespace dmp::solver
