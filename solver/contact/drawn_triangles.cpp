// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "solver/contact/drawn_surfaces.hpp"

namespace dmp::solver {

namespace {

class TriangleDrawing {
  public:
    explicit TriangleDrawing(const ParticleSpace& space);

    DrawnSurfaces draw();

  private:
    using OfPoints = DrawnSurfaces::OfPoints;
    struct Edge {
        int a, b;                    ///< points, a < b
        std::vector<int> triangles;  ///< on both sides
        bool is_sharp = false, is_level = false;
        bool sticks_out = false, is_border = false;  ///< of sharp ones
    };

    [[nodiscard]] const Vec& at(int point) const { return space_.contact_points[static_cast<std::size_t>(point)]; }
    [[nodiscard]] std::array<int, 3> corners(int triangle) const {
        const ContactPiece& piece = space_.contact_pieces[static_cast<std::size_t>(triangle)];
        return {piece.a, piece.b, piece.c};
    }
    [[nodiscard]] Vec normal(int triangle) const {
        const auto [a, b, c] = corners(triangle);
        return (at(b) - at(a)).cross(at(c) - at(a)).normalized();
    }
    void judge(Edge& edge) const;
    [[nodiscard]] bool is_flat_around(const Edge& edge) const;
    [[nodiscard]] std::vector<int> points_around(const Edge& edge) const;
    [[nodiscard]] std::optional<OfPoints> middle_of_surface(const Edge& edge) const;
    [[nodiscard]] OfPoints control_of(const Edge& edge) const;

    const ParticleSpace& space_;
    std::vector<Edge> edges_;
    std::vector<std::array<int, 3>> edges_of_;    ///< of each triangle
    std::vector<std::vector<int>> edges_around_;  ///< of each point
};

TriangleDrawing::TriangleDrawing(const ParticleSpace& space)
    : space_(space), edges_around_(space.contact_points.size()) {
    std::map<std::pair<int, int>, int> number;
    for (std::size_t k = 0; k < space.contact_pieces.size(); ++k) {
        const auto corner = corners(static_cast<int>(k));
        edges_of_.emplace_back();
        for (std::size_t e = 0; e < 3; ++e) {
            const auto [a, b] = std::minmax(corner[e], corner[(e + 1) % 3]);
            const auto [found, is_new] = number.try_emplace({a, b}, static_cast<int>(edges_.size()));
            if (is_new) edges_.push_back({a, b, {}});
            edges_[static_cast<std::size_t>(found->second)].triangles.push_back(static_cast<int>(k));
            edges_of_.back()[e] = found->second;
        }
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        judge(edges_[e]);
        for (const int point : {edges_[e].a, edges_[e].b})
            edges_around_[static_cast<std::size_t>(point)].push_back(static_cast<int>(e));
    }
}

void TriangleDrawing::judge(Edge& edge) const {
    if (edge.triangles.size() != 2) {
        edge.is_sharp = edge.is_border = true;
        return;
    }
    const Vec first = normal(edge.triangles[0]), second = normal(edge.triangles[1]);
    const double turn = std::atan2(first.cross(second).norm(), first.dot(second));
    edge.is_level = turn < straight_turn;
    edge.is_sharp = turn > sharp_turn;
    if (!edge.is_sharp) return;
    for (const int corner : corners(edge.triangles[1]))
        if (corner != edge.a && corner != edge.b) edge.sticks_out = (at(corner) - at(edge.a)).dot(first) < 0;
}

/// Four corners of two triangles may lie in a plane on any surface: the edges around both ends say.
bool TriangleDrawing::is_flat_around(const Edge& edge) const {
    for (const int point : {edge.a, edge.b})
        for (const int e : edges_around_[static_cast<std::size_t>(point)])
            if (const Edge& other = edges_[static_cast<std::size_t>(e)]; !other.is_sharp && !other.is_level)
                return false;
    return true;
}

/// The corners of all triangles around both ends, as far as no sharp edge is between; ascending.
std::vector<int> TriangleDrawing::points_around(const Edge& edge) const {
    std::vector<int> points, seen = edge.triangles, waiting = edge.triangles;
    while (!waiting.empty()) {
        const int triangle = waiting.back();
        waiting.pop_back();
        for (const int corner : corners(triangle)) points.push_back(corner);
        for (const int e : edges_of_[static_cast<std::size_t>(triangle)]) {
            const Edge& side = edges_[static_cast<std::size_t>(e)];
            const bool is_around = side.a == edge.a || side.b == edge.a || side.a == edge.b || side.b == edge.b;
            if (side.is_sharp || !is_around) continue;
            for (const int next : side.triangles)
                if (std::ranges::find(seen, next) == seen.end()) {
                    seen.push_back(next);
                    waiting.push_back(next);
                }
        }
    }
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

/// The point of the surface at the middle of an edge as shares of the points around it, by moving least squares:
/// exact where the surface is quadratic. Nothing where the points do not say.
std::optional<TriangleDrawing::OfPoints> TriangleDrawing::middle_of_surface(const Edge& edge) const {
    using Quadratic = Eigen::Matrix<double, 6, 1>;
    constexpr double worst_condition = 1e-6;
    const std::vector<int> points = points_around(edge);
    if (points.size() < 6) return std::nullopt;
    const Vec origin = 0.5 * (at(edge.a) + at(edge.b));
    const Vec along = at(edge.b) - at(edge.a);
    const double length = along.norm();
    const Vec x = along / length;
    const Vec y = (normal(edge.triangles[0]) + normal(edge.triangles[1])).cross(x).normalized();
    std::vector<Quadratic> terms;
    std::vector<double> weights;
    Eigen::Matrix<double, 6, 6> moments = Eigen::Matrix<double, 6, 6>::Zero();
    for (const int point : points) {
        const Vec off = (at(point) - origin) / length;
        const double u = off.dot(x), v = off.dot(y);
        terms.emplace_back((Quadratic() << 1, u, v, u * u, u * v, v * v).finished());
        weights.push_back(1 / (0.1 + u * u + v * v));
        moments += weights.back() * terms.back() * terms.back().transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(moments);
    if (!(solver.eigenvalues()[0] > worst_condition * solver.eigenvalues()[5])) return std::nullopt;
    const Quadratic coefficients = moments.inverse() * Quadratic::Unit(0);
    OfPoints shares;
    for (std::size_t k = 0; k < points.size(); ++k)
        shares.emplace_back(points[k], weights[k] * coefficients.dot(terms[k]));
    return shares;
}

TriangleDrawing::OfPoints TriangleDrawing::control_of(const Edge& edge) const {
    OfPoints straight{{edge.a, 0.5}, {edge.b, 0.5}};
    if (edge.is_sharp || is_flat_around(edge)) return straight;
    std::optional<OfPoints> control = middle_of_surface(edge);
    if (!control) return straight;
    // The edge's curve, from a to b, goes through it.
    for (auto& [point, share] : *control) share = 2 * share - (point == edge.a || point == edge.b ? 0.5 : 0);
    return *control;
}

DrawnSurfaces TriangleDrawing::draw() {
    DrawnSurfaces drawn;
    drawn.corners = 3;
    const auto points = static_cast<int>(space_.contact_points.size());
    for (int point = 0; point < points; ++point) {
        drawn.controls.push_back({{point, 1.0}});
        const auto& around = edges_around_[static_cast<std::size_t>(point)];
        const auto any = [&](bool Edge::*is) {
            return std::ranges::any_of(around, [&](int e) { return edges_[static_cast<std::size_t>(e)].*is; });
        };
        drawn.is_sharp.push_back(any(&Edge::sticks_out));
        drawn.is_end.push_back(drawn.is_sharp.back() || any(&Edge::is_border));
    }
    for (const Edge& edge : edges_) {
        drawn.controls.push_back(control_of(edge));
        drawn.is_sharp.push_back(edge.sticks_out);
        drawn.is_end.push_back(edge.sticks_out || edge.is_border);
    }
    for (std::size_t k = 0; k < space_.contact_pieces.size(); ++k) {
        const ContactPiece& piece = space_.contact_pieces[k];
        const auto& edges = edges_of_[k];
        drawn.pieces.push_back({piece.part,
                                piece.thickness,
                                {piece.a, piece.b, piece.c, points + edges[0], points + edges[1], points + edges[2]}});
    }
    return drawn;
}

}  // namespace

DrawnSurfaces draw_triangles(const ParticleSpace& space) { return TriangleDrawing(space).draw(); }

}  // namespace dmp::solver
