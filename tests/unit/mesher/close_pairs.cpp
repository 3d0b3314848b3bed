// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/close_pairs.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::close_pairs_tests {
namespace {

/// Particles anywhere in a box of 2 x 1 x 1.
ParticleSet scattered(int dimension, std::size_t count) {
    ParticleSet set;
    set.dimension = dimension;
    set.box = {.low = Vec(0, 0, 0), .high = Vec(2, 1, dimension == 3 ? 1 : 0)};
    std::mt19937 random(5);
    std::uniform_real_distribution<double> position(0, 1);
    for (std::size_t i = 0; i < count; ++i) {
        Vec& at = set.position.emplace_back(2 * position(random), position(random), position(random));
        if (dimension == 2) at.z() = 0;
    }
    return set;
}

/// Squares of the distances from particle i to all that is near, images too, ascending.
std::vector<double> squares_by_hand(const ParticleSet& set, std::size_t i, double reach) {
    std::vector<double> squares;
    const auto images = [&](int axis) {
        std::vector<std::pair<double, double>> all{{1, 0}};  // sign, offset
        if (axis >= set.dimension) return all;
        const double low = set.box.low[axis], high = set.box.high[axis];
        if (set.periodic[axis]) all.insert(all.end(), {{1, high - low}, {1, low - high}});
        if (set.mirrored[axis][0]) all.emplace_back(-1, 2 * low);
        if (set.mirrored[axis][1]) all.emplace_back(-1, 2 * high);
        return all;
    };
    for (std::size_t j = 0; j < set.size(); ++j)
        for (const auto& [sx, ox] : images(0))
            for (const auto& [sy, oy] : images(1))
                for (const auto& [sz, oz] : images(2)) {
                    const Vec& p = set.position[j];
                    const Vec apart = set.position[i] - Vec(sx * p.x() + ox, sy * p.y() + oy, sz * p.z() + oz);
                    const bool itself = j == i && sx * sy * sz > 0 && ox == 0 && oy == 0 && oz == 0;
                    if (!itself && apart.squaredNorm() < reach * reach) squares.push_back(apart.squaredNorm());
                }
    std::ranges::sort(squares);
    return squares;
}

template <int D>
void expect_what_is_near(const ParticleSet& set, const ClosePairs& pairs, double reach) {
    for (std::size_t i = 0; i < set.size(); ++i) {
        std::vector<double> squares;
        pairs.for_each_near<D>(i, [&](std::size_t, const auto&, double square) {
            if (square < reach * reach) squares.push_back(square);
        });
        std::ranges::sort(squares);
        const auto wanted = squares_by_hand(set, i, reach);
        ASSERT_EQ(squares.size(), wanted.size()) << i;
        for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_NEAR(squares[k], wanted[k], 1e-14);
    }
}

TEST(ClosePairs, are_all_that_is_near_images_too) {
    ParticleSet set = scattered(3, 400);
    set.periodic = {true, false, true};
    set.mirrored[1] = {true, false};
    ClosePairs pairs;
    for (const int threads : {1, 3}) {
        pairs.find(set, std::vector<std::uint8_t>(set.size(), 0), 0.2, threads);
        expect_what_is_near<3>(set, pairs, 0.2);
    }
}

TEST(ClosePairs, of_the_plane) {
    ParticleSet set = scattered(2, 300);
    set.periodic = {true, false, false};
    set.mirrored[1] = {true, true};
    ClosePairs pairs;
    pairs.find(set, std::vector<std::uint8_t>(set.size(), 0), 0.15, 1);
    expect_what_is_near<2>(set, pairs, 0.15);
}

TEST(ClosePairs, go_with_the_particles) {
    ParticleSet set = scattered(3, 400);
    set.periodic = {true, true, true};
    ClosePairs pairs;
    pairs.find(set, std::vector<std::uint8_t>(set.size(), 0), 0.25, 1);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> move(-0.01, 0.01);
    for (Vec& position : set.position) position += Vec(move(random), move(random), move(random));
    pairs.follow(set);
    expect_what_is_near<3>(set, pairs, 0.2);  // what came nearer than this was listed
}

TEST(ClosePairs, leaves_out_what_it_is_told_to) {
    const ParticleSet set = scattered(3, 100);
    std::vector<std::uint8_t> left_out(set.size(), 0);
    left_out[7] = 1;
    ClosePairs pairs;
    pairs.find(set, left_out, 0.5, 1);
    int of_7 = 0, near_7 = 0;
    pairs.for_each_near<3>(7, [&](std::size_t, const auto&, double) { ++of_7; });
    for (std::size_t i = 0; i < set.size(); ++i)
        pairs.for_each_near<3>(i, [&](std::size_t j, const auto&, double) { near_7 += j == 7 ? 1 : 0; });
    EXPECT_EQ(of_7, 0);
    EXPECT_GT(near_7, 0);
    EXPECT_GT(pairs.bytes(), 4U * static_cast<std::size_t>(near_7));
}

}  // namespace
}  // namespace dmp::tests::close_pairs_tests
