// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/nearest_name.hpp"
#include "scene/driving_keys.hpp"
#include "scene/join_keys.hpp"
#include "scene/measure_checks.hpp"
#include "scene/numerics_checks.hpp"
#include "scene/quantity.hpp"
#include "scene/reference_checks.hpp"
#include "scene/schema.hpp"
#include "scene/solidify_checks.hpp"
#include "scene/species_checks.hpp"
#include "scene/sphere_checks.hpp"
#include "scene/spring_checks.hpp"

namespace dmp::scene {

SourceLocation first_known(const Scene& scene, std::initializer_list<const SourceLocation*> places) {
    for (const SourceLocation* location : places) {
        if (location != nullptr && location->known()) return *location;
    }
    return {scene.file, 0, 0};
}

namespace {

template <class Item>
void refuse_equal_names(const std::vector<Item>& items, const std::string& what) {
    for (std::size_t i = 1; i < items.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (*items[i].name != *items[j].name) continue;
            throw InputError(
                items[i].name.location,
                "there is already a " + what + " called '" + *items[i].name + "', at " + items[j].name.location.text(),
                "give each " + what + " its own name");
        }
    }
}

void need_something_to_move(const Scene& scene) {
    for (const PartKind kind : {PartKind::fluid, PartKind::elastic, PartKind::spheres})
        if (!scene.parts_of(kind).empty()) return;
    const SourceLocation location =
        scene.parts.empty() ? SourceLocation{scene.file, 0, 0} : scene.parts.front().kind.location;
    throw InputError(first_known(scene, {&location}),
                     "no enabled part is of kind 'fluid', 'elastic' or 'spheres': nothing would move",
                     "add a [[part]] with kind = \"fluid\", \"elastic\" or \"spheres\"");
}

/// Parts other than spheres and their walls need a geometry and a particle spacing.
void check_parts_with_geometry(const Scene& scene, const TomlNode& document) {
    const auto has_geometry = [](const Part& part) {
        return *part.kind != PartKind::spheres && !part.is_wall_for_spheres();
    };
    const auto need = [&](bool given, const char* section, const std::string& key) {
        if (given) return;
        const SourceLocation* table = document.location_of(section);
        const auto facts = schema().facts();
        const auto found = std::ranges::find(facts, key, &KeyFacts::path);
        throw InputError(first_known(scene, {table}), "missing key: " + key,
                         "add " + shown_key(key) + ": " + found->type);
    };
    if (std::ranges::any_of(scene.parts, has_geometry) || scene.parts.empty()) {
        need(!scene.geometry.file->empty(), "geometry", "geometry.file");
        need(*scene.particles.spacing > 0, "particles", "particles.spacing");
    } else if (scene.geometry.file.given()) {
        throw InputError(scene.geometry.file.location, "geometry.file: no part of the scene uses a geometry",
                         "leave [geometry] out");
    }
}

void need_largest_speed(const Scene& scene, const TomlNode& document) {
    const bool automatic = *scene.numerics.sound_speed == 0;
    if (!automatic || *scene.flow.largest_speed > 0 || scene.parts_of(PartKind::fluid).empty()) return;
    throw InputError(first_known(scene, {&scene.numerics.sound_speed.location, document.location_of("flow")}),
                     "flow.largest_speed is missing: numerics.sound_speed = \"auto\" depends on it",
                     "add largest_speed = \"0.2 m/s\" (the largest speed you expect) to [flow], or give a sound_speed");
}

void need_lattice_for_disorder(const Scene& scene) {
    if (!(*scene.particles.disorder > 0) || *scene.particles.fill == FillKind::lattice) return;
    throw InputError(scene.particles.disorder.location,
                     "particles.disorder displaces particles from a lattice, which particles.fill = \"" +
                         to_string(*scene.particles.fill) + "\" does not keep",
                     "leave out disorder or fill");
}

void need_arrangement_in_plane(const Scene& scene) {
    if (scene.dimension == 3 || *scene.particles.arrangement != Arrangement::fcc) return;
    throw InputError(scene.particles.arrangement.location, "particles.arrangement: \"fcc\" is a lattice in 3-D",
                     "write \"square\" or \"hexagonal\", or dimension = 3");
}

void need_axis_in_space(const Scene& scene) {
    if (scene.dimension == 3 || !*scene.flow.periodic[2]) return;
    throw InputError(scene.flow.periodic[2].location, "flow.periodic: a scene in 2-D has no axis 'z'",
                     "give 'x' and 'y' only, or write dimension = 3");
}

/// The kernel of a fluid particle at the wall must not reach beyond the wall's last row.
void need_thick_walls(const Scene& scene) {
    if (scene.parts_of(PartKind::fluid).empty()) return;
    for (const Part* wall : scene.parts_of(PartKind::rigid)) {
        if (*wall->layers >= *scene.numerics.support) continue;
        throw InputError(first_known(scene, {&wall->layers.location, &scene.numerics.support.location}),
                         "the wall '" + *wall->name +
                             "' is thinner than the kernel: layers = " + std::to_string(*wall->layers) +
                             ", numerics.support = " + exact_text(scene.numerics.support),
                         "give the part at least as many layers as the support has spacings");
    }
}

void need_plane_formulas(const std::string& key, const Expression& third, const TomlNode& document) {
    const TomlNode* list = document.find(key);
    if (list == nullptr || list->children.size() < 3) return;
    if (third.is_zero()) return;
    throw InputError(list->children[2].location, key + " has a third component in a 2-D scene",
                     "leave it out, or write 0");
}

void need_plane_walls(const Scene& scene) {
    const auto need_plane = [](const Part& wall, const auto& formulas, const std::string& key) {
        if (!formulas.value[2].is_zero())
            throw InputError(formulas.location, key + " of '" + *wall.name + "' has a third component in a 2-D scene",
                             "leave it out, or write 0");
    };
    for (const Part* wall : scene.parts_of(PartKind::rigid)) {
        need_plane(*wall, wall->surface_velocity, "surface_velocity");
        need_plane(*wall, wall->velocity, "velocity");
    }
}

/// A rigid part moves as a whole, and slip needs extrapolated walls.
void check_walls(const Scene& scene) {
    for (const Part* wall : scene.parts_of(PartKind::rigid)) {
        const bool bends = std::ranges::any_of(wall->velocity.value, &Expression::depends_on_position);
        if (bends || wall->spin->depends_on_position())
            throw InputError((bends ? wall->velocity.location : wall->spin.location),
                             std::string(bends ? "velocity" : "spin") + " of the rigid part '" + *wall->name +
                                 "' depends on x, y or z: it would not stay rigid",
                             "give formulas of t; for a surface that slides along itself use surface_velocity");
        if (wall->slip && *scene.numerics.walls == WallModel::plain)
            throw InputError(first_known(scene, {&wall->slip.location, &scene.numerics.walls.location}),
                             "the wall '" + *wall->name + "' has slip = true, and plain walls cannot let a fluid slip",
                             "write numerics.walls = \"extrapolated\", or leave out slip");
        if (wall->slip && wall->slides())
            throw InputError(first_known(scene, {&wall->surface_velocity.location, &wall->slip.location}),
                             "the surface of '" + *wall->name +
                                 "' slides, but the fluid slips on it: the motion would have no effect",
                             "leave out surface_velocity, or slip");
    }
}

/// A mean gradient of the pressure needs a liquid, and an axis along which the scene repeats; it is the same
/// everywhere.
void check_pressure_gradient(const Scene& scene, const TomlNode& document) {
    const auto& gradient = scene.flow.pressure_gradient;
    const TomlNode* list = document.find("flow.pressure_gradient");
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Expression& along = (*gradient)[axis];
        if (along.is_zero()) continue;
        const bool written = list != nullptr && axis < list->children.size();
        const SourceLocation at = written ? list->children[axis].location : gradient.location;
        if (scene.parts_of(PartKind::fluid).empty())
            throw InputError(at, "flow.pressure_gradient drives a fluid, and no part is one",
                             "leave it out, or push with flow.acceleration or a [[force]]");
        if (!*scene.flow.periodic[axis])
            throw InputError(at,
                             std::string("flow.pressure_gradient acts along ") + "xyz"[axis] +
                                 ", which is not periodic: walls there balance it, and nothing flows",
                             std::string("add \"") + "xyz"[axis] +
                                 "\" to flow.periodic, or leave the component out; gravity is flow.acceleration");
        if (along.depends_on_position())
            throw InputError(at, "flow.pressure_gradient depends on x, y or z: \"" + along.text() + "\"",
                             "write formulas of t: it is the mean over the period; a force that depends on position is "
                             "flow.acceleration or a [[force]]");
    }
}

/// An axis is either periodic or has planes of symmetry, and no force may act across such a plane.
void check_symmetry(const Scene& scene) {
    if (!scene.flow.symmetry->empty() && *scene.numerics.gradient_correction)
        throw InputError(
            first_known(scene, {&scene.numerics.gradient_correction.location, &scene.flow.symmetry.location}),
            "numerics.gradient_correction does not support planes of symmetry (flow.symmetry)",
            "leave out one of them");
    for (const BoxSide side : *scene.flow.symmetry) {
        const int axis = axis_of(side);
        if (axis == 2 && scene.dimension == 2)
            throw InputError(scene.flow.symmetry.location,
                             "flow.symmetry: a scene in 2-D has no side '" + to_string(side) + "'",
                             "give sides across x and y only, or write dimension = 3");
        if (*scene.flow.periodic[axis])
            throw InputError(first_known(scene, {&scene.flow.symmetry.location, &scene.flow.periodic[axis].location}),
                             "flow.symmetry: '" + to_string(side) + "' is perpendicular to a periodic axis",
                             "remove the axis from flow.periodic, or the side from flow.symmetry");
        const Expression& across = scene.flow.acceleration[axis];
        if (!across.is_zero() && !across.depends_on_position())
            throw InputError(first_known(scene, {&scene.flow.symmetry.location}),
                             "flow.acceleration pushes across the plane of symmetry '" + to_string(side) +
                                 "': the two sides would not be alike",
                             "leave out that component, or the side");
    }
}

/// Initial values must not depend on time.
void need_start_without_time(const Scene& scene) {
    const auto need = [](const std::string& key, const Expression& formula, const SourceLocation& location) {
        if (!formula.depends_on_time()) return;
        throw InputError(location, key + " depends on t: \"" + formula.text() + "\"",
                         "write a formula of x, y and z: initial values do not depend on time");
    };
    for (const Expression& axis : *scene.flow.initial_velocity)
        need("flow.initial_velocity", axis, scene.flow.initial_velocity.location);
    need("flow.initial_pressure", scene.flow.initial_pressure, scene.flow.initial_pressure.location);
}

/// A selection of faces, in 2-D of curves, needs at least one criterion.
void check_selection(const Scene& scene, const Selection& selection) {
    const std::string name = "selection '" + *selection.name + "'";
    if (scene.dimension == 2 && selection.z.given())
        throw InputError(selection.z.location, name + " gives z, but the scene is 2-D",
                         "remove z, or write dimension = 3");
    if (selection.from.given() != selection.to.given())
        throw InputError(first_known(scene, {&selection.from.location, &selection.to.location}),
                         name + " has one corner of a box only", "give from and to");
    const bool by_position =
        selection.x.given() || selection.y.given() || selection.z.given() || selection.from.given();
    if (!by_position && !selection.normal.given() && !selection.except.given())
        throw InputError(selection.name.location, name + " does not say which faces",
                         "give a plane (x, y or z), a box (from and to), a normal, or except");
    // The default angle is allowed, because resolved scenes contain it.
    const bool own_angle = selection.angle.given() && std::abs(selection.angle - std::numbers::pi / 18) > 1e-9;
    if (own_angle && !selection.normal.given())
        throw InputError(selection.angle.location, name + " has an angle but no normal", "give normal");
    // Other names may be those of surfaces or curves of the geometry.
    for (const std::string& other : *selection.except) {
        const auto found = std::ranges::find(scene.selections, other, [](const Selection& one) { return *one.name; });
        if (found == scene.selections.end() || &*found < &selection) continue;
        throw InputError(selection.except.location, name + ": there is no selection '" + other + "' before it",
                         "define [[select]] '" + other + "' first, or correct the name");
    }
}

}  // namespace

void check_scene(const Scene& scene, const TomlNode& document) {
    refuse_equal_names(scene.parts, "part");
    refuse_equal_names(scene.selections, "select");
    for (const auto& selection : scene.selections) check_selection(scene, selection);
    refuse_equal_names(scene.joins, "join");
    refuse_equal_names(scene.species, "species");
    refuse_equal_names(scene.regions, "region");
    refuse_equal_names(scene.measures, "measure");
    refuse_equal_names(scene.solidify, "solidify");
    refuse_equal_names(scene.breaking, "break");
    need_something_to_move(scene);
    check_parts_with_geometry(scene, document);
    check_spheres(scene, document);
    check_driving(scene);
    need_largest_speed(scene, document);
    check_numerics(scene);
    need_axis_in_space(scene);
    need_arrangement_in_plane(scene);
    need_lattice_for_disorder(scene);
    need_thick_walls(scene);
    if (scene.dimension == 2) {
        need_plane_formulas("flow.acceleration", scene.flow.acceleration[2], document);
        need_plane_formulas("flow.pressure_gradient", (*scene.flow.pressure_gradient)[2], document);
        need_plane_formulas("flow.initial_velocity", (*scene.flow.initial_velocity)[2], document);
        need_plane_walls(scene);
    }
    need_start_without_time(scene);
    check_walls(scene);
    check_symmetry(scene);
    check_pressure_gradient(scene, document);
    check_regions(scene, document);
    check_species(scene);
    check_elastic(scene);
    check_joins(scene);
    check_measures(scene);
    check_references(scene);
    check_solidify(scene);
}

}  // namespace dmp::scene
