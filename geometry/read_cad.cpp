// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/read_cad.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <gmsh.h>

#include "base/disjoint_sets.hpp"
#include "geometry/cad_curves.hpp"
#include "geometry/cad_surfaces.hpp"
#include "geometry/geometry_file.hpp"
#include "geometry/gmsh_session.hpp"
#include "geometry/planar_area.hpp"
#include "geometry/triangle_geometry.hpp"

namespace dmp::geometry {

namespace {

constexpr double millimetre = 1e-3;

/// Bodies or faces of one name.
struct Named {
    std::string name;
    std::vector<int> tags;
};

/// The name of a body or face, the last of its path "Shapes/assembly/part"; empty: none.
std::string name_of(int dimension, int tag) {
    std::string path;
    gmsh::model::getEntityName(dimension, tag, path);
    return plain_name(path.substr(path.rfind('/') + 1));
}

std::vector<int> tags_of(int dimension) {
    gmsh::vectorpair entities;
    gmsh::model::getEntities(entities, dimension);
    std::vector<int> tags;
    for (const auto& [same, tag] : entities) tags.push_back(tag);
    return tags;
}

void add(std::vector<Named>& all, const std::string& name, int tag) {
    auto found = std::ranges::find(all, name, &Named::name);
    if (found == all.end()) found = all.insert(all.end(), {name, {}});
    found->tags.push_back(tag);
}

/// Bodies, or faces, all with a name: their own, else the file's where there is one only, else `kind` and a number.
std::vector<Named> all_named(int dimension, const std::vector<int>& tags, const std::string& kind,
                             const std::string& file) {
    std::vector<Named> all;
    int number = 0;
    for (const int tag : tags) {
        ++number;
        std::string name = name_of(dimension, tag);
        if (name.empty()) name = tags.size() == 1 ? name_of_file(file) : kind + "_" + std::to_string(number);
        add(all, name, tag);
    }
    return all;
}

/// Faces that have a name other than a body's, which faces inherit; edges likewise of faces.
std::vector<Named> named_sides(int dimension, const std::vector<Named>& bodies) {
    std::vector<Named> sides;
    for (const int tag : tags_of(dimension)) {
        const std::string name = name_of(dimension, tag);
        if (!name.empty() && std::ranges::find(bodies, name, &Named::name) == bodies.end()) add(sides, name, tag);
    }
    return sides;
}

/// Curves that bound no face and have no name.
std::vector<int> loose_curves() {
    std::vector<int> loose;
    for (const int tag : tags_of(1)) {
        std::vector<int> faces, ends;
        gmsh::model::getAdjacencies(1, tag, faces, ends);
        if (faces.empty() && name_of(1, tag).empty()) loose.push_back(tag);
    }
    return loose;
}

/// Faces that bound no body and have no name of their own, in connected pieces: face_1, ...
std::vector<Named> loose_faces(const std::vector<Named>& bodies, const std::vector<Named>& named) {
    std::vector<int> loose;
    std::map<int, std::vector<std::size_t>> at_curve;  // which of them it bounds
    for (const int tag : tags_of(2)) {
        std::vector<int> volumes, curves;
        gmsh::model::getAdjacencies(2, tag, volumes, curves);
        const auto has = [&](const Named& each) { return std::ranges::find(each.tags, tag) != each.tags.end(); };
        if (!volumes.empty() || std::ranges::any_of(named, has)) continue;
        for (const int curve : curves) at_curve[curve].push_back(loose.size());
        loose.push_back(tag);
    }
    DisjointSets together(loose.size());
    for (const auto& [curve, faces] : at_curve)
        for (const std::size_t face : faces) together.join(faces.front(), face);
    std::map<std::size_t, std::vector<int>> pieces;
    for (std::size_t k = 0; k < loose.size(); ++k) pieces[together.find(k)].push_back(loose[k]);
    std::vector<Named> all;
    int number = 0;
    for (auto& [first, tags] : pieces) {
        std::string name;
        const auto is_taken = [&](const Named& each) { return each.name == name; };
        do name = "face_" + std::to_string(++number);
        while (std::ranges::any_of(bodies, is_taken) || std::ranges::any_of(named, is_taken));
        all.push_back({std::move(name), std::move(tags)});
    }
    return all;
}

Box box_in_the_file() {
    Box box;
    gmsh::model::getBoundingBox(-1, -1, box.low.x(), box.low.y(), box.low.z(), box.high.x(), box.high.y(),
                                box.high.z());
    return box;
}

/// Faces without bodies that all lie in z = 0 are areas of the plane.
bool lies_in_the_plane() {
    if (!tags_of(3).empty()) return false;
    const Box box = box_in_the_file();  // a little larger than what is in it
    const Vec extent = box.extent();
    constexpr double flat = 1e-6;
    return std::max(-box.low.z(), box.high.z()) <= flat * std::max(extent.x(), extent.y());
}

void read_areas(Geometry& geometry, const GeometryOptions& options) {
    geometry.dimension = 2;
    CadCurves curves(options);
    const std::vector<Named> areas = all_named(2, tags_of(2), "area", options.file);
    for (const Named& area : areas) geometry.regions.push_back(planar_area(area.name, area.tags, curves, options.file));
    for (const Named& side : named_sides(1, areas)) geometry.curves.push_back(curves.set(side.name, side.tags));
    int number = 0;
    for (const int tag : loose_curves())
        geometry.curves.push_back(curves.set("curve_" + std::to_string(++number), {tag}));
    lay_flat(geometry);
    geometry.warnings = GmshSession::logged("Warning");
}

}  // namespace

Geometry read_open_cad(const GeometryOptions& asked) {
    GeometryOptions options = asked;
    const bool stated = states_its_unit(asked.file);
    if (tags_of(2).empty())
        throw InputError({.file = asked.file}, "the geometry has no bodies and no faces",
                         "Check that it is whole, and export the bodies themselves, as solids.");
    if (!stated && !asked.unit) throw missing_unit(asked, box_in_the_file());
    if (stated) options.unit = millimetre;
    Geometry geometry;
    geometry.file = asked.file;
    geometry.dimension = 3;
    geometry.unit = options.metres();
    geometry.unit_source = stated ? UnitSource::file : UnitSource::scene;
    if (lies_in_the_plane()) {
        read_areas(geometry, options);
        return geometry;
    }
    const std::vector<Named> bodies = all_named(3, tags_of(3), "solid", asked.file);
    const CadSurfaces drawn(options);
    for (const Named& body : bodies) {
        Solid solid{.name = body.name, .surface = drawn.boundary(body.tags)};
        const std::string problem = why_open(solid.name, solid.surface, asked.file);
        if (!problem.empty())
            throw InputError({.file = asked.file}, "solid '" + body.name + "' is not closed: " + problem,
                             "Repair the body in the program that made it, and export it again.");
        geometry.solids.push_back(std::move(solid));
    }
    const std::vector<Named> sides = named_sides(2, bodies);
    for (const Named& face : sides) geometry.surfaces.push_back({face.name, drawn.surfaces(face.tags), {}});
    if (!bodies.empty())
        for (const Named& face : loose_faces(bodies, sides))
            geometry.surfaces.push_back({face.name, drawn.surfaces(face.tags), "it bounds no body of the file"});
    if (bodies.empty())
        geometry.surfaces.push_back(
            {name_of_file(asked.file), drawn.surfaces(tags_of(2)), "the file has faces only, and no closed body"});
    geometry.box = box_in_space(geometry);
    geometry.warnings = GmshSession::logged("Warning");
    return geometry;
}

}  // namespace dmp::geometry
