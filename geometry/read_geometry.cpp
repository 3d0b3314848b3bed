// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <gmsh.h>

#include "base/shell_word.hpp"
#include "geometry/cad_curves.hpp"
#include "geometry/cad_surfaces.hpp"
#include "geometry/geometry.hpp"
#include "geometry/geometry_file.hpp"
#include "geometry/gmsh_session.hpp"
#include "geometry/planar_area.hpp"
#include "geometry/read_cad.hpp"
#include "geometry/read_with_gmsh.hpp"
#include "geometry/select_faces.hpp"
#include "geometry/triangle_file.hpp"
#include "geometry/triangle_geometry.hpp"

namespace dmp::geometry {

namespace {

/// A named physical group of gmsh: the numbers of its points, curves, surfaces or volumes.
struct Group {
    std::string name;
    std::vector<int> tags;
};

const char* kind_of_group(int dimension) {
    constexpr const char* kinds[] = {"Physical Point", "Physical Curve", "Physical Surface", "Physical Volume"};
    return kinds[dimension];
}

std::vector<Group> groups_of(int dimension, const std::string& file) {
    gmsh::vectorpair found;
    gmsh::model::getPhysicalGroups(found, dimension);
    std::vector<Group> groups;
    for (const auto& [group_dimension, tag] : found) {
        Group group;
        gmsh::model::getPhysicalName(dimension, tag, group.name);
        gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, group.tags);
        if (group.name.empty()) {
            const std::string kind = kind_of_group(dimension);
            throw InputError({.file = file}, kind + " " + std::to_string(tag) + " has no name",
                             "Name it, as in " + kind + "(\"wall\") = {...};, or remove it.");
        }
        for (int& entity : group.tags) entity = std::abs(entity);  // the sign is a direction
        std::ranges::sort(group.tags);
        groups.push_back(std::move(group));
    }
    return groups;
}

Solid solid_of(const Group& group, const CadSurfaces& drawn, const std::string& file) {
    Solid solid{.name = group.name, .surface = drawn.boundary(group.tags)};
    const std::string problem = why_open(solid.name, solid.surface, file);
    if (!problem.empty())
        throw InputError({.file = file}, "solid '" + group.name + "' is not closed: " + problem,
                         "Check the geometry, or the parameters it was given.");
    return solid;
}

Geometry read_in_space(const GeometryOptions& options) {
    Geometry geometry;
    geometry.file = options.file;
    geometry.dimension = 3;
    const auto volumes = groups_of(3, options.file), surfaces = groups_of(2, options.file);
    const auto points = groups_of(0, options.file);
    if (volumes.empty())
        throw InputError(
            {.file = options.file}, "the geometry has volumes, but none with a name",
            "Name its parts, as in Physical Volume(\"blood\") = {1}; and Physical Surface(\"wall\") = {2};.");
    const CadSurfaces drawn(options);
    for (const auto& group : volumes) geometry.solids.push_back(solid_of(group, drawn, options.file));
    for (const auto& group : surfaces)
        geometry.surfaces.push_back({.name = group.name, .surface = drawn.surfaces(group.tags)});
    for (const auto& group : points)
        for (const int tag : group.tags) geometry.points[group.name].push_back(drawn.point(tag));
    geometry.box = box_in_space(geometry);
    geometry.warnings = GmshSession::logged("Warning");
    return geometry;
}

Geometry read_open_geometry(const GeometryOptions& options) {
    gmsh::vectorpair volumes;
    gmsh::model::getEntities(volumes, 3);
    if (!volumes.empty()) return read_in_space(options);
    Geometry geometry;
    geometry.file = options.file;
    CadCurves curves(options);
    for (const auto& group : groups_of(2, options.file)) {
        geometry.regions.push_back(planar_area(group.name, group.tags, curves, options.file));
    }
    for (const auto& group : groups_of(1, options.file)) {
        geometry.curves.push_back(curves.set(group.name, group.tags));
    }
    for (const auto& group : groups_of(0, options.file)) {
        for (const int tag : group.tags) geometry.points[group.name].push_back(curves.point(tag));
    }
    if (geometry.names().empty()) {
        throw InputError(
            {.file = options.file}, "the geometry has no named groups",
            "Name its parts, as in Physical Surface(\"blood\") = {1}; or Physical Curve(\"wall\") = {2, 3};");
    }
    lay_flat(geometry);
    geometry.warnings = GmshSession::logged("Warning");
    return geometry;
}

Geometry read_what_is_open(const GeometryOptions& options) {
    if (is_cad_file(options.file)) return read_open_cad(options);
    Geometry geometry = read_open_geometry(options);
    geometry.unit = options.metres();
    geometry.unit_source = options.unit ? UnitSource::scene : UnitSource::assumed;
    return geometry;
}

}  // namespace

Geometry read_with_gmsh(const GeometryOptions& options, const GeometrySource& source,
                        const std::function<void(const char*)>& stage) {
    stage("it was reading the file");
    const auto session = open_geometry(options, source);
    stage("it was dividing curves and faces, to within the chord error");
    try {
        Geometry geometry = read_what_is_open(options);
        for (std::string& warning : geometry.warnings) warning = source.in_users_words(warning);
        return geometry;
    } catch (const std::string& message) {  // gmsh throws its messages as they are
        throw InputError({.file = options.file}, "gmsh cannot follow the geometry: " + source.in_users_words(message),
                         "Correct the geometry; " + quoted_command("gmsh", options.file) + " shows it.");
    }
}

Geometry read_geometry(const GeometryOptions& options) {
    check_geometry_file(options);
    Geometry geometry = is_triangle_file(options.file)
                            ? read_triangle_geometry(options)
                            : read_with_gmsh(options, GeometrySource(options), [](const char* /*stage*/) {});
    select_faces(geometry, options.selections);
    return geometry;
}

}  // namespace dmp::geometry
