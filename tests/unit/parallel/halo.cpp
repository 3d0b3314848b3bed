// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/domain/halo.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/parallel/moving_particles.hpp"

namespace dmp::tests::halo_tests {
namespace {

const FieldList all_fields{Field::position, Field::velocity, Field::density, Field::pressure};

/// Id and number of periods along x, y, z.
using Copy = std::tuple<std::int64_t, int, int, int>;

/// Squared distance of a point from a rank's box, which is infinite along z in 2-D.
double squared_distance(const Box& box, const Vec& point) {
    return (box.low - point).cwiseMax(point - box.high).cwiseMax(0).squaredNorm();
}

/// Calls visit(id, periods, shift) for all images of all particles as far as `most` periods away.
template <class Visit>
void for_all_images(const MovingParticles& particles, const Visit& visit) {
    std::array<int, 3> most{};
    for (int axis = 0; axis < particles.space.dimension; ++axis) most[axis] = particles.space.periodic[axis] ? 4 : 0;
    for (std::int64_t id = 0; id < particles.count(); ++id)
        for (int x = -most[0]; x <= most[0]; ++x)
            for (int y = -most[1]; y <= most[1]; ++y)
                for (int z = -most[2]; z <= most[2]; ++z)
                    visit(id, std::array{x, y, z}, particles.space.box.extent().cwiseProduct(Vec(x, y, z)).eval());
}

struct Oracle {
    std::set<Copy> needed, allowed;  ///< allowed: as far as the reach and a rounding error
};

Oracle oracle(const MovingParticles& particles, const Domain& domain, int rank, double reach) {
    Oracle found;
    const Box& box = domain.box(rank);
    if ((box.low.array() > box.high.array()).any()) return found;  // an empty box needs nothing
    for_all_images(particles, [&](std::int64_t id, const std::array<int, 3>& periods, const Vec& shift) {
        const Vec home = particles.position(id);
        if (periods == std::array{0, 0, 0} && domain.owner(home) == rank) return;
        const double squared = squared_distance(box, home + shift);
        const Copy copy{id, periods[0], periods[1], periods[2]};
        if (squared <= reach * reach) found.needed.insert(copy);
        if (squared <= reach * reach * (1 + 1e-8)) found.allowed.insert(copy);
    });
    return found;
}

/// The periods that a copy was moved by.
Vec shift_of(const MovingParticles& particles, const ParticleGroup& group, std::size_t i) {
    Vec shift = Vec::Zero();
    for (int axis = 0; axis < group.dimension(); ++axis)
        shift[axis] = group.data(Field::position, axis)[i] - particles.position(group.tags()[i].id)[axis];
    return shift;
}

void expect_right_ghosts(const MovingParticles& particles, const ParticleGroup& group, const Domain& domain, int rank,
                         double reach) {
    std::set<Copy> found;
    for (std::size_t i = group.owned(); i < group.total(); ++i) {
        const Vec shift = shift_of(particles, group, i);
        ASSERT_TRUE(particles.holds(group, i, all_fields, shift));
        std::array<int, 3> periods{};
        for (int axis = 0; axis < group.dimension(); ++axis) {
            const double ratio = shift[axis] / particles.space.box.extent()[axis];
            periods[axis] = static_cast<int>(ratio);
            ASSERT_EQ(ratio, periods[axis]) << "not a whole number of periods";
        }
        ASSERT_TRUE(found.insert({group.tags()[i].id, periods[0], periods[1], periods[2]}).second)
            << "two copies of particle " << group.tags()[i].id;
    }
    const Oracle expected = oracle(particles, domain, rank, reach);
    EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.needed.begin(), expected.needed.end()))
        << found.size() << " copies, " << expected.needed.size() << " needed";
    EXPECT_TRUE(std::includes(expected.allowed.begin(), expected.allowed.end(), found.begin(), found.end()))
        << found.size() << " copies, " << expected.allowed.size() << " allowed";
}

/// A divided space and one group in it.
struct Divided {
    Divided(int dimension, const std::array<bool, 3>& periodic, std::int64_t count, unsigned seed)
        : particles(dimension, periodic, count, seed),
          domain(ranks, particles.space),
          group(particles.group(dealt(count, ranks.rank(), ranks.size()))),
          halo(ranks, particles.space) {
        domain.divide({&group}, {});
        bring();
    }
    /// Everyone to his owner, all fields written.
    void bring() {
        domain.migrate({&group});
        particles.write(group, all_fields);
    }

    Ranks ranks = Ranks::world();
    MovingParticles particles;
    Domain domain;
    ParticleGroup group;
    Halo halo;
};

void expect_right_ghosts_everywhere(int dimension, std::int64_t count, const std::vector<double>& reaches) {
    for (const auto& periodic : combinations(dimension)) {
        Divided it(dimension, periodic, count, 11);
        for (const double reach : reaches) {
            SCOPED_TRACE(name_of(dimension, periodic) + ", reach " + std::to_string(reach));
            it.halo.build(it.group, it.domain, reach);
            expect_right_ghosts(it.particles, it.group, it.domain, it.ranks.rank(), reach);
            EXPECT_EQ(it.halo.ghosts(), it.group.total() - it.group.owned());
            // Once more after everyone moved.
            it.particles.move(3000);
            it.particles.write(it.group, all_fields);
            it.bring();
            it.halo.build(it.group, it.domain, reach);
            expect_right_ghosts(it.particles, it.group, it.domain, it.ranks.rank(), reach);
        }
    }
}

// The periods are 1, 0.5 and 0.75; a reach of 0.0625 is a whole number of quanta.
TEST(Halo, HoldsWhatIsNeededIn2D) { expect_right_ghosts_everywhere(2, 300, {0.0625, 0.3, 0.7, 1.6}); }
TEST(Halo, HoldsWhatIsNeededIn3D) { expect_right_ghosts_everywhere(3, 150, {0.0625, 0.3, 0.8}); }

/// Pair by pair: whoever lies within the reach of an owned particle, whichever image, is there.
TEST(Halo, LeavesNoPairOut) {
    const double reach = 0.2;
    Divided it(2, {true, true, false}, 200, 12);
    it.halo.build(it.group, it.domain, reach);
    std::set<std::array<double, 2>> present;
    const double *x = it.group.data(Field::position, 0), *y = it.group.data(Field::position, 1);
    for (std::size_t i = 0; i < it.group.total(); ++i) present.insert({x[i], y[i]});
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < it.group.owned(); ++i)
        for_all_images(it.particles, [&](std::int64_t id, const std::array<int, 3>&, const Vec& shift) {
            const Vec other = it.particles.position(id) + shift;
            if (std::hypot(other[0] - x[i], other[1] - y[i]) > reach) return;
            ++pairs;
            EXPECT_TRUE(present.contains({other[0], other[1]}));
        });
    EXPECT_GT(it.ranks.sum(static_cast<std::int64_t>(pairs)), 200 * 10);
}

TEST(Halo, FindsWhatLiesExactlyAsFarAsTheReach) {
    // Points 0.1 apart; the reach a sum of roundings.
    const Ranks ranks = Ranks::world();
    ParticleSpace space;
    space.periodic = {true, false, false};
    space.box = {Vec(0, 0, 0), Vec(4, 1, 0)};
    Domain domain(ranks, space);
    ParticleGroup group(PartKind::fluid, 2);
    group.declare({Field::position});
    group.resize(ranks.is_first() ? 64 : 0, 0);
    for (std::size_t i = 0; i < group.owned(); ++i) {
        group.tags()[i].id = static_cast<std::int64_t>(i);
        group.data(Field::position, 0)[i] = static_cast<double>(i) / 16;
    }
    domain.divide({&group}, {});
    domain.migrate({&group});
    Halo halo(ranks, space);
    halo.build(group, domain, 3.0 / 16);
    if (ranks.size() > 1) return;
    EXPECT_EQ(halo.ghosts(), 3 + 4) << "4 - 3/16 and 4 + 3/16 lie as far as the reach";
}

TEST(Halo, ExchangesWhatItIsAskedFor) {
    for (const auto& periodic : combinations(2)) {
        SCOPED_TRACE(name_of(2, periodic));
        Divided it(2, periodic, 400, 13);
        it.halo.build(it.group, it.domain, 0.3);
        std::vector<Vec> shifts;
        for (std::size_t i = it.group.owned(); i < it.group.total(); ++i)
            shifts.push_back(shift_of(it.particles, it.group, i));
        const MovingParticles before = it.particles;
        const auto expect_ghosts = [&](const MovingParticles& now, const FieldList& fields) {
            for (std::size_t i = it.group.owned(); i < it.group.total(); ++i)
                ASSERT_TRUE(now.holds(it.group, i, fields, shifts[i - it.group.owned()]));
        };

        it.particles.change_values();
        it.particles.write(it.group, all_fields);
        expect_ghosts(before, all_fields);
        it.halo.exchange(it.group, {Field::density});
        expect_ghosts(it.particles, {Field::position, Field::density});
        expect_ghosts(before, {Field::velocity, Field::pressure});
        it.halo.exchange(it.group, {Field::pressure, Field::velocity});
        expect_ghosts(it.particles, all_fields);
        it.halo.exchange(it.group, {});
        expect_ghosts(it.particles, all_fields);
        for (std::size_t i = 0; i < it.group.owned(); ++i) ASSERT_TRUE(it.particles.holds(it.group, i, all_fields));
    }
}

TEST(Halo, KeepsCopiesAtTheSideTheyWereMadeFor) {
    Divided it(2, {true, true, false}, 400, 14);
    it.halo.build(it.group, it.domain, 0.3);
    std::vector<Vec> shifts;
    for (std::size_t i = it.group.owned(); i < it.group.total(); ++i)
        shifts.push_back(shift_of(it.particles, it.group, i));
    // Between two builds particles drift out of their boxes, and out of the period, without being moved back.
    for (int axis = 0; axis < 2; ++axis)
        for (std::size_t i = 0; i < it.group.owned(); ++i) it.group.data(Field::position, axis)[i] += 0.25;
    it.halo.exchange(it.group, {Field::position});
    for (std::size_t i = it.group.owned(); i < it.group.total(); ++i)
        for (int axis = 0; axis < 2; ++axis)
            EXPECT_EQ(it.group.data(Field::position, axis)[i],
                      it.particles.position(it.group.tags()[i].id)[axis] + 0.25 + shifts[i - it.group.owned()][axis]);
}

TEST(Halo, LetsWorkGoOnWhileSeveralAreUnderWay) {
    Divided a(2, {true, false, false}, 400, 15), b(2, {true, false, false}, 50, 16);
    a.halo.build(a.group, a.domain, 0.3);
    b.halo.build(b.group, b.domain, 0.1);
    a.particles.change_values();
    b.particles.change_values();
    a.particles.write(a.group, all_fields);
    b.particles.write(b.group, all_fields);
    a.halo.start(a.group, {Field::density, Field::velocity});
    b.halo.start(b.group, {Field::density, Field::velocity});
    for (std::size_t i = 0; i < a.group.owned(); ++i) a.group.data(Field::density)[i] = -1;  // too late to be sent
    b.halo.finish(b.group);
    a.halo.finish(a.group);
    for (Divided* it : {&a, &b})
        for (std::size_t i = it->group.owned(); i < it->group.total(); ++i)
            ASSERT_TRUE(it->particles.holds(it->group, i, {Field::density, Field::velocity}));
}

TEST(Halo, RefusesWhatItWasNotBuiltFor) {
    Divided it(2, {true, false, false}, 100, 17);
    it.halo.build(it.group, it.domain, 0.1);
    EXPECT_THROW(it.halo.exchange(it.group, {Field::mass}), std::logic_error);
    it.halo.start(it.group, {Field::density});
    EXPECT_THROW(it.halo.start(it.group, {Field::density}), std::logic_error);
    it.halo.finish(it.group);
    it.group.resize(it.group.owned() + 1, 0);
    EXPECT_THROW(it.halo.exchange(it.group, {Field::density}), std::logic_error);
}

TEST(Halo, HandlesFewParticles) {
    for (const std::int64_t count : {0, 1, 3, 12})
        for (const auto& periodic : combinations(2)) {
            SCOPED_TRACE(count);
            Divided it(2, periodic, count, 18);
            it.halo.build(it.group, it.domain, 0.4);
            expect_right_ghosts(it.particles, it.group, it.domain, it.ranks.rank(), 0.4);
            EXPECT_TRUE(count > 0 || it.halo.ghosts_per_owned() == 0);
        }
}

}  // namespace
}  // namespace dmp::tests::halo_tests
