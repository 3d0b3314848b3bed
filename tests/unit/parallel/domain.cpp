// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/domain/domain.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "tests/modules.hpp"
#include "tests/unit/parallel/moving_particles.hpp"

namespace dmp::tests::domain_tests {
namespace {

const FieldList state{Field::position, Field::velocity, Field::density};

std::vector<std::int64_t> owned_ids(const ParticleGroup& group) {
    std::vector<std::int64_t> ids;
    for (std::size_t i = 0; i < group.owned(); ++i) ids.push_back(group.tags()[i].id);
    return ids;
}

/// Every particle is owned once, where its place is, and holds what it is to hold.
void expect_all_in_place(const MovingParticles& particles, const ParticleGroup& group, const Ranks& ranks,
                         const Domain& domain) {
    EXPECT_EQ(group.total(), group.owned());
    for (std::size_t i = 0; i < group.owned(); ++i) {
        ASSERT_TRUE(particles.holds(group, i, state));
        EXPECT_EQ(domain.owner(particles.position(group.tags()[i].id)), ranks.rank());
    }
    std::vector<std::int64_t> ids = ranks.all_gather(owned_ids(group));
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(ids, dealt(particles.count(), 0, 1)) << "lost or doubled";
}

/// The ids that were here and are still here, in their order.
void expect_order_kept(const std::vector<std::int64_t>& before, const std::vector<std::int64_t>& after) {
    std::map<std::int64_t, std::size_t> rank_before;
    for (std::size_t k = 0; k < before.size(); ++k) rank_before[before[k]] = k;
    std::size_t least = 0;
    bool newcomers = false;
    for (const std::int64_t id : after) {
        const auto found = rank_before.find(id);
        if (found == rank_before.end()) {
            newcomers = true;
            continue;
        }
        EXPECT_FALSE(newcomers) << "a newcomer stands before one that stayed";
        EXPECT_GE(found->second, least);
        least = found->second;
    }
}

TEST(Domain, BringsEveryParticleToItsOwner) {
    const Ranks ranks = Ranks::world();
    for (const int dimension : {2, 3})
        for (const auto& periodic : combinations(dimension)) {
            SCOPED_TRACE(name_of(dimension, periodic));
            MovingParticles particles(dimension, periodic, 800, 1);
            Domain domain(ranks, particles.space);
            ParticleGroup group = particles.group(dealt(particles.count(), ranks.rank(), ranks.size()));
            domain.divide({&group}, {});
            for (const std::int64_t most : {0, 500, 20000, 300000}) {  // up to nine periods
                particles.move(most);
                particles.write(group, state);
                for (std::size_t i = 0; i < group.owned(); ++i)
                    for (int axis = 0; axis < dimension; ++axis)
                        if (periodic[axis]) {
                            const auto periods = static_cast<double>(group.tags()[i].id % 7 - 3);
                            group.data(Field::position, axis)[i] += periods * particles.space.box.extent()[axis];
                        }
                const std::vector<std::int64_t> ids = owned_ids(group);
                domain.migrate({&group});
                expect_all_in_place(particles, group, ranks, domain);
                expect_order_kept(ids, owned_ids(group));
            }
            domain.divide({&group}, {});
            domain.migrate({&group});
            expect_all_in_place(particles, group, ranks, domain);
            EXPECT_LE(domain.imbalance({&group}, {}), 1.05);
        }
}

TEST(Domain, HandlesSeveralGroupsTogether) {
    const Ranks ranks = Ranks::world();
    MovingParticles fluid(2, {true, false, false}, 3000, 2), springs(2, {true, false, false}, 300, 3),
        rigid(2, {true, false, false}, 0, 4);
    Domain domain(ranks, fluid.space);
    // All fluid on the last rank at first, all springs on the first.
    ParticleGroup a = fluid.group(ranks.rank() == ranks.size() - 1 ? dealt(3000, 0, 1) : std::vector<std::int64_t>{});
    ParticleGroup b =
        springs.group(ranks.is_first() ? dealt(300, 0, 1) : std::vector<std::int64_t>{}, PartKind::elastic);
    ParticleGroup c = rigid.group({}, PartKind::rigid);
    const GroupList groups{&a, &b, &c};
    const KindWeights weights{.fluid = 1, .rigid = 2, .springs = 5};
    EXPECT_NEAR(domain.imbalance(groups, weights), ranks.size() == 1 ? 1 : ranks.size() * 3000 / 4500.0, 1e-12);
    domain.divide(groups, weights);
    domain.migrate(groups);
    expect_all_in_place(fluid, a, ranks, domain);
    expect_all_in_place(springs, b, ranks, domain);
    expect_all_in_place(rigid, c, ranks, domain);
    EXPECT_LE(domain.imbalance(groups, weights), 1.02);
}

TEST(Domain, CopiesGo) {
    const Ranks ranks = Ranks::world();
    MovingParticles particles(2, {true, true, false}, 100, 5);
    Domain domain(ranks, particles.space);
    ParticleGroup group = particles.group(dealt(100, ranks.rank(), ranks.size()));
    group.resize(group.owned(), 7);
    domain.migrate({&group});
    expect_all_in_place(particles, group, ranks, domain);
    EXPECT_EQ(group.owned(), ranks.is_first() ? 100 : 0) << "undivided space is the first rank's";
}

TEST(Domain, HasOneOwnerForEveryPoint) {
    const Ranks ranks = Ranks::world();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const auto& periodic : combinations(2)) {
        SCOPED_TRACE(name_of(2, periodic));
        const MovingParticles particles(2, periodic, 1000, 6);
        Domain domain(ranks, particles.space);
        ParticleGroup group = particles.group(dealt(1000, ranks.rank(), ranks.size()));
        domain.divide({&group}, {});

        std::vector<double> x{particles.space.box.low[0]}, y{particles.space.box.low[1]};  // also on every cut
        for (int rank = 0; rank < ranks.size(); ++rank)
            for (const double bound : {domain.box(rank).low[0], domain.box(rank).high[0]})
                if (std::abs(bound) < infinity && (!periodic[0] || bound < particles.space.box.high[0]))
                    x.push_back(bound);
        for (int rank = 0; rank < ranks.size(); ++rank)
            for (const double bound : {domain.box(rank).low[1], domain.box(rank).high[1]})
                if (std::abs(bound) < infinity && (!periodic[1] || bound < particles.space.box.high[1]))
                    y.push_back(bound);
        for (std::int64_t id = 0; id < 30; ++id) {
            x.push_back(particles.position(id)[0]);
            y.push_back(particles.position(id)[1]);
        }
        if (!periodic[0]) x.insert(x.end(), {-1e9, 1e9});
        if (!periodic[1]) y.insert(y.end(), {-1e9, 1e9});

        std::vector<int> owners;
        for (const double px : x)
            for (const double py : y) {
                // One box holds it, or it lies on sides that boxes share.
                const int owner = owners.emplace_back(domain.owner(Vec(px, py, 0)));
                for (int rank = 0; rank < ranks.size(); ++rank) {
                    const Box& box = domain.box(rank);
                    const bool inside = px > box.low[0] && px < box.high[0] && py > box.low[1] && py < box.high[1];
                    const bool outside = px < box.low[0] || px > box.high[0] || py < box.low[1] || py > box.high[1];
                    ASSERT_TRUE(rank == owner ? !outside : !inside) << px << " " << py;
                }
                const Vec far(px + (periodic[0] ? 3 : 0), py - (periodic[1] ? 1 : 0), 0);  // 3 and 2 periods
                ASSERT_EQ(domain.owner(far), owners.back());
            }
        std::vector<int> first = owners;
        ranks.broadcast(first);
        EXPECT_EQ(owners, first) << "ranks disagree";
    }
}

TEST(Domain, OwnsTiedParticlesByPositionAlone) {
    const Ranks ranks = Ranks::world();
    ParticleSpace space;
    space.box = {Vec(0, 0, 0), Vec(31, 17, 0)};
    Domain domain(ranks, space);
    ParticleGroup group(PartKind::fluid, 2);
    group.declare({Field::position});
    std::size_t count = 0;
    for (int k = 0; k < 31 * 17 * 3; ++k) {  // each point three times
        if (k % ranks.size() != ranks.rank()) continue;
        group.resize(++count, 0);
        group.tags()[count - 1].id = k;
        const int point = k / 3, row = point / 31;
        group.data(Field::position, 0)[count - 1] = point % 31;
        group.data(Field::position, 1)[count - 1] = row;
    }
    domain.divide({&group}, {});
    domain.migrate({&group});
    for (std::size_t i = 0; i < group.owned(); ++i)
        EXPECT_EQ(domain.owner(Vec(group.data(Field::position, 0)[i], group.data(Field::position, 1)[i], 0)),
                  ranks.rank());
    EXPECT_EQ(ranks.sum(static_cast<std::int64_t>(group.owned())), 31 * 17 * 3);
    EXPECT_LE(domain.imbalance({&group}, {}), 1.05);
}

TEST(Domain, HandlesFewParticles) {
    const Ranks ranks = Ranks::world();
    for (const std::int64_t count : {0, 1, 2, 3, 5, 9, 20}) {
        SCOPED_TRACE(count);
        MovingParticles particles(2, {true, false, false}, count, 7);
        Domain domain(ranks, particles.space);
        ParticleGroup group = particles.group(dealt(count, ranks.rank(), ranks.size()));
        for (int round = 0; round < 3; ++round) {
            domain.divide({&group}, {});
            domain.migrate({&group});
            expect_all_in_place(particles, group, ranks, domain);
            particles.move(30000);
            particles.write(group, state);
        }
    }
}

TEST(Domain, TellsAllRanksOfAParticleWithoutAPlace) {
    const Ranks ranks = Ranks::world();
    const int last = ranks.size() - 1;
    for (const double position :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300})
        for (const int axis : {0, 1}) {
            if (axis == 1 && position == 1e300) continue;  // far off, but the axis has no period to lose digits to
            MovingParticles particles(2, {true, false, false}, 100, 8);
            const Domain domain(ranks, particles.space);
            ParticleGroup group = particles.group(dealt(100, ranks.rank(), ranks.size()));
            if (ranks.rank() == last) group.data(Field::position, axis)[3] = position;
            try {
                domain.migrate({&group});
                ADD_FAILURE() << "no error for " << position;
            } catch (const DivergenceError& error) {
                const std::string id = std::to_string(3 * ranks.size() + last);
                EXPECT_THAT(error.problem(), testing::StartsWith("particle " + id + " has left the simulation"));
            }
        }
}

}  // namespace
}  // namespace dmp::tests::domain_tests
