// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// How evenly the shape of a valve is divided among eight ranks, and how many copies that costs.
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "solver/domain/domain.hpp"
#include "solver/domain/halo.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::balance_tests {
namespace {

constexpr double spacing = 1.0 / 1024;  // [m]; all other lengths are in spacings
constexpr double bend = 116, length = bend * std::numbers::pi / 2, radius = 11.6, bulge = 4;
constexpr double reach = 2.6;
constexpr int outermost = 140, uppermost = 20;

/// Along the tube's centre line, a quarter of a circle, and across it.
struct TubePlace {
    double along = 0, sideways = 0, upwards = 0;
};

/// Nothing outside of the tube, which is wider in the middle.
std::optional<TubePlace> tube_place(const Vec& point) {
    if (point[0] < 0 || point[1] < 0) return std::nullopt;
    const TubePlace position{bend * std::atan2(point[0], point[1]), std::hypot(point[0], point[1]) - bend, point[2]};
    const double wall = radius + bulge * std::exp(-std::pow((position.along - length / 2) / 10, 2));
    if (std::hypot(position.sideways, position.upwards) > wall) return std::nullopt;
    return position;
}

/// Two sheets in the bulge, which nearly meet downstream.
bool is_leaflet(const TubePlace& position) {
    const double downstream = position.along - (length / 2 - 10);
    return downstream > 0 && downstream < 20 && std::abs(std::abs(position.sideways) - (12 - downstream / 2)) < 1;
}

struct Tube {
    ParticleGroup fluid{PartKind::fluid, 3}, leaflets{PartKind::elastic, 3};
    int count = 0;  ///< on all ranks

    /// A cubic lattice, dealt out to the ranks.
    explicit Tube(const Ranks& ranks) {
        for (ParticleGroup* group : {&fluid, &leaflets}) group->declare({Field::position});
        for (int x = 0; x < outermost; ++x)
            for (int y = 0; y < outermost; ++y)
                for (int z = -uppermost; z < uppermost; ++z) {
                    const Vec point(x + 0.5, y + 0.5, z + 0.5);
                    const std::optional<TubePlace> position = tube_place(point);
                    if (!position || count++ % ranks.size() != ranks.rank()) continue;
                    ParticleGroup& group = is_leaflet(*position) ? leaflets : fluid;
                    const std::size_t i = group.owned();
                    group.resize(i + 1, 0);
                    for (int axis = 0; axis < 3; ++axis) group.data(Field::position, axis)[i] = point[axis] * spacing;
                }
    }
};

TEST(Balance, BentTubeWithABulgeAndLeaflets) {
    const Ranks ranks = Ranks::world();
    ASSERT_EQ(ranks.size(), 8);
    ParticleSpace space;
    space.dimension = 3;
    Domain domain(ranks, space);
    Tube tube(ranks);
    const GroupList groups{&tube.fluid, &tube.leaflets};
    const KindWeights weights{.fluid = 1, .rigid = 1, .springs = 4};
    domain.divide(groups, weights);
    domain.migrate(groups);
    std::int64_t ghosts = 0;
    for (ParticleGroup* group : groups) {
        Halo halo(ranks, space);
        halo.build(*group, domain, reach * spacing);
        ghosts += static_cast<std::int64_t>(halo.ghosts());
    }
    const double imbalance = domain.imbalance(groups, weights);
    const double ghosts_per_owned = static_cast<double>(ranks.sum(ghosts)) / tube.count;
    if (ranks.is_first())
        std::cout << tube.count << " particles, imbalance " << imbalance << ", copies per owned " << ghosts_per_owned
                  << "\n";
    EXPECT_LE(imbalance, 1.05);
    EXPECT_NEAR(ghosts_per_owned, 0.273, 0.0273);
}

}  // namespace
}  // namespace dmp::tests::balance_tests
