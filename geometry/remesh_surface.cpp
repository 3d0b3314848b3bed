// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/remesh_surface.hpp"

#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmsh.h>

#include "geometry/gmsh_session.hpp"
#include "geometry/orient_surface.hpp"

namespace dmp::geometry {

namespace {

constexpr double corner_angle = std::numbers::pi / 6;
constexpr int triangle_type = 2, frontal_delaunay = 6;  // gmsh's numbers

void need_two_sides(const Orientation& found) {
    if (found.many_fold == 0 && found.contradicted == 0) return;
    throw InputError("the surface branches, or has only one side as a Moebius strip has: it cannot become a shell",
                     "draw sheets that have two sides and do not branch");
}

/// Makes the surface gmsh's only one; lengths in edges of the new mesh, whatever they are in metres.
void hand_over(const TriangleSurface& surface, double edge) {
    gmsh::model::add("sheet");
    const int sheet = gmsh::model::addDiscreteEntity(2);
    std::vector<std::size_t> numbers, triangles, corners;
    std::vector<double> coordinates;
    for (const Vec& corner : surface.corners) {
        numbers.push_back(numbers.size() + 1);
        for (int axis = 0; axis < 3; ++axis) coordinates.push_back(corner[axis] / edge);
    }
    for (const auto& triangle : surface.triangles) {
        triangles.push_back(triangles.size() + 1);
        for (const int corner : triangle) corners.push_back(static_cast<std::size_t>(corner) + 1);
    }
    gmsh::model::mesh::addNodes(2, sheet, numbers, coordinates);
    gmsh::model::mesh::addElementsByType(sheet, triangle_type, triangles, corners);
}

void mesh_anew() {
    // Folds inside the sheet are no edges of it: pi.
    gmsh::model::mesh::classifySurfaces(std::numbers::pi, true, true, corner_angle);
    gmsh::model::mesh::createGeometry();
    gmsh::option::setNumber("Mesh.MeshSizeMin", 1);
    gmsh::option::setNumber("Mesh.MeshSizeMax", 1);
    gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
    gmsh::option::setNumber("Mesh.Algorithm", frontal_delaunay);
    gmsh::model::mesh::generate(2);
}

TriangleSurface mesh_of_gmsh(double edge) {
    std::vector<std::size_t> tags, triangles, corners;
    std::vector<double> coordinates, parametric;
    gmsh::model::mesh::getNodes(tags, coordinates, parametric);
    std::map<std::size_t, Vec> position;
    for (std::size_t i = 0; i < tags.size(); ++i)
        position[tags[i]] = edge * Vec(coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]);
    gmsh::model::mesh::getElementsByType(triangle_type, triangles, corners);
    TriangleSurface surface;
    std::map<std::size_t, int> number;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto [found, is_new] = number.try_emplace(corners[k], static_cast<int>(surface.corners.size()));
        if (is_new) surface.corners.push_back(position.at(corners[k]));
        if (k % 3 == 0) surface.triangles.emplace_back();
        surface.triangles.back().at(k % 3) = found->second;
    }
    return surface;
}

}  // namespace

TriangleSurface remesh_surface(const TriangleSurface& surface, double edge) {
    if (!(edge > 0)) throw std::invalid_argument("remesh_surface: the edge must be positive");
    TriangleSurface given = surface;
    need_two_sides(orient_outward(given));
    TriangleSurface fine;
    {
        const GmshSession session;
        GmshSession::throw_on_error(true);
        try {
            hand_over(given, edge);
            mesh_anew();
            fine = mesh_of_gmsh(edge);
        } catch (const std::string& why) {
            throw InputError("gmsh cannot mesh a sheet anew: " + why, "draw it of simpler pieces, or finer");
        }
    }
    if (fine.triangles.empty())
        throw InputError("gmsh made no triangle of a sheet with edges this long", "refine particles.spacing");
    need_two_sides(orient_outward(fine));
    return fine;
}

}  // namespace dmp::geometry
