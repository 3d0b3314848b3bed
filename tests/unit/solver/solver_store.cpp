// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "all_pairs.hpp"
#include "particles/periodic_images.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_store_tests {
namespace {

using testing::ElementsAre;

/// How many quanta x is; an integer where x is a multiple.
double quanta(double x, const PositionQuantum& quantum) { return x / quantum.size(); }

ParticleSpace space_of(int dimension, const Vec& low, const Vec& high) {
    ParticleSpace space;
    space.dimension = dimension;
    space.spacing = 1e-4;
    space.box = {low, high};
    space.periodic = {true, true, dimension == 3};
    return space;
}

class QuantumOf : public testing::TestWithParam<ParticleSpace> {
  protected:
    ParticleSpace space = GetParam();
    PositionQuantum quantum{space};
    ParticleSpace whole = with_whole_periods(space, quantum);

    /// Multiples of the quantum, in the box and up to three boxes around it.
    [[nodiscard]] std::vector<double> some_positions(int axis) const {
        std::mt19937 random(5);
        const double period = whole.box.extent()[axis];
        std::uniform_real_distribution<double> position(whole.box.low[axis] - 3 * period,
                                                        whole.box.high[axis] + 3 * period);
        std::vector<double> positions{whole.box.low[axis], whole.box.high[axis], 0};
        for (int k = 0; k < 1000; ++k) positions.push_back(quantum.round(position(random)));
        return positions;
    }
};

TEST_P(QuantumOf, is_a_power_of_two_a_few_parts_in_1e16_of_the_box) {
    const double farthest = std::max(space.box.low.cwiseAbs().maxCoeff(), space.box.high.cwiseAbs().maxCoeff());
    int exponent = 0;
    EXPECT_EQ(std::frexp(quantum.size(), &exponent), 0.5);
    EXPECT_LE(quantum.size(), std::ldexp(farthest, -46));
    EXPECT_GE(quantum.size(), std::ldexp(farthest, -49));
    EXPECT_EQ(quantum.magic(), 1.5 * std::ldexp(quantum.size(), 52));
}

TEST_P(QuantumOf, rounds_to_the_nearest_multiple_alike_on_both_sides_of_0) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> fraction(-8, 8);
    for (int k = 0; k < 1000; ++k) {
        const double x = fraction(random) * space.box.high.cwiseAbs().maxCoeff(), rounded = quantum.round(x);
        EXPECT_EQ(quanta(rounded, quantum), std::nearbyint(quanta(x, quantum)));
        EXPECT_EQ(quantum.round(rounded), rounded);
        EXPECT_EQ(quantum.round(-x), -rounded);
    }
}

TEST_P(QuantumOf, makes_periods_multiples_and_hardly_changes_them) {
    for (int axis = 0; axis < space.dimension; ++axis) {
        const double low = whole.box.low[axis], high = whole.box.high[axis];
        for (const double x : {low, high, high - low})
            EXPECT_EQ(quanta(x, quantum), std::nearbyint(quanta(x, quantum))) << "axis " << axis;
        EXPECT_NEAR(low, space.box.low[axis], 0.5 * quantum.size());
        EXPECT_NEAR(high, space.box.high[axis], 0.5 * quantum.size());
    }
    EXPECT_EQ(whole.dimension, space.dimension);
    EXPECT_EQ(whole.periodic, space.periodic);
}

TEST_P(QuantumOf, makes_moves_by_periods_exact_there_and_back) {
    for (int axis = 0; axis < space.dimension; ++axis) {
        const double low = whole.box.low[axis], high = whole.box.high[axis], period = high - low;
        for (const double x : some_positions(axis)) {
            for (const int periods : {1, -1, 3}) EXPECT_EQ((x + periods * period) - periods * period, x);
            const double inside = wrapped(x, low, high);
            EXPECT_GE(inside, low);
            EXPECT_LT(inside, high);
            EXPECT_EQ(quanta(x - inside, quantum), std::nearbyint((x - inside) / period) * quanta(period, quantum));
            EXPECT_EQ(wrapped(x + period, low, high), inside);
            EXPECT_EQ(wrapped(x - 2 * period, low, high), inside);
        }
    }
}

TEST_P(QuantumOf, makes_separations_exact) {
    for (int axis = 0; axis < space.dimension; ++axis) {
        const std::vector<double> positions = some_positions(axis);
        for (std::size_t k = 1; k < positions.size(); ++k) {
            const double a = positions[k - 1], b = positions[k];
            const std::int64_t expected = std::llround(quanta(a, quantum)) - std::llround(quanta(b, quantum));
            EXPECT_EQ(quanta(a - b, quantum), static_cast<double>(expected));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Boxes, QuantumOf,
                         testing::Values(space_of(2, {0, 0, 0}, {0.02, 0.0123, 0}),
                                         space_of(2, {-7.31, -2.3, 0}, {-2.17, -0.1, 0}),
                                         space_of(2, {-1e-3, -3e-3, 0}, {1.1e-3, 0, 0}),
                                         space_of(3, {-0.3, 5.1, 99.9}, {0.7, 5.2, 100})));

TEST(ParticleStore, sorts_particles_by_kind_on_multiples_of_the_quantum_with_the_mass_of_liquid) {
    const ParticleSet set = crowd(3, {true, false, false});
    const std::vector<double> density{1000, 1100, 1200};  // by part, which here is by kind
    const ParticleStore particles(set, density);
    EXPECT_EQ(particles.owned(), set.size());
    for (const PartKind kind : all_kinds) {
        const ParticleGroup& group = particles.of(kind);
        EXPECT_EQ(group.kind(), kind);
        EXPECT_EQ(group.owned(), set.count(kind));
        EXPECT_EQ(group.total(), group.owned());
        for (std::size_t i = 0; i < group.owned(); ++i) {
            const ParticleTag& tag = group.tags()[i];
            const auto id = static_cast<std::size_t>(tag.id);
            EXPECT_TRUE(i == 0 || group.tags()[i - 1].id < tag.id);
            EXPECT_EQ(set.kind(id), kind);
            EXPECT_EQ(tag.body, set.body[id]);
            EXPECT_EQ(tag.part, set.part[id]);
            EXPECT_EQ(group.data(Field::volume)[i], set.volume[id]);
            EXPECT_EQ(group.data(Field::mass)[i], density[tag.part] * set.volume[id]);
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_EQ(group.data(Field::position, axis)[i], particles.quantum().round(set.position[id][axis]));
                EXPECT_EQ(group.data(Field::velocity, axis)[i], 0);
            }
        }
    }
}

/// Seven fluid particles and three copies, every state its own number.
class Group : public testing::Test {
  protected:
    Group() {
        group.declare({Field::position, Field::force, Field::density});
        group.resize(7, 3);
        for (std::size_t i = 0; i < group.total(); ++i) {
            group.tags()[i] = {static_cast<std::int64_t>(10 * i), static_cast<std::int32_t>(i) - 1,
                               static_cast<std::uint16_t>(i % 2)};
            for (int axis = 0; axis < 3; ++axis) group.data(Field::position, axis)[i] = position_of(10 * i, axis);
            group.data(Field::density)[i] = density_of(10 * i);
        }
    }
    static double position_of(std::size_t id, int axis) { return 0.1 * static_cast<double>(id) + axis; }
    static double density_of(std::size_t id) { return 1000 + static_cast<double>(id); }

    void expect_states_of(std::vector<std::size_t> ids) {
        ASSERT_EQ(group.total(), ids.size());
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const auto k = static_cast<std::int32_t>(ids[i] / 10);
            EXPECT_EQ(group.tags()[i],
                      (ParticleTag{static_cast<std::int64_t>(ids[i]), k - 1, static_cast<std::uint16_t>(k % 2)}));
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_EQ(group.data(Field::position, axis)[i], position_of(ids[i], axis));
            EXPECT_EQ(group.data(Field::density)[i], density_of(ids[i]));
        }
    }

    ParticleGroup group{PartKind::fluid, 3};
};

TEST_F(Group, has_the_fields_that_were_declared_and_no_others) {
    EXPECT_THAT(group.declared(), ElementsAre(Field::position, Field::density, Field::force));
    EXPECT_THAT(group.state(), ElementsAre(Field::position, Field::density));
    EXPECT_TRUE(group.has(Field::force));
    EXPECT_FALSE(group.has(Field::velocity));
    EXPECT_EQ(group.axes(Field::position), 3);
    EXPECT_EQ(group.axes(Field::density), 1);
    EXPECT_EQ(ParticleGroup(PartKind::rigid, 2).axes(Field::position), 2);
    for (int axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < group.total(); ++i) EXPECT_EQ(group.data(Field::force, axis)[i], 0);
}

TEST_F(Group, declared_once_more_keeps_its_values_and_new_fields_are_0) {
    const std::size_t before = group.bytes();
    group.declare({Field::density, Field::viscosity});
    expect_states_of({0, 10, 20, 30, 40, 50, 60, 70, 80, 90});
    for (std::size_t i = 0; i < group.total(); ++i) EXPECT_EQ(group.data(Field::viscosity)[i], 0);
    EXPECT_GE(group.bytes(), before + 10 * sizeof(double));
}

TEST_F(Group, knows_whom_it_owns_and_has_room_to_load_whole_vectors_behind_the_end) {
    EXPECT_EQ(group.owned(), 7U);
    EXPECT_EQ(group.total(), 10U);
    EXPECT_FALSE(group.empty());
    double sum = 0;  // sanitizers see whether the room is there
    for (std::size_t lane = 0; lane < 8; ++lane) sum += group.data(Field::density)[group.total() - 1 + lane];
    EXPECT_EQ(sum, density_of(90));
}

TEST_F(Group, resized_keeps_those_that_were_there) {
    group.resize(8, 40);
    EXPECT_EQ(group.owned(), 8U);
    EXPECT_EQ(group.total(), 48U);
    group.resize(4, 1);
    EXPECT_EQ(group.owned(), 4U);
    expect_states_of({0, 10, 20, 30, 40});
}

TEST_F(Group, reordered_takes_states_and_tags_along_and_drops_copies) {
    const std::vector<std::int32_t> order{3, 0, 6, 1, 5, 2, 4};
    group.reorder(order);
    EXPECT_EQ(group.owned(), 7U);
    expect_states_of({30, 0, 60, 10, 50, 20, 40});
    group.reorder(order);
    expect_states_of({10, 30, 40, 0, 20, 60, 50});
}

TEST_F(Group, reordered_by_some_of_its_particles_loses_the_others) {
    group.reorder(std::vector<std::int32_t>{5, 2});
    EXPECT_EQ(group.owned(), 2U);
    expect_states_of({50, 20});
    group.reorder({});
    EXPECT_TRUE(group.empty());
    EXPECT_EQ(group.total(), 0U);
}

}  // namespace
}  // namespace dmp::tests::solver_store_tests
