// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/even_triangles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "geometry/divide_long_edges.hpp"
#include "geometry/nearest_triangle.hpp"
#include "geometry/sharp_edges.hpp"
#include "geometry/surface_edges.hpp"
#include "geometry/surface_pieces.hpp"

namespace dmp::geometry {

namespace {

/// CGAL splits edges of more than 4/3 of what it is asked for.
constexpr double longest_of_even = 4.0 / 3;
/// How often all edges are split, collapsed and flipped, and corners moved.
constexpr unsigned rounds = 3;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

std::optional<Mesh> mesh_of(const TriangleSurface& surface) {
    Mesh mesh;
    for (const Vec& corner : surface.corners) mesh.add_vertex({corner.x(), corner.y(), corner.z()});
    const auto vertex = [](int corner) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(corner)); };
    for (const auto& [a, b, c] : surface.triangles)
        if (mesh.add_face(vertex(a), vertex(b), vertex(c)) == Mesh::null_face()) return std::nullopt;
    return mesh;
}

TriangleSurface surface_of(const Mesh& mesh) {
    TriangleSurface surface;
    std::vector<int> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), -1);
    for (const auto vertex : mesh.vertices()) {
        if (mesh.is_isolated(vertex)) continue;
        number[vertex] = static_cast<int>(surface.corners.size());
        const Kernel::Point_3& point = mesh.point(vertex);
        surface.corners.emplace_back(point.x(), point.y(), point.z());
    }
    for (const auto face : mesh.faces()) {
        std::array<int, 3>& triangle = surface.triangles.emplace_back();
        std::size_t k = 0;
        for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) triangle.at(k++) = number[vertex];
    }
    return surface;
}

/// The triangles between sharp edges, each patch with its number.
std::vector<int> patches_of(const TriangleSurface& piece, const SharpEdges& sharp) {
    std::vector<std::vector<int>> neighbours(piece.triangles.size());
    const std::vector<SurfaceEdge> edges = edges_of(piece);
    for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
        if (std::ranges::binary_search(sharp.edges, std::array{sides.front().low, sides.front().high})) return;
        neighbours[static_cast<std::size_t>(sides[0].triangle)].push_back(sides[1].triangle);
        neighbours[static_cast<std::size_t>(sides[1].triangle)].push_back(sides[0].triangle);
    });
    std::vector<int> patch(piece.triangles.size(), -1);
    int count = 0;
    for (std::size_t t = 0; t < patch.size(); ++t) {
        if (patch[t] >= 0) continue;
        std::vector<int> reached{static_cast<int>(t)};
        patch[t] = count;
        while (!reached.empty()) {
            const auto here = static_cast<std::size_t>(reached.back());
            reached.pop_back();
            for (const int next : neighbours[here])
                if (int& other = patch[static_cast<std::size_t>(next)]; other < 0) {
                    other = count;
                    reached.push_back(next);
                }
        }
        ++count;
    }
    return patch;
}

/// CGAL takes it for granted that corners have a normal.
bool has_needle_or_cap_without_area(const TriangleSurface& piece) {
    constexpr double least_height = 1e-9;  // of the longest edge
    return std::ranges::any_of(piece.triangles, [&](const std::array<int, 3>& triangle) {
        const auto at = [&](std::size_t k) -> const Vec& {
            return piece.corners[static_cast<std::size_t>(triangle.at(k))];
        };
        const Vec a = at(1) - at(0), b = at(2) - at(0);
        const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
        return !(a.cross(b).norm() > least_height * longest);
    });
}

/// What stays the same as pieces are tried with shorter and shorter edges. Without edges of more than two triangles, or
/// of two that face different sides.
class Remesher {
  public:
    explicit Remesher(const TriangleSurface& piece)
        : piece_(piece), sharp_(sharp_edges(piece)), patch_(patches_of(piece, sharp_)) {
        double reach = 0;
        for (const Vec& corner : piece.corners) reach = std::max(reach, 2 * (corner - piece.corners[0]).norm());
        std::vector<std::vector<int>> triangles;
        for (std::size_t t = 0; t < patch_.size(); ++t) {
            const auto patch = static_cast<std::size_t>(patch_[t]);
            if (patch >= triangles.size()) triangles.resize(patch + 1);
            triangles[patch].push_back(static_cast<int>(t));
        }
        for (const auto& of_patch : triangles) drawn_.emplace_back(part_of(piece, of_patch), reach);
    }

    [[nodiscard]] std::optional<TriangleSurface> remeshed(double edge) const {
        std::optional<Mesh> mesh = mesh_of(piece_);
        if (!mesh) return std::nullopt;
        auto is_sharp = mesh->add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
        auto stays = mesh->add_property_map<Mesh::Vertex_index, bool>("v:stays", false).first;
        auto patch = mesh->add_property_map<Mesh::Face_index, int>("f:patch", -1).first;
        const auto vertex = [](int corner) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(corner)); };
        for (const auto& [a, b] : sharp_.edges) is_sharp[mesh->edge(mesh->halfedge(vertex(a), vertex(b)))] = true;
        for (const int corner : sharp_.corners) stays[vertex(corner)] = true;
        for (const auto face : mesh->faces()) patch[face] = patch_[static_cast<std::size_t>(face.idx())];
        // By patches: the nearest triangle may be on the other side of something thin.
        const auto on_the_piece = [&](const Mesh::Vertex_index at) {
            const Kernel::Point_3& point = mesh->point(at);
            if (mesh->is_border(mesh->halfedge(at))) return point;
            const auto of_patch = static_cast<std::size_t>(patch[mesh->face(mesh->halfedge(at))]);
            const auto found = drawn_.at(of_patch).nearest({point.x(), point.y(), point.z()});
            return found ? Kernel::Point_3(found->point.x(), found->point.y(), found->point.z()) : point;
        };
        CGAL::Polygon_mesh_processing::isotropic_remeshing(mesh->faces(), edge, *mesh,
                                                           CGAL::parameters::number_of_iterations(rounds)
                                                               .edge_is_constrained_map(is_sharp)
                                                               .vertex_is_constrained_map(stays)
                                                               .face_patch_map(patch)
                                                               .projection_functor(on_the_piece));
        return surface_of(*mesh);
    }

  private:
    const TriangleSurface& piece_;
    SharpEdges sharp_;
    std::vector<int> patch_;              ///< by triangle
    std::vector<NearestTriangle> drawn_;  ///< by patch
};

/// Edges that became too long as corners moved.
TriangleSurface without_long_edges(const TriangleSurface& even, const TriangleSurface& piece, double edge) {
    const auto before = static_cast<std::ptrdiff_t>(even.corners.size());
    TriangleSurface divided = divide_long_edges(even, longest_of_even * edge);
    if (std::ssize(divided.corners) == before) return divided;
    const NearestTriangle nearest(piece, edge);
    std::for_each(divided.corners.begin() + before, divided.corners.end(), [&](Vec& corner) {
        if (const auto found = nearest.nearest(corner)) corner = found->point;
    });
    return divided;
}

/// Whether triangles are where the piece is: near each of its corners, with about its area, and closed where it is.
bool follows(const TriangleSurface& even, const TriangleSurface& piece, double edge) {
    constexpr double off = 0.15, least_area = 0.7, most_area = 1.1;
    if (even.triangles.empty()) return false;
    if (!std::ranges::all_of(even.corners, [](const Vec& corner) { return corner.allFinite(); })) return false;
    const double area = even.area() / piece.area();
    if (!(area > least_area && area < most_area)) return false;
    if (count_edges(even).closed() != count_edges(piece).closed()) return false;
    const NearestTriangle nearest(even, off * edge);
    return std::ranges::all_of(piece.corners, [&](const Vec& corner) { return nearest.nearest(corner).has_value(); });
}

TriangleSurface even_piece(const TriangleSurface& drawn, double edge) {
    // Long ones first: places of slivers are slow to find.
    TriangleSurface piece = divide_long_edges(drawn, longest_of_even * edge);
    if (has_needle_or_cap_without_area(piece)) return piece;
    try {
        const Remesher remesher(piece);
        for (const double part : {1.0, 0.5, 0.25}) {
            const std::optional<TriangleSurface> even = remesher.remeshed(part * edge);
            if (even && follows(*even, piece, edge)) return without_long_edges(*even, piece, part * edge);
        }
    } catch (const std::exception&) {
        return piece;  // CGAL's checks say that it cannot
    }
    return piece;
}

}  // namespace

TriangleSurface even_triangles(const TriangleSurface& surface, double edge) {
    if (!(edge > 0)) throw std::invalid_argument("even_triangles: the edge must be positive");
    const TriangleSurface cut = cut_at_unlike_edges(surface);
    TriangleSurface all;
    all.has_holes = surface.has_holes;
    const SurfacePieces pieces(cut);
    for (const SurfacePiece& piece : pieces.all()) {
        const TriangleSurface even = even_piece(part_of(cut, piece.triangles), edge);
        const auto first = static_cast<int>(all.corners.size());
        all.corners.insert(all.corners.end(), even.corners.begin(), even.corners.end());
        for (const auto& [a, b, c] : even.triangles) all.triangles.push_back({first + a, first + b, first + c});
    }
    return all;
}

}  // namespace dmp::geometry
