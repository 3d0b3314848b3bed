// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cad_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <gmsh.h>

#include "geometry/geometry_file.hpp"

namespace dmp::geometry {

namespace {

/// Edges around a full circle of the geometry's own size that keep a chord within `error` of the arc; within reason.
double edges_around(double size, double error) {
    const double radius = 0.5 * size;
    const double most = 720, fewest = 24;
    if (error >= radius) return fewest;
    return std::clamp(std::ceil(std::numbers::pi / std::acos(1 - error / radius)), fewest, most);
}

bool has_a_mesh() {
    std::vector<int> types;
    gmsh::model::mesh::getElementTypes(types, 2);
    return !types.empty();
}

}  // namespace

CadSurfaces::CadSurfaces(const GeometryOptions& options) : options_(options) {
    if (!has_a_mesh()) make_mesh();
    std::vector<std::size_t> tags;
    std::vector<double> coordinates, parametric;
    gmsh::model::mesh::getNodes(tags, coordinates, parametric);
    for (std::size_t i = 0; i < tags.size(); ++i) {
        const Vec position = options.metres() * Vec(coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]);
        check_coordinates(position, options.file);
        nodes_[tags[i]] = position;
    }
    gmsh::vectorpair surfaces;
    gmsh::model::getEntities(surfaces, 2);
    for (const auto& [dimension, tag] : surfaces) {
        std::vector<int> types;
        std::vector<std::vector<std::size_t>> elements, corners;
        gmsh::model::mesh::getElements(types, elements, corners, 2, tag);
        for (std::size_t k = 0; k < types.size(); ++k) {
            std::string name;
            int element_dimension = 0, order = 0, nodes = 0, primary = 0;
            std::vector<double> local;
            gmsh::model::mesh::getElementProperties(types[k], name, element_dimension, order, nodes, local, primary);
            const auto step = static_cast<std::size_t>(nodes);
            // A quadrangle is two triangles; nodes between corners are left out.
            for (std::size_t e = 0; e + step <= corners[k].size(); e += step)
                for (std::size_t c = 1; c + 1 < static_cast<std::size_t>(primary); ++c)
                    triangles_[tag].push_back({corners[k][e], corners[k][e + c], corners[k][e + c + 1]});
        }
    }
}

void CadSurfaces::make_mesh() const {
    double low_x = 0, low_y = 0, low_z = 0, high_x = 0, high_y = 0, high_z = 0;
    gmsh::model::getBoundingBox(-1, -1, low_x, low_y, low_z, high_x, high_y, high_z);
    std::array<double, 3> extents{high_x - low_x, high_y - low_y, high_z - low_z};
    std::ranges::sort(extents);
    const double size = Vec(extents[0], extents[1], extents[2]).norm();
    const double widest = 1.1 * extents[1];                               // a circle lies across two axes
    const double error = 0.5 * options_.chord_error / options_.metres();  // gmsh's edges come out longer than asked for
    gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);                // the geometry's sizes are for other purposes
    gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", edges_around(widest, error));
    gmsh::option::setNumber("Mesh.MeshSizeMax", size);
    gmsh::option::setNumber("Mesh.Algorithm", 6);
    gmsh::model::mesh::generate(2);
}

TriangleSurface CadSurfaces::surfaces(const std::vector<int>& tags) const {
    TriangleSurface surface;
    std::map<std::size_t, int> numbers;
    const auto number_of = [&](std::size_t node) {
        const auto [found, is_new] = numbers.try_emplace(node, static_cast<int>(surface.corners.size()));
        if (is_new) surface.corners.push_back(nodes_.at(node));
        return found->second;
    };
    for (const int tag : tags) {
        const auto found = triangles_.find(tag);
        if (found == triangles_.end()) continue;
        for (const auto& [a, b, c] : found->second)
            surface.triangles.push_back({number_of(a), number_of(b), number_of(c)});
    }
    return surface;
}

TriangleSurface CadSurfaces::boundary(const std::vector<int>& volumes) const {
    std::map<int, int> times;
    for (const int volume : volumes) {
        gmsh::vectorpair around;
        gmsh::model::getBoundary({{3, volume}}, around, false, false, false);
        for (const auto& [dimension, tag] : around) ++times[std::abs(tag)];
    }
    std::vector<int> tags;
    for (const auto& [tag, count] : times)
        if (count % 2 != 0) tags.push_back(tag);
    return surfaces(tags);
}

Vec CadSurfaces::point(int tag) const {
    std::vector<double> x;
    gmsh::model::getValue(0, tag, {}, x);
    const Vec position = options_.metres() * Vec(x.at(0), x.at(1), x.at(2));
    check_coordinates(position, options_.file);
    return position;
}

}  // namespace dmp::geometry
