// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/chains.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::chains_tests {
namespace {

Vec p(double x, double y) { return {x, y, 0}; }

double shoelace(const Polyline& loop) {
    double twice = 0;
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
        const Vec& a = loop.points[i];
        const Vec& b = loop.points[(i + 1) % loop.points.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2;
}

std::vector<CurvePiece> square(double left, double low, double edge) {
    const Vec a = p(left, low);
    const Vec b = p(left + edge, low);
    const Vec c = p(left + edge, low + edge);
    const Vec d = p(left, low + edge);
    return {{a, b}, {c, b}, {c, d}, {a, d}};  // directions mixed
}

std::vector<CurvePiece> operator+(std::vector<CurvePiece> a, const std::vector<CurvePiece>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

TEST(MaximalChains, JoinsPiecesInAnyOrderAndDirectionAlongTheFirst) {
    const auto chains = maximal_chains({{p(1, 0), p(1.5, 1), p(2, 0)}, {p(3, 0), p(2, 0)}, {p(1, 0), p(0, 0)}});
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_FALSE(chains[0].closed);
    EXPECT_EQ(chains[0].points, (std::vector<Vec>{p(0, 0), p(1, 0), p(1.5, 1), p(2, 0), p(3, 0)}));
}

TEST(MaximalChains, KeepsWhatDoesNotTouchApart) {
    const auto chains = maximal_chains({{p(0, 0), p(1, 0)}, {p(1, 1e-12), p(2, 0)}});
    ASSERT_EQ(chains.size(), 2U);
    EXPECT_EQ(chains[0].points, (std::vector<Vec>{p(0, 0), p(1, 0)}));
    EXPECT_EQ(chains[1].points, (std::vector<Vec>{p(1, 1e-12), p(2, 0)}));
}

TEST(MaximalChains, ClosesARing) {
    const auto chains = maximal_chains(square(0, 0, 1));
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_TRUE(chains[0].closed);
    EXPECT_EQ(chains[0].points, (std::vector<Vec>{p(0, 0), p(1, 0), p(1, 1), p(0, 1)}));
    const auto one_piece = maximal_chains({{p(0, 0), p(1, 0), p(0, 1), p(0, 0)}});
    ASSERT_EQ(one_piece.size(), 1U);
    EXPECT_TRUE(one_piece[0].closed);
    EXPECT_EQ(one_piece[0].points.size(), 3U);
}

TEST(MaximalChains, StopsAtAJunctionOfThree) {
    const auto chains =
        maximal_chains({{p(0, 0), p(1, 0)}, {p(1, 0), p(2, 0)}, {p(2, 0), p(3, 0)}, {p(1, 0), p(1, 1)}});
    ASSERT_EQ(chains.size(), 3U);
    EXPECT_EQ(chains[0].points, (std::vector<Vec>{p(0, 0), p(1, 0)}));
    EXPECT_EQ(chains[1].points, (std::vector<Vec>{p(1, 0), p(2, 0), p(3, 0)}));
    EXPECT_EQ(chains[2].points, (std::vector<Vec>{p(1, 0), p(1, 1)}));
}

TEST(MaximalChains, TakesMinusZeroForZero) {
    EXPECT_EQ(maximal_chains({{p(1, 1), p(0.0, 0)}, {p(-0.0, 0), p(2, 2)}}).size(), 1U);
}

TEST(ClosedLoops, TurnsOuterLoopsLeftAndHolesRight) {
    const auto search = closed_loops(square(1, 1, 1) + square(0, 0, 5) + square(1.25, 1.25, 0.5));
    EXPECT_FALSE(search.loose_end);
    ASSERT_EQ(search.loops.size(), 3U);
    EXPECT_DOUBLE_EQ(shoelace(search.loops[0]), -1);    // a hole
    EXPECT_DOUBLE_EQ(shoelace(search.loops[1]), 25);    // around all
    EXPECT_DOUBLE_EQ(shoelace(search.loops[2]), 0.25);  // an island in the hole
    for (const auto& loop : search.loops) EXPECT_TRUE(loop.closed && loop.points.size() == 4);
}

TEST(ClosedLoops, TheEdgeBetweenTwoFacesCancels) {
    const auto search = closed_loops(square(0, 0, 1) + square(1, 0, 1));
    EXPECT_FALSE(search.loose_end);
    ASSERT_EQ(search.loops.size(), 1U);
    EXPECT_DOUBLE_EQ(shoelace(search.loops[0]), 2);
    EXPECT_EQ(search.loops[0].points.size(), 6U);
}

TEST(ClosedLoops, ThreeTimesCountsAsOnce) {
    const auto search = closed_loops(square(0, 0, 1) + square(0, 0, 1) + square(0, 0, 1));
    EXPECT_FALSE(search.loose_end);
    ASSERT_EQ(search.loops.size(), 1U);
    EXPECT_DOUBLE_EQ(shoelace(search.loops[0]), 1);
}

TEST(ClosedLoops, FacesThatShareACornerStaySimpleLoops) {
    const auto search = closed_loops(square(0, 0, 1) + square(1, 1, 2));
    EXPECT_FALSE(search.loose_end);
    ASSERT_EQ(search.loops.size(), 2U);
    double sum = 0;
    for (const auto& loop : search.loops) {
        EXPECT_EQ(loop.points.size(), 4U);
        EXPECT_GT(shoelace(loop), 0);
        sum += shoelace(loop);
    }
    EXPECT_DOUBLE_EQ(sum, 5);
}

TEST(ClosedLoops, NamesALooseEnd) {
    auto pieces = square(0, 0, 1);
    pieces[2].back() = p(0, 1.0000001);
    const auto search = closed_loops(pieces);
    ASSERT_TRUE(search.loose_end);
    EXPECT_TRUE(*search.loose_end == p(0, 1) || *search.loose_end == p(0, 1.0000001));
}

TEST(SelfCrossing, FindsTheCrossingOfABowTie) {
    const Region tie{.name = "", .loops = {{.points = {p(0, 0), p(2, 2), p(2, 0), p(0, 2)}, .closed = true}}};
    const auto crossing = self_crossing(tie);
    ASSERT_TRUE(crossing);
    EXPECT_NEAR((*crossing - p(1, 1)).norm(), 0, 1e-15);
}

TEST(SelfCrossing, TouchingIsNotCrossing) {
    const auto search = closed_loops(square(0, 0, 1) + square(1, 1, 2) + square(3, 2, 0.5));
    EXPECT_FALSE(self_crossing({.name = "", .loops = search.loops}));
}

TEST(SelfCrossing, SeesLoopsThatOverlap) {
    const auto search = closed_loops(square(0, 0, 1) + square(0.5, 0.25, 1));
    EXPECT_TRUE(self_crossing({.name = "", .loops = search.loops}));
}

}  // namespace
}  // namespace dmp::tests::chains_tests
