// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/fill_holes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include "geometry/surface_edges.hpp"
#include "geometry/surface_pieces.hpp"

namespace dmp::geometry {

namespace {

constexpr std::size_t most_edges_of_least_area = 100;

struct Rim {
    std::vector<int> corners;  ///< in the sense in which the filling runs through them
    int triangle = 0;          ///< one of those at the rim
};

/// Closed chains of open edges. Where rims touch in a corner, each round trip is one of its own.
std::vector<Rim> rims_of(const TriangleSurface& surface) {
    std::map<int, std::vector<std::pair<int, int>>> next;  // the corners that follow one, and the triangle there
    const std::vector<SurfaceEdge> edges = edges_of(surface);
    for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
        if (sides.size() == 1) next[sides.front().to()].push_back({sides.front().from(), sides.front().triangle});
    });
    std::vector<Rim> rims;
    for (auto& [start, ways] : next)
        while (!ways.empty()) {
            std::vector<int> walk{start}, triangles;
            for (auto at = next.find(start); at != next.end() && !at->second.empty(); at = next.find(walk.back())) {
                const auto [to, triangle] = at->second.back();
                at->second.pop_back();
                triangles.push_back(triangle);
                const auto before = std::ranges::find(walk, to);
                if (before == walk.end()) {
                    walk.push_back(to);
                    continue;
                }
                rims.push_back({{before, walk.end()}, triangle});
                triangles.resize(static_cast<std::size_t>(before - walk.begin()));
                walk.erase(before + 1, walk.end());
            }
        }
    return rims;
}

double area_of(const Vec& a, const Vec& b, const Vec& c) { return 0.5 * (b - a).cross(c - a).norm(); }

/// The triangles of least area between the corners of a rim; none if only triangles without area would do.
class LeastArea {
  public:
    LeastArea(const TriangleSurface& surface, const std::vector<int>& rim)
        : corners_(rim), size_(rim.size()), least_(size_ * size_, 0), through_(size_ * size_, 0) {
        const auto at = [&](std::size_t k) -> const Vec& { return surface.corners[static_cast<std::size_t>(rim[k])]; };
        for (std::size_t width = 2; width < size_; ++width)
            for (std::size_t i = 0; i + width < size_; ++i) {
                const std::size_t k = i + width;
                double best = std::numeric_limits<double>::infinity();
                for (std::size_t j = i + 1; j < k; ++j) {
                    const double area = area_of(at(i), at(j), at(k));
                    if (!(area > 0)) continue;
                    const double sum = least_[i * size_ + j] + least_[j * size_ + k] + area;
                    if (sum < best) {
                        best = sum;
                        through_[i * size_ + k] = j;
                    }
                }
                least_[i * size_ + k] = best;
            }
    }
    [[nodiscard]] std::vector<std::array<int, 3>> triangles() const {
        std::vector<std::array<int, 3>> found;
        if (!(least_[size_ - 1] < std::numeric_limits<double>::infinity())) return found;
        std::vector<std::pair<std::size_t, std::size_t>> open{{0, size_ - 1}};
        while (!open.empty()) {
            const auto [i, k] = open.back();
            open.pop_back();
            if (k - i < 2) continue;
            const std::size_t j = through_[i * size_ + k];
            found.push_back({corners_[i], corners_[j], corners_[k]});
            open.emplace_back(i, j);
            open.emplace_back(j, k);
        }
        return found;
    }

  private:
    const std::vector<int>& corners_;
    std::size_t size_;
    std::vector<double> least_;         ///< area between the i-th and the k-th corner
    std::vector<std::size_t> through_;  ///< the corner that makes a triangle with them
};

std::vector<std::array<int, 3>> around_middle(const std::vector<int>& rim, int middle) {
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t k = 0; k < rim.size(); ++k) triangles.push_back({rim[k], rim[(k + 1) % rim.size()], middle});
    return triangles;
}

}  // namespace

std::vector<SurfaceHole> fill_holes(TriangleSurface& surface, double largest_perimeter) {
    std::vector<SurfaceHole> holes;
    const std::vector<Rim> rims = rims_of(surface);
    if (rims.empty()) return holes;
    const SurfacePieces pieces(surface);
    for (const Rim& rim : rims) {
        SurfaceHole& hole = holes.emplace_back();
        hole.edges = rim.corners.size();
        for (std::size_t k = 0; k < rim.corners.size(); ++k) {
            const Vec& here = surface.corners[static_cast<std::size_t>(rim.corners[k])];
            const auto next = static_cast<std::size_t>(rim.corners[(k + 1) % rim.corners.size()]);
            hole.perimeter += (surface.corners[next] - here).norm();
            hole.position += here / static_cast<double>(rim.corners.size());
        }
        if (hole.perimeter > largest_perimeter || hole.edges < 3) continue;
        std::vector<std::array<int, 3>> filling;
        if (hole.edges <= most_edges_of_least_area) {
            filling = LeastArea(surface, rim.corners).triangles();
        } else {
            surface.corners.push_back(hole.position);
            filling = around_middle(rim.corners, static_cast<int>(surface.corners.size()) - 1);
        }
        double area = 0;
        for (const auto& [a, b, c] : filling)
            area += area_of(surface.corners[static_cast<std::size_t>(a)], surface.corners[static_cast<std::size_t>(b)],
                            surface.corners[static_cast<std::size_t>(c)]);
        if (area > 0.75 * pieces.area_around(rim.triangle)) continue;
        hole.triangles = filling.size();
        surface.triangles.insert(surface.triangles.end(), filling.begin(), filling.end());
    }
    return holes;
}

}  // namespace dmp::geometry
