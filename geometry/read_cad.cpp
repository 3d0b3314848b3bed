// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/read_cad.hpp"

#include <algorithm>
#include <utility>

#include <gmsh.h>

#include "geometry/drawing_file.hpp"
#include "geometry/drawn_surfaces.hpp"
#include "geometry/gmsh_session.hpp"
#include "geometry/triangle_drawing.hpp"

namespace dmp {

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

std::vector<Named> named_bodies(const std::vector<int>& volumes, const std::string& file) {
    std::vector<Named> bodies;
    int number = 0;
    for (const int tag : volumes) {
        ++number;
        std::string name = name_of(3, tag);
        if (name.empty()) name = volumes.size() == 1 ? name_of_file(file) : "solid_" + std::to_string(number);
        add(bodies, name, tag);
    }
    return bodies;
}

/// Faces that have a name other than a body's, which faces inherit.
std::vector<Named> named_faces(const std::vector<Named>& bodies) {
    std::vector<Named> faces;
    for (const int tag : tags_of(2)) {
        const std::string name = name_of(2, tag);
        if (!name.empty() && std::ranges::find(bodies, name, &Named::name) == bodies.end()) add(faces, name, tag);
    }
    return faces;
}

Box box_in_the_file() {
    Box box;
    gmsh::model::getBoundingBox(-1, -1, box.low.x(), box.low.y(), box.low.z(), box.high.x(), box.high.y(),
                                box.high.z());
    return box;
}

}  // namespace

Geometry read_open_cad(const DrawingOptions& asked) {
    DrawingOptions options = asked;
    const bool stated = states_its_unit(asked.file);
    if (tags_of(2).empty())
        throw InputError({.file = asked.file}, "the drawing has no bodies and no faces",
                         "Check that it is whole, and export the bodies themselves, as solids.");
    if (!stated && !asked.unit) throw missing_unit(asked, box_in_the_file());
    if (stated) options.unit = millimetre;
    Geometry geometry;
    geometry.file = asked.file;
    geometry.dimension = 3;
    geometry.unit = options.metres();
    geometry.unit_source = stated ? UnitSource::file : UnitSource::scene;
    const std::vector<int> volumes = tags_of(3);
    const std::vector<Named> bodies = named_bodies(volumes, asked.file);
    const DrawnSurfaces drawn(options);
    for (const Named& body : bodies) {
        Solid solid{.name = body.name, .surface = drawn.boundary(body.tags)};
        const std::string problem = why_open(solid.name, solid.surface, asked.file);
        if (!problem.empty())
            throw InputError({.file = asked.file}, "solid '" + body.name + "' is not closed: " + problem,
                             "Repair the body in the program that made it, and export it again.");
        geometry.solids.push_back(std::move(solid));
    }
    for (const Named& face : named_faces(bodies))
        geometry.surfaces.push_back({face.name, drawn.surfaces(face.tags), {}});
    if (bodies.empty())
        geometry.surfaces.push_back(
            {name_of_file(asked.file), drawn.surfaces(tags_of(2)), "the file has faces only, and no closed body"});
    geometry.box = box_in_space(geometry);
    geometry.warnings = GmshSession::logged("Warning");
    return geometry;
}

}  // namespace dmp
