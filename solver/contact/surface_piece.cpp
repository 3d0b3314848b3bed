// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/surface_piece.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace dmp::solver {

namespace {

constexpr int most_iterations = 12;
/// Newton's method doubles the digits: after a step as small as this there is nothing left to do.
constexpr double enough = 1e-8;
/// Away from the centre of curvature the distance has one minimum; near it Newton's step is cut short: its slope is at
/// least this, relative to that of a flat piece.
constexpr double least_slope = 0.3;

/// The share of b nearest to a point on the curve from a to b, by Newton's method from that of the chord.
double nearest_on_curve(const Vec& a, const Vec& middle, const Vec& b, const Vec& point) {
    const Vec chord = b - a;
    double t = std::clamp((point - a).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    const Vec curvature = 2 * (a - 2 * middle + b);
    for (int k = 0; k < most_iterations; ++k) {
        const Vec off = (1 - t) * (1 - t) * a + 2 * t * (1 - t) * middle + t * t * b - point;
        const Vec along = 2 * (1 - t) * (middle - a) + 2 * t * (b - middle);
        const double square = along.squaredNorm();
        const double slope = std::max(square + off.dot(curvature), least_slope * square);
        const double next = std::clamp(t - off.dot(along) / slope, 0.0, 1.0);
        const bool is_there = std::abs(next - t) <= enough;
        t = next;
        if (is_there) break;
    }
    return t;
}

constexpr std::array<QuadraturePoint, 4> on_curve{{
    {{1 - 0.069431844202973712, 0.069431844202973712, 0}, 0.17392742256872693},
    {{1 - 0.33000947820757187, 0.33000947820757187, 0}, 0.32607257743127307},
    {{1 - 0.66999052179242813, 0.66999052179242813, 0}, 0.32607257743127307},
    {{1 - 0.93056815579702629, 0.93056815579702629, 0}, 0.17392742256872693},
}};
constexpr std::array<QuadraturePoint, 3> on_triangle{{
    {{2.0 / 3, 1.0 / 6, 1.0 / 6}, 1.0 / 3},
    {{1.0 / 6, 2.0 / 3, 1.0 / 6}, 1.0 / 3},
    {{1.0 / 6, 1.0 / 6, 2.0 / 3}, 1.0 / 3},
}};

}  // namespace

std::span<const QuadraturePoint> quadrature(std::size_t corners) {
    return corners == 2 ? std::span<const QuadraturePoint>(on_curve) : std::span<const QuadraturePoint>(on_triangle);
}

std::array<Vec, 2> SurfacePiece::tangents(const PiecePlace& place) const {
    const auto [a, b, c] = place;
    if (corners == 2) return {2 * a * (control[2] - control[0]) + 2 * b * (control[1] - control[2]), Vec::Zero()};
    const Vec by_a = 2 * (a * control[0] + b * control[3] + c * control[5]);
    const Vec by_b = 2 * (a * control[3] + b * control[1] + c * control[4]);
    const Vec by_c = 2 * (a * control[5] + b * control[4] + c * control[2]);
    return {by_b - by_a, by_c - by_a};
}

Vec SurfacePiece::normal(const PiecePlace& place) const {
    const auto [along, other] = tangents(place);
    const Vec across = corners == 2 ? Vec(along[1], -along[0], 0) : Vec(along.cross(other));
    const double size = across.norm();
    return size > 0 ? Vec(across / size) : Vec(Vec::Zero());
}

double SurfacePiece::angle_at(const PiecePlace& place) const {
    const auto corner = static_cast<std::size_t>(std::ranges::max_element(place) - place.begin());
    if (corners == 2 || place[corner] != 1) return 1;
    const Vec a = control[(corner + 1) % 3] - control[corner], b = control[(corner + 2) % 3] - control[corner];
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

double SurfacePiece::measure(const PiecePlace& place) const {
    const auto [along, other] = tangents(place);
    return corners == 2 ? along.norm() : 0.5 * along.cross(other).norm();
}

/// Gradients along the surface of the shares of the second and of the third corner; zero where it has collapsed.
std::array<Vec, 2> SurfacePiece::corner_slopes(const PiecePlace& place) const {
    const auto [along, other] = tangents(place);
    const double aa = along.squaredNorm(), ab = along.dot(other), bb = other.squaredNorm();
    if (corners == 2) return {aa > 0 ? Vec(along / aa) : Vec(Vec::Zero()), Vec::Zero()};
    const double square = aa * bb - ab * ab;
    if (!(square > 0)) return {Vec::Zero(), Vec::Zero()};
    return {(bb * along - ab * other) / square, (aa * other - ab * along) / square};
}

Vec SurfacePiece::gradient(const PiecePlace& place, const std::array<double, 3>& of_corners) const {
    const auto [of_b, of_c] = corner_slopes(place);
    return (of_corners[1] - of_corners[0]) * of_b + (of_corners[2] - of_corners[0]) * of_c;
}

std::array<Vec, SurfacePiece::most_controls> SurfacePiece::share_slopes(const PiecePlace& place) const {
    const auto [a, b, c] = place;
    const auto [of_b, of_c] = corner_slopes(place);
    const Vec of_a = -of_b - of_c;
    if (corners == 2) return {2 * a * of_a, 2 * b * of_b, 2 * (a * of_b + b * of_a)};
    return {2 * a * of_a,
            2 * b * of_b,
            2 * c * of_c,
            2 * (a * of_b + b * of_a),
            2 * (b * of_c + c * of_b),
            2 * (c * of_a + a * of_c)};
}

std::pair<Vec, Vec> SurfacePiece::box() const {
    Vec low = control[0], high = control[0];
    for (std::size_t k = 1; k < controls(); ++k) {
        low = low.cwiseMin(control[k]);
        high = high.cwiseMax(control[k]);
    }
    return {low, high};
}

PiecePlace SurfacePiece::nearest(const Vec& point) const {
    if (corners == 3) return nearest_on_triangle(point);
    const double t = nearest_on_curve(control[0], control[2], control[1], point);
    return {1 - t, t, 0};
}

/// Newton's method inside the triangle; where it leads out, the nearest place of the border.
PiecePlace SurfacePiece::nearest_on_triangle(const Vec& point) const {
    const Vec bend_b = 2 * (control[1] - 2 * control[3] + control[0]);
    const Vec bend_c = 2 * (control[2] - 2 * control[5] + control[0]);
    const Vec twist = 2 * (control[4] - control[3] - control[5] + control[0]);
    const double bend = std::max({bend_b.squaredNorm(), bend_c.squaredNorm(), twist.squaredNorm()});
    const bool is_flat = bend <= 1e-24 * (control[1] - control[0]).squaredNorm();
    PiecePlace place = middle();
    for (int k = 0; k < most_iterations; ++k) {
        const Vec off = at(place) - point;
        const auto [along, other] = tangents(place);
        Eigen::Matrix2d flat, slope;
        flat << along.squaredNorm(), along.dot(other), along.dot(other), other.squaredNorm();
        slope << off.dot(bend_b), off.dot(twist), off.dot(twist), off.dot(bend_c);
        slope += flat;
        // Of the eigenvalues of flat^-1 slope the lesser one.
        const Eigen::Matrix2d relative = flat.inverse() * slope;
        const double half = relative.trace() / 2;
        const double least = half - std::sqrt(std::max(0.0, half * half - relative.determinant()));
        if (!(least > least_slope)) slope += (least_slope - std::min(least, least_slope)) * flat;
        const Eigen::Vector2d step = slope.inverse() * Eigen::Vector2d(-off.dot(along), -off.dot(other));
        if (!step.allFinite()) break;
        const std::array<double, 3> change{-step[0] - step[1], step[0], step[1]};
        double fraction = 1;
        std::size_t out = corners;
        for (std::size_t c = 0; c < 3; ++c)
            if (place[c] + change[c] < 0 && place[c] < -fraction * change[c]) {
                fraction = place[c] / -change[c];
                out = c;
            }
        // Out over the border on which it is: the nearest place is there.
        if (out != corners && fraction == 0) break;
        for (std::size_t c = 0; c < 3; ++c) place[c] = std::max(0.0, place[c] + fraction * change[c]);
        if (out != corners) {
            place[out] = 0;
            continue;
        }
        if (is_flat || std::abs(step[0]) + std::abs(step[1]) <= enough) return place;
    }
    return nearest_on_border(point, place);
}

/// Of a triangle, from a place on it: first on the edge where that is, and on the others if its nearest place is a
/// corner.
PiecePlace SurfacePiece::nearest_on_border(const Vec& point, const PiecePlace& from) const {
    PiecePlace best = from;
    double nearest = (at(from) - point).squaredNorm();
    bool is_corner = true;
    const auto look = [&](std::size_t edge) {
        const std::size_t next = (edge + 1) % 3;
        const double t = nearest_on_curve(control[edge], control[3 + edge], control[next], point);
        PiecePlace on_edge{};
        on_edge[edge] = 1 - t;
        on_edge[next] = t;
        const double square = (at(on_edge) - point).squaredNorm();
        if (square > nearest) return;
        nearest = square;
        best = on_edge;
        is_corner = t == 0 || t == 1;
    };
    const auto zero = static_cast<std::size_t>(std::ranges::min_element(from) - from.begin());
    look((zero + 1) % 3);
    if (is_corner)
        for (const std::size_t edge : {zero, (zero + 2) % 3}) look(edge);
    return best;
}

std::array<Vec, 3> SurfacePiece::couple(const Vec& moment) const {
    if (corners == 2) {
        const Vec chord = control[1] - control[0];
        const Vec at_end = moment[2] / chord.squaredNorm() * Vec(-chord[1], chord[0], 0);
        return {-at_end, at_end, Vec::Zero()};
    }
    const Vec mean = (control[0] + control[1] + control[2]) / 3;
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec arm = control[k] - mean;
        inertia += arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose();
    }
    const Vec turn = inertia.ldlt().solve(moment);
    std::array<Vec, 3> force{};
    for (std::size_t k = 0; k < 3; ++k) force[k] = turn.cross(control[k] - mean);
    return force;
}

}  // namespace dmp::solver
