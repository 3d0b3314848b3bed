// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cad_curves.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <utility>

#include <gmsh.h>

#include "base/length_text.hpp"
#include "geometry/number_text.hpp"
#include "geometry/segments.hpp"

namespace dmp::geometry {

namespace {

/// Two end nodes, then the nodes between them.
using MeshEdge = std::vector<std::size_t>;

Vec value_at(int dimension, int tag, const std::vector<double>& parameter) {
    std::vector<double> x;
    gmsh::model::getValue(dimension, tag, parameter, x);
    return {x.at(0), x.at(1), x.at(2)};
}

std::string type_of(int dimension, int tag) {
    std::string type;
    gmsh::model::getType(dimension, tag, type);
    return type;
}

/// The model points at the two ends of a curve, which a formula hits only up to rounding; a closed curve has one or
/// none.
std::pair<Vec, Vec> end_points(int tag, double from, double to) {
    const Vec start = value_at(1, tag, {from});
    const Vec end = value_at(1, tag, {to});
    gmsh::vectorpair ends;
    gmsh::model::getBoundary({{1, tag}}, ends, false, false, false);
    if (ends.empty()) return {start, start};
    const Vec first = value_at(0, std::abs(ends.front().second), {});
    const Vec last = value_at(0, std::abs(ends.back().second), {});
    const bool swapped = (first - start).norm() + (last - end).norm() > (last - start).norm() + (first - end).norm();
    return swapped ? std::pair{last, first} : std::pair{first, last};
}

int nodes_per_edge(int element_type) {
    std::string name;
    int dimension = 0;
    int order = 0;
    int nodes = 0;
    int corners = 0;
    std::vector<double> local;
    gmsh::model::mesh::getElementProperties(element_type, name, dimension, order, nodes, local, corners);
    return order + 1;
}

/// The edges of the elements of one curve or surface; an edge between two elements comes twice.
void append_edges(int dimension, int tag, std::vector<MeshEdge>& edges) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> elements;
    std::vector<std::vector<std::size_t>> nodes;
    gmsh::model::mesh::getElements(types, elements, nodes, dimension, tag);
    for (std::size_t i = 0; i < types.size(); ++i) {
        if (dimension == 2) gmsh::model::mesh::getElementEdgeNodes(types[i], nodes[i], tag);
        const std::ptrdiff_t step = nodes_per_edge(types[i]);
        for (auto node = nodes[i].cbegin(); node != nodes[i].cend(); node += step)
            edges.emplace_back(node, node + step);
    }
}

/// Keeps the edges that belong to an odd number of elements.
void cancel_shared_edges(std::vector<MeshEdge>& edges) {
    for (auto& edge : edges) {
        if (edge[0] < edge[1]) continue;
        std::swap(edge[0], edge[1]);
        std::reverse(edge.begin() + 2, edge.end());
    }
    std::ranges::sort(edges);
    std::vector<MeshEdge> odd;
    for (auto edge = edges.cbegin(); edge != edges.cend();) {
        const auto next = std::find_if(edge, edges.cend(), [&](const MeshEdge& other) { return other != *edge; });
        if ((next - edge) % 2 != 0) odd.push_back(*edge);
        edge = next;
    }
    edges = std::move(odd);
}

}  // namespace

CadCurves::CadCurves(const GeometryOptions& options) : options_(options) {
    std::vector<std::size_t> tags;
    std::vector<double> x;
    std::vector<double> parameters;
    gmsh::model::mesh::getNodes(tags, x, parameters, -1, -1, false, false);
    for (std::size_t i = 0; i < tags.size(); ++i) nodes_[tags[i]] = in_metres({x[3 * i], x[3 * i + 1], x[3 * i + 2]});
}

Vec CadCurves::point(int tag) const { return in_metres(value_at(0, tag, {})); }

InputError CadCurves::problem(int curve, const std::string& what, const std::string& what_to_do) const {
    return {SourceLocation{.file = options_.file}, "curve " + std::to_string(curve) + " " + what, what_to_do};
}

const std::vector<CurvePiece>& CadCurves::curve(int tag) {
    const auto [found, fresh] = curves_.try_emplace(tag);
    auto& pieces = found->second;
    if (!fresh) return pieces;
    const std::string type = type_of(1, tag);
    if (type == "Discrete curve") {
        pieces = mesh_edges(1, {tag});
    } else {
        pieces.push_back(sampled(tag, type == "Line"));
    }
    for (const auto& piece : pieces) {
        const bool has_length = std::ranges::any_of(piece, [&](const Vec& p) { return p != piece.front(); });
        if (!has_length) throw problem(tag, "has no length", "Remove it, or move one of its ends.");
    }
    return pieces;
}

CurveSet CadCurves::set(const std::string& name, const std::vector<int>& tags) {
    std::vector<CurvePiece> pieces;
    for (const int tag : tags) std::ranges::copy(curve(tag), std::back_inserter(pieces));
    return {.name = name, .pieces = maximal_chains(pieces)};
}

std::vector<CurvePiece> CadCurves::boundary(const std::vector<int>& surfaces) {
    std::vector<CurvePiece> pieces;
    std::vector<int> meshes;
    for (auto each = surfaces.begin(); each != surfaces.end(); ++each) {
        const int surface = *each;
        if (std::find(surfaces.begin(), each, surface) != each) continue;  // gmsh's groups may name one twice
        if (type_of(2, surface) == "Discrete surface") {
            meshes.push_back(surface);
            continue;
        }
        gmsh::vectorpair edges;
        gmsh::model::getBoundary({{2, surface}}, edges, false, false, false);
        for (const auto& [dimension, tag] : edges) {
            const auto& of_edge = curve(std::abs(tag));
            pieces.insert(pieces.end(), of_edge.begin(), of_edge.end());
        }
    }
    const auto of_meshes = mesh_edges(2, meshes);
    pieces.insert(pieces.end(), of_meshes.begin(), of_meshes.end());
    return pieces;
}

/// Points along a curve, close enough together; the first and the last are the geometry's own points.
CurvePiece CadCurves::sampled(int tag, bool straight) const {
    constexpr int parts = 8;  // to begin with, so that an S is not taken for its chord
    std::vector<double> from;
    std::vector<double> to;
    gmsh::model::getParametrizationBounds(1, tag, from, to);
    const auto [start, end] = end_points(tag, from.at(0), to.at(0));
    if (straight) return {in_metres(start), in_metres(end)};

    CurvePiece points;
    const double step = (to[0] - from[0]) / parts;
    Vec here = start;
    for (int i = 0; i < parts; ++i) {
        const Vec next = i + 1 < parts ? value_at(1, tag, {from[0] + (i + 1) * step}) : end;
        points.push_back(in_metres(here));
        refine(tag, from[0] + i * step, step, here, next, 0, points);
        here = next;
    }
    points.push_back(in_metres(end));
    return points;
}

/// Appends the points strictly between the ends of one part [t, t + step] of a curve, by halving.
void CadCurves::refine(int tag, double t, double step, const Vec& start, const Vec& end, int depth,
                       CurvePiece& points) const {
    constexpr int deepest = 40;
    constexpr double margin = 0.95;  // the largest deviation may lie between the samples
    const double tolerance = margin * options_.chord_error / options_.metres();
    const std::array<Vec, 3> inner{value_at(1, tag, {t + 0.25 * step}), value_at(1, tag, {t + 0.5 * step}),
                                   value_at(1, tag, {t + 0.75 * step})};
    const bool close = std::ranges::all_of(
        inner, [&](const Vec& point) { return nearest_on_segment(point, start, end).distance <= tolerance; });
    if (close) return;
    if (depth == deepest) {
        throw problem(tag, "cannot be followed to within " + length_text(options_.chord_error),
                      "Ask for a larger chord error, or simplify the curve.");
    }
    refine(tag, t, 0.5 * step, start, inner[1], depth + 1, points);
    points.push_back(in_metres(inner[1]));
    refine(tag, t + 0.5 * step, 0.5 * step, inner[1], end, depth + 1, points);
}

/// The mesh edges of curves, or those around surfaces.
std::vector<CurvePiece> CadCurves::mesh_edges(int dimension, const std::vector<int>& tags) const {
    std::vector<MeshEdge> edges;
    for (const int tag : tags) append_edges(dimension, tag, edges);
    if (dimension == 2) cancel_shared_edges(edges);
    std::vector<CurvePiece> pieces;
    for (const auto& edge : edges) {
        CurvePiece piece{nodes_.at(edge[0])};
        for (std::size_t i = 2; i < edge.size(); ++i) piece.push_back(nodes_.at(edge[i]));
        piece.push_back(nodes_.at(edge[1]));
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

}  // namespace dmp::geometry
