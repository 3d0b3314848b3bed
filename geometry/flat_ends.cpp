// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/flat_ends.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

#include "geometry/surface_edges.hpp"

namespace dmp::geometry {

namespace {

constexpr double flat = 1e-6;      ///< of one minus the cosine between normals of one face
constexpr double upright = 0.1;    ///< of the cosine between an end and the walls around it
constexpr double straight = 0.95;  ///< share of the rim at which such walls stand
constexpr double least_depth = 1.2;

/// The flat faces of a surface.
class Faces {
  public:
    explicit Faces(const TriangleSurface& surface) : surface_(surface), neighbours_(surface.triangles.size()) {
        for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
            const auto& [a, b, c] = corners(t);
            const Vec across = (b - a).cross(c - a);
            area_.push_back(0.5 * across.norm());
            normal_.push_back(area_.back() > 0 ? Vec(across.normalized()) : Vec(Vec::Zero()));
        }
        const std::vector<SurfaceEdge> edges = edges_of(surface);
        for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
            if (sides.size() != 2) return;
            const double length = (at(sides[0].low) - at(sides[0].high)).norm();
            for (const int k : {0, 1})
                neighbours_[static_cast<std::size_t>(sides[static_cast<std::size_t>(k)].triangle)].push_back(
                    {static_cast<std::size_t>(sides[static_cast<std::size_t>(1 - k)].triangle), length});
        });
    }

    std::vector<FlatEnd> ends() {
        std::vector<FlatEnd> found;
        std::vector<char> seen(surface_.triangles.size(), 0);
        for (std::size_t first = 0; first < seen.size(); ++first) {
            if (seen[first] != 0 || area_[first] == 0) continue;
            const std::vector<std::size_t> face = face_around(first, seen);
            const FlatEnd end = as_end(face);
            if (has_walls_behind(face, end) && depth_behind(face, end) > least_depth * std::sqrt(end.area))
                found.push_back(end);
        }
        std::ranges::sort(found, std::ranges::greater{}, &FlatEnd::area);
        return found;
    }

  private:
    struct Neighbour {
        std::size_t triangle = 0;
        double length = 0;  ///< of the edge between
    };

    [[nodiscard]] const Vec& at(int corner) const { return surface_.corners[static_cast<std::size_t>(corner)]; }
    [[nodiscard]] std::array<Vec, 3> corners(std::size_t t) const {
        const auto& [a, b, c] = surface_.triangles[t];
        return {at(a), at(b), at(c)};
    }
    [[nodiscard]] bool is_level(std::size_t t, std::size_t first) const {
        return area_[t] == 0 || normal_[t].dot(normal_[first]) > 1 - flat;
    }

    /// All that is connected with a triangle and has its normal.
    std::vector<std::size_t> face_around(std::size_t first, std::vector<char>& seen) const {
        std::vector<std::size_t> face{first};
        seen[first] = 1;
        for (std::size_t k = 0; k < face.size(); ++k)
            for (const Neighbour& next : neighbours_[face[k]])
                if (seen[next.triangle] == 0 && is_level(next.triangle, first)) {
                    seen[next.triangle] = 1;
                    face.push_back(next.triangle);
                }
        return face;
    }

    [[nodiscard]] FlatEnd as_end(const std::vector<std::size_t>& face) const {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        FlatEnd end{.outward = normal_[face.front()], .box = {Vec::Constant(infinity), Vec::Constant(-infinity)}};
        for (const std::size_t t : face) {
            const auto& [a, b, c] = corners(t);
            end.area += area_[t];
            end.centre += area_[t] * (a + b + c) / 3;
            for (const Vec& corner : {a, b, c}) {
                end.box.low = end.box.low.cwiseMin(corner);
                end.box.high = end.box.high.cwiseMax(corner);
            }
        }
        end.centre /= end.area;
        for (double& component : end.centre)  // what rounding leaves of 0
            if (std::abs(component) < 1e-9 * end.box.extent().norm()) component = 0;
        return end;
    }

    [[nodiscard]] bool has_walls_behind(const std::vector<std::size_t>& face, const FlatEnd& end) const {
        double rim = 0, walls = 0;
        for (const std::size_t t : face)
            for (const Neighbour& next : neighbours_[t]) {
                if (is_level(next.triangle, face.front())) continue;
                const auto& [a, b, c] = corners(next.triangle);
                const bool behind = ((a + b + c) / 3 - end.centre).dot(end.outward) < 0;
                rim += next.length;
                if (behind && std::abs(normal_[next.triangle].dot(end.outward)) < upright) walls += next.length;
            }
        return rim > 0 && walls >= straight * rim;
    }

    /// The largest distance back to the next surface: what stands in the solid may be nearer in places [m].
    [[nodiscard]] double depth_behind(const std::vector<std::size_t>& face, const FlatEnd& end) const {
        constexpr std::size_t most_lines = 16;
        double farthest = 0;
        for (std::size_t k = 0; k < face.size(); k += face.size() / most_lines + 1) {
            const auto& [a, b, c] = corners(face[k]);
            farthest = std::max(farthest, depth_behind((a + b + c) / 3, end));
        }
        return farthest;
    }
    [[nodiscard]] double depth_behind(const Vec& start, const FlatEnd& end) const {
        double nearest = std::numeric_limits<double>::infinity();
        const Vec inward = -end.outward;
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            // Moeller & Trumbore 1997; triangles that the line runs along are passed over.
            const auto& [a, b, c] = corners(t);
            const Vec ab = b - a, ac = c - a, across = inward.cross(ac), from = start - a;
            const double determinant = ab.dot(across);
            if (std::abs(determinant) <= 1e-12 * area_[t]) continue;
            const double u = from.dot(across) / determinant, v = inward.dot(from.cross(ab)) / determinant;
            const double distance = ac.dot(from.cross(ab)) / determinant;
            if (u >= 0 && v >= 0 && u + v <= 1 && distance > 1e-6 * std::sqrt(end.area))
                nearest = std::min(nearest, distance);
        }
        return std::isfinite(nearest) ? nearest : 0;
    }

    const TriangleSurface& surface_;
    std::vector<std::vector<Neighbour>> neighbours_;
    std::vector<double> area_;
    std::vector<Vec> normal_;
};

}  // namespace

std::vector<FlatEnd> flat_ends(const TriangleSurface& surface) { return Faces(surface).ends(); }

}  // namespace dmp::geometry
