// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Fluid at places at random that keep their distance.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include <gmock/gmock.h>

#include "meshed_text.hpp"
#include "mesher/sample_fluids.hpp"
#include "mesher/searchable_particles.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::sampled_fluids_tests {
namespace {

constexpr double spacing = 0.05;

/// A lattice that fills a periodic unit square or cube: the left half is water, the right one oil.
ParticleSet halves(int dimension) {
    ParticleSet set;
    set.dimension = dimension;
    set.spacing = spacing;
    set.box = {Vec::Zero(), Vec(1, 1, dimension == 3 ? 1 : 0)};
    set.periodic = {true, true, dimension == 3};
    set.parts = {{"water", PartKind::fluid}, {"oil", PartKind::fluid}};
    for (int z = 0; z < (dimension == 3 ? 20 : 1); ++z)
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 20; ++x) {
                set.position.emplace_back((x + 0.5) * spacing, (y + 0.5) * spacing,
                                          dimension == 3 ? (z + 0.5) * spacing : 0);
                set.part.push_back(x < 10 ? 0 : 1);
            }
    return set;
}

int half_at(const Vec& position) { return position.x() < 0.5 ? 0 : 1; }

double cell_volume(int dimension) { return std::pow(spacing, dimension); }

class SampledFluids : public testing::TestWithParam<int> {};

TEST_P(SampledFluids, keep_their_distance_and_their_parts) {
    const int dimension = GetParam();
    const ParticleSet lattice = halves(dimension);
    ParticleSet set = lattice;
    const std::string note = sample_fluids(set, cell_volume(dimension), 1, half_at, 2);
    EXPECT_THAT(note, testing::HasSubstr("particles are the least crowded of"));
    ASSERT_EQ(set.size(), lattice.size());
    EXPECT_EQ(set.part, lattice.part);
    for (std::size_t i = 0; i < set.size(); ++i) EXPECT_EQ(half_at(set.position[i]), set.part[i]);
    // Of places at random each has one other within 0.6 dx, about.
    const SearchableParticles search(set, 0.6 * spacing);
    std::size_t near = 0;
    for (std::size_t i = 0; i < set.size(); ++i) search.for_each_neighbour(i, [&](std::size_t, const Vec&) { ++near; });
    EXPECT_EQ(near, 0U);
    // Blocks of a quarter of the box across hold as many each as on the lattice, within what stands on their sides.
    const double in_block = std::pow(5, dimension), on_sides = dimension == 3 ? 25 : 5;
    for (const double low : {0.0, 0.25, 0.5, 0.75}) {
        const auto inside = [&](const Vec& position) {
            for (int axis = 0; axis < dimension; ++axis)
                if (position[axis] < low || position[axis] >= low + 0.25) return false;
            return true;
        };
        EXPECT_NEAR(static_cast<double>(std::ranges::count_if(set.position, inside)), in_block, on_sides);
    }
}

TEST_P(SampledFluids, have_no_direction_of_a_lattice) {
    const int dimension = GetParam();
    ParticleSet set = halves(dimension);
    // |<exp(2 pi i x / dx)>| is 1 on the lattice, and n^-1/2, about, where there is none.
    const auto order = [&](int axis) {
        std::complex<double> sum = 0;
        for (const Vec& position : set.position)
            sum += std::polar(1.0, 2 * std::numbers::pi * position[axis] / spacing);
        return std::abs(sum) / static_cast<double>(set.size());
    };
    for (int axis = 0; axis < dimension; ++axis) EXPECT_NEAR(order(axis), 1, 1e-9);
    sample_fluids(set, cell_volume(dimension), 1, half_at, 2);
    for (int axis = 0; axis < dimension; ++axis) EXPECT_LT(order(axis), 0.1);
}

TEST_P(SampledFluids, follow_from_the_seed_alone) {
    const int dimension = GetParam();
    const auto sampled = [&](std::uint64_t seed, int threads) {
        ParticleSet set = halves(dimension);
        sample_fluids(set, cell_volume(dimension), seed, half_at, threads);
        return set.position;
    };
    const auto first = sampled(1, 1);
    EXPECT_EQ(sampled(1, 3), first);
    EXPECT_NE(sampled(2, 1), first);
}

TEST_P(SampledFluids, keep_away_from_what_stays) {
    const int dimension = GetParam();
    ParticleSet set = halves(dimension);
    set.parts.push_back({"wall", PartKind::rigid});
    const std::vector<Vec> wall(set.position.begin(), set.position.begin() + 40);
    for (std::size_t i = 0; i < 40; ++i) set.part[i] = 2;
    const ParticleSet before = set;
    const auto beside_the_wall = [&](const Vec& position) {
        return position.y() < 2 * spacing && position.z() < spacing ? -1 : half_at(position);
    };
    sample_fluids(set, cell_volume(dimension), 1, beside_the_wall, 2);
    std::size_t near = 0;
    const SearchableParticles search(set, 0.6 * spacing);
    for (std::size_t i = 0; i < 40; ++i) {
        EXPECT_EQ(set.position[i], before.position[i]);
        search.for_each_neighbour(i, [&](std::size_t, const Vec&) { ++near; });
    }
    EXPECT_EQ(near, 0U);
}

TEST_P(SampledFluids, take_the_lattice_where_there_is_no_choice) {
    const int dimension = GetParam();
    ParticleSet set = halves(dimension);
    const auto nowhere = [](const Vec&) { return -1; };
    sample_fluids(set, cell_volume(dimension), 1, nowhere, 1);
    EXPECT_EQ(set.position, halves(dimension).position);
}

INSTANTIATE_TEST_SUITE_P(In, SampledFluids, testing::Values(2, 3),
                         [](const auto& dimension) { return std::to_string(dimension.param) + "d"; });

TEST(SampledMesh, leaves_leaflets_where_they_are) {
    const Meshed lattice = mesh_case("vein_valve", {"particles.spacing=0.2 mm"});
    const Meshed meshed = mesh_case("vein_valve", {"particles.spacing=0.2 mm", "particles.fill=sampled"});
    const ParticleSet& set = meshed.particles;
    EXPECT_EQ(set.count(PartKind::fluid), lattice.particles.count(PartKind::fluid));
    EXPECT_EQ(set.bonds.size(), lattice.particles.bonds.size());
    const CurveSet& leaflets = *meshed.geometry.curve_set("leaflets");
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == PartKind::elastic) {
            EXPECT_EQ(set.position[i], lattice.particles.position[i]);
        } else if (set.kind(i) == PartKind::fluid) {
            ASSERT_GT(leaflets.nearest(set.position[i]).distance, 0.8 * set.spacing) << "none went in between";
        }
}

TEST(SampledMesh, refuses_disorder) {
    EXPECT_EQ(
        fault_of(channel.with("spacing = \"0.125 m\"", "spacing = \"0.125 m\"\nfill = \"sampled\"\ndisorder = 0.1")),
        "scene.toml:7:12: particles.disorder displaces particles from a lattice, which particles.fill = "
        "\"sampled\" does not keep\n"
        "  leave out disorder or fill");
}

}  // namespace
}  // namespace dmp::tests::sampled_fluids_tests
