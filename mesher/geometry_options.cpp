// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/geometry_options.hpp"

#include <array>
#include <filesystem>

namespace dmp::mesher {

namespace {

constexpr double chord_error_in_plane = 1e-3, chord_error_in_space = 5e-3;  // [spacings]

FaceSelection selection_of(const Selection& asked) {
    FaceSelection selection{
        .name = asked.name, .of = asked.of, .except = asked.except, .location = asked.name.location};
    const std::array<const Value<double>*, 3> planes{&asked.x, &asked.y, &asked.z};
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (planes.at(axis)->given()) selection.in_plane.at(axis) = **planes.at(axis);
    if (asked.from.given()) selection.in_box = Box{.low = asked.from, .high = asked.to};
    if (asked.normal.given()) selection.normal = *asked.normal;
    selection.angle = asked.angle;
    return selection;
}

}  // namespace

GeometryOptions geometry_options_of(const Scene& scene) {
    const std::filesystem::path file = *scene.geometry.file;
    GeometryOptions options;
    options.file = file.is_absolute() ? file.string() : (std::filesystem::path(scene.directory) / file).string();
    if (scene.geometry.unit.given()) options.unit = *scene.geometry.unit;
    options.chord_error =
        (scene.dimension == 3 ? chord_error_in_space : chord_error_in_plane) * scene.particles.spacing;
    options.location = scene.geometry.file.location;
    for (const auto& [name, value] : scene.geometry.parameters) {
        options.parameters[name] = value;
        options.parameter_locations[name] = value.location;
    }
    for (const Selection& selection : scene.selections) options.selections.push_back(selection_of(selection));
    return options;
}

}  // namespace dmp::mesher
