// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// The curved pieces of surfaces that touch.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "solver/contact/drawn_surfaces.hpp"
#include "solver/contact/surface_piece.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_surface_pieces_tests {
namespace {

const SurfacePiece curve{2, {Vec(0, 0, 0), Vec(1, 0, 0), Vec(0.5, 0.2, 0)}};
const SurfacePiece triangle{
    3,
    {Vec(0, 0, 0), Vec(1, 0, 0.1), Vec(0.2, 0.9, 0), Vec(0.5, -0.1, 0.2), Vec(0.65, 0.5, 0.2), Vec(0.05, 0.45, 0.1)}};

TEST(SurfacePiece, finds_the_nearest_place_of_a_curve) {
    for (const Vec& point : {Vec(0.3, 0.4, 0), Vec(0.7, -0.1, 0), Vec(0.52, 0.08, 0), Vec(-1, 0.3, 0), Vec(2, 0, 0)}) {
        double least = 1e9;
        for (int k = 0; k <= 20000; ++k)
            least = std::min(least, (curve.at({1 - k / 20000.0, k / 20000.0, 0}) - point).norm());
        EXPECT_NEAR((curve.at(curve.nearest(point)) - point).norm(), least, 2e-8);
    }
    EXPECT_EQ(curve.nearest(Vec(-1, 0.3, 0))[1], 0);
    EXPECT_EQ(curve.nearest(Vec(2, 0, 0))[0], 0);
    EXPECT_NEAR(curve.normal(curve.middle())[1], -1, 1e-15);
}

TEST(SurfacePiece, finds_the_nearest_place_of_a_triangle_also_on_its_border) {
    constexpr int steps = 400;
    int inside = 0, on_border = 0;
    for (int n = 0; n < 200; ++n) {
        const Vec point(0.5 + 0.9 * std::sin(1.7 * n), 0.4 + 0.9 * std::cos(2.3 * n), 0.1 + 0.3 * std::sin(3.1 * n));
        double least = 1e9;
        for (int j = 0; j <= steps; ++j)
            for (int k = 0; j + k <= steps; ++k) {
                const double b = static_cast<double>(j) / steps, c = static_cast<double>(k) / steps;
                least = std::min(least, (triangle.at({1 - b - c, b, c}) - point).norm());
            }
        const PiecePlace place = triangle.nearest(point);
        const Vec off = point - triangle.at(place);
        EXPECT_LT(off.norm(), least + 1e-12) << n;
        EXPECT_GT(off.norm(), least - 2e-3) << n;
        EXPECT_NEAR(place[0] + place[1] + place[2], 1, 1e-14);
        if (*std::ranges::min_element(place) > 0) {
            ++inside;
            EXPECT_LT(off.cross(triangle.normal(place)).norm(), 1e-9) << n;
        } else {
            ++on_border;
        }
    }
    EXPECT_GT(inside, 10);
    EXPECT_GT(on_border, 20);
}

TEST(SurfacePiece, has_the_tangents_and_the_gradient_of_its_shape) {
    const PiecePlace place{0.5, 0.2, 0.3};
    constexpr double step = 1e-6;
    const auto [by_b, by_c] = triangle.tangents(place);
    EXPECT_LT((by_b - (triangle.at({0.5 - step, 0.2 + step, 0.3}) - triangle.at(place)) / step).norm(), 1e-5);
    EXPECT_LT((by_c - (triangle.at({0.5 - step, 0.2, 0.3 + step}) - triangle.at(place)) / step).norm(), 1e-5);
    const Vec gradient = triangle.gradient(place, {3, 7, -2});
    EXPECT_NEAR(gradient.dot(by_b), 4, 1e-12);
    EXPECT_NEAR(gradient.dot(by_c), -5, 1e-12);
    EXPECT_NEAR(gradient.dot(triangle.normal(place)), 0, 1e-12);
    EXPECT_NEAR(curve.gradient({0.3, 0.7, 0}, {1, 3, 0}).dot(curve.tangents({0.3, 0.7, 0})[0]), 2, 1e-12);
}

TEST(SurfacePiece, gives_a_moment_as_forces_without_a_sum) {
    for (const auto& [piece, moment] : {std::pair(triangle, Vec(1, -2, 0.5)), std::pair(curve, Vec(0, 0, 3))}) {
        const auto force = piece.couple(moment);
        Vec sum = Vec::Zero(), turning = Vec::Zero();
        for (std::size_t k = 0; k < piece.corners; ++k) {
            sum += force[k];
            turning += piece.control[k].cross(force[k]);
        }
        EXPECT_LT(sum.norm(), 1e-13);
        EXPECT_LT((turning - moment).norm(), 1e-13);
    }
}

/// A ball of radius 1 as triangles: an octahedron's faces, each divided into the square of `divisions`.
ParticleSpace ball(int divisions) {
    ParticleSpace space;
    space.dimension = 3;
    space.spacing = 1.0 / divisions;
    std::map<std::array<int, 3>, int> number;
    const auto point = [&](const std::array<int, 3>& at) {
        const auto [found, is_new] = number.try_emplace(at, static_cast<int>(space.contact_points.size()));
        if (is_new) space.contact_points.push_back(Vec(at[0], at[1], at[2]).normalized());
        return found->second;
    };
    for (const int x : {1, -1})
        for (const int y : {1, -1})
            for (const int z : {1, -1})
                for (int j = 0; j < divisions; ++j)
                    for (int k = 0; j + k < divisions; ++k) {
                        const auto at = [&](int b, int c) { return point({x * (divisions - b - c), y * b, z * c}); };
                        const auto add = [&](int a, int b, int c) {
                            if (x * y * z < 0) std::swap(b, c);
                            space.contact_pieces.push_back({0, a, b, c, 1});
                        };
                        add(at(j, k), at(j + 1, k), at(j, k + 1));
                        if (j + k + 1 < divisions) add(at(j + 1, k), at(j + 1, k + 1), at(j, k + 1));
                    }
    return space;
}

SurfacePiece piece_of(const ParticleSpace& space, const DrawnSurfaces& drawn, const DrawnSurfaces::Piece& from) {
    SurfacePiece piece;
    piece.corners = drawn.corners;
    for (std::size_t k = 0; k < piece.controls(); ++k) {
        piece.control[k] = Vec::Zero();
        for (const auto& [point, share] : drawn.controls[static_cast<std::size_t>(from.control[k])])
            piece.control[k] += share * space.contact_points[static_cast<std::size_t>(point)];
    }
    return piece;
}

TEST(DrawnSurfaces, of_a_ball_come_near_to_it_with_the_third_power_and_their_normals_with_the_second) {
    double place_before = 0, normal_before = 0;
    for (const int divisions : {6, 12}) {
        const ParticleSpace space = ball(divisions);
        const DrawnSurfaces drawn = draw_triangles(space);
        double off = 0, turned = 0;
        for (const DrawnSurfaces::Piece& from : drawn.pieces) {
            const SurfacePiece piece = piece_of(space, drawn, from);
            for (const PiecePlace& place :
                 {piece.middle(), PiecePlace{0.5, 0.5, 0}, PiecePlace{0, 0.5, 0.5}, PiecePlace{0.1, 0.8, 0.1}}) {
                off = std::max(off, std::abs(piece.at(place).norm() - 1));
                turned = std::max(turned, (piece.normal(place) - piece.at(place).normalized()).norm());
            }
        }
        if (place_before > 0) {
            EXPECT_LT(off, place_before / 10);
            EXPECT_LT(turned, normal_before / 5);
        }
        place_before = off;
        normal_before = turned;
        EXPECT_EQ(std::ranges::count(drawn.is_end, true), 0);
    }
    EXPECT_LT(place_before, 1.5e-4);
    EXPECT_LT(normal_before, 0.002);
}

TEST(DrawnSurfaces, of_a_block_stay_flat_and_end_at_its_edges) {
    ParticleSpace space;
    space.dimension = 3;
    for (int k = 0; k < 8; ++k) space.contact_points.emplace_back(k & 1, k >> 1 & 1, k >> 2 & 1);
    const int face[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& [a, b, c, d] : face) {
        space.contact_pieces.push_back({0, a, b, c, 1});
        space.contact_pieces.push_back({0, a, c, d, 1});
    }
    const DrawnSurfaces drawn = draw_triangles(space);
    EXPECT_EQ(std::ranges::count(drawn.is_end, true), 8 + 12);  // corners and edges, not the faces' diagonals
    EXPECT_EQ(std::ranges::count(drawn.is_sharp, true), 8 + 12);
    for (const DrawnSurfaces::Piece& from : drawn.pieces) {
        const SurfacePiece piece = piece_of(space, drawn, from);
        const Vec normal = piece.normal(piece.middle());
        EXPECT_NEAR(normal.cwiseAbs().maxCoeff(), 1, 1e-15);
        EXPECT_LT((piece.normal({0.7, 0.2, 0.1}) - normal).norm(), 1e-14);
        EXPECT_NEAR(piece.measure(piece.middle()), 0.5, 1e-14);
    }
}

}  // namespace
}  // namespace dmp::tests::solver_surface_pieces_tests
