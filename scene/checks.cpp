// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/checks.hpp"

#include <algorithm>
#include <vector>

#include "base/nearest_name.hpp"
#include "scene/quantity.hpp"

namespace dmp {

namespace {

/// The first of the places that points somewhere, else the scene file as a whole.
Place first_known(const Scene& scene, std::initializer_list<const Place*> places) {
    for (const Place* place : places) {
        if (place != nullptr && place->known()) return *place;
    }
    return {scene.file, 0, 0};
}

const Place* place_of(const TomlNode& document, const char* path) {
    const TomlNode* node = document.find(path);
    return node == nullptr ? nullptr : &node->place;
}

template <class Item>
void refuse_equal_names(const std::vector<Item>& items, const std::string& what) {
    for (std::size_t i = 1; i < items.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (*items[i].name != *items[j].name) continue;
            throw InputError(
                items[i].name.place,
                "there is already a " + what + " called '" + *items[i].name + "', at " + items[j].name.place.text(),
                "give each " + what + " its own name");
        }
    }
}

void need_something_to_move(const Scene& scene) {
    if (!scene.parts_of(PartKind::fluid).empty() || !scene.parts_of(PartKind::springs).empty()) return;
    const Place place = scene.parts.empty() ? Place{scene.file, 0, 0} : scene.parts.front().kind.place;
    throw InputError(first_known(scene, {&place}),
                     "no enabled part is of kind 'fluid' or 'springs': nothing would move",
                     "add a [[part]] with kind = \"fluid\" or kind = \"springs\"");
}

void need_largest_speed(const Scene& scene, const TomlNode& document) {
    const bool automatic = *scene.accuracy.sound_speed == 0;
    if (!automatic || *scene.flow.largest_speed > 0 || scene.parts_of(PartKind::fluid).empty()) return;
    throw InputError(first_known(scene, {&scene.accuracy.sound_speed.place, place_of(document, "flow")}),
                     "flow.largest_speed is missing: accuracy.sound_speed = \"auto\" is 10 times that speed",
                     "add largest_speed = \"0.2 m/s\" (the largest speed you expect) to [flow], or give a sound_speed");
}

void need_axis_in_space(const Scene& scene) {
    if (scene.dimension == 3 || !*scene.flow.periodic[2]) return;
    throw InputError(scene.flow.periodic[2].place, "flow.periodic: a scene in the plane has no axis 'z'",
                     "give 'x' and 'y' only, or write dimension = 3");
}

/// A fluid particle at the wall must not see past the wall's last row.
void need_thick_walls(const Scene& scene) {
    if (scene.parts_of(PartKind::fluid).empty()) return;
    for (const Part* wall : scene.parts_of(PartKind::rigid)) {
        if (*wall->layers >= *scene.accuracy.support) continue;
        throw InputError(first_known(scene, {&wall->layers.place, &scene.accuracy.support.place}),
                         "the wall '" + *wall->name +
                             "' is thinner than the kernel: layers = " + std::to_string(*wall->layers) +
                             ", accuracy.support = " + exact_text(scene.accuracy.support),
                         "give the part at least as many layers as the support has spacings");
    }
}

void need_plane_formulas(const std::string& key, const Expression& third, const TomlNode& document) {
    const TomlNode* list = document.find(key);
    if (list == nullptr || list->children.size() < 3) return;
    if (third.is_zero()) return;
    throw InputError(list->children[2].place, key + " has a third component in a 2-D scene",
                     "leave it out, or write 0");
}

void need_plane_point(const Value<Vec>& point) {
    if ((*point)[2] == 0) return;
    throw InputError(point.place, "the third coordinate of a point in a 2-D scene is not 0",
                     "leave it out, or write 0");
}

void check_region(const Scene& scene, const ResidenceRegion& region) {
    for (const auto* point : {&region.from, &region.to}) {
        if (scene.dimension == 2) need_plane_point(*point);
    }
    for (int axis = 0; axis < scene.dimension; ++axis) {
        if ((*region.from)[axis] != (*region.to)[axis]) continue;
        throw InputError(region.to.place,
                         "the corners of region '" + *region.name + "' have the same " + "xyz"[axis] +
                             ": there is nothing between them",
                         "give two opposite corners of a box");
    }
}

/// Residence times are of regions.
void need_regions(const Scene& scene, const TomlNode& document) {
    const bool pictured = *scene.output.picture_field == FluidField::residence_time;
    if (pictured && scene.regions.size() > 1) {
        throw InputError(first_known(scene, {&scene.output.picture_field.place}),
                         "output.picture_field = \"residence_time\": there are several regions, and one array for each",
                         "leave one [[region]], or picture another field");
    }
    if (!scene.regions.empty() || !(pictured || scene.asks_for(FluidField::residence_time))) return;
    const Place* of_probe = nullptr;
    for (const Measure& measure : scene.measures) {
        if (*measure.field == FluidField::residence_time) of_probe = &measure.field.place;
    }
    throw InputError(
        first_known(scene, {of_probe, place_of(document, "output.fields"), &scene.output.picture_field.place}),
        "'residence_time' is asked for, and the scene has no region in which to follow it",
        "add a [[region]] with a name and the corners from and to");
}

void need_plane_walls(const Scene& scene) {
    for (const Part* wall : scene.parts_of(PartKind::rigid))
        if (!wall->surface_velocity.value[2].is_zero())
            throw InputError(wall->surface_velocity.place,
                             "surface_velocity of '" + *wall->name + "' has a third component in a 2-D scene",
                             "leave it out, or write 0");
}

/// What a scene starts from is taken once.
void need_start_without_time(const Scene& scene) {
    const auto need = [](const std::string& key, const Expression& formula, const Place& place) {
        if (!formula.depends_on_time()) return;
        throw InputError(place, key + " depends on t: \"" + formula.text() + "\"",
                         "write a formula of x, y and z; a start has no time");
    };
    for (const Expression& axis : *scene.flow.initial_velocity)
        need("flow.initial_velocity", axis, scene.flow.initial_velocity.place);
    need("flow.initial_pressure", scene.flow.initial_pressure, scene.flow.initial_pressure.place);
}

void check_measure(const Scene& scene, const Measure& measure) {
    for (const auto* point : {&measure.from, &measure.to, &measure.point}) {
        need_plane_point(*point);
    }
    if (*measure.kind == MeasureKind::flux && *measure.from == *measure.to) {
        throw InputError(measure.to.place,
                         "the line of measure '" + *measure.name + "' starts and ends at the same point",
                         "give two different points");
    }
    if (*measure.kind != MeasureKind::gap) return;
    std::vector<std::string> springs;
    for (const auto& part : scene.parts) {
        if (*part.kind == PartKind::springs) springs.push_back(part.name);
    }
    if (std::find(springs.begin(), springs.end(), *measure.part) != springs.end()) return;
    const auto nearest = nearest_name(*measure.part, springs);
    const auto other = std::find_if(scene.parts.begin(), scene.parts.end(),
                                    [&](const Part& part) { return *part.name == *measure.part; });
    const std::string what = other == scene.parts.end() ? "the scene has no part '" + *measure.part + "'"
                                                        : "part '" + *measure.part + "' is of kind '" +
                                                              word(*other->kind) + "', expected 'springs'";
    throw InputError(measure.part.place, what,
                     nearest.empty() ? "a gap is measured between the pieces of a springs part; the scene has " +
                                           quoted_list(springs)
                                     : "did you mean '" + nearest + "'?");
}

}  // namespace

void check_scene(const Scene& scene, const TomlNode& document) {
    refuse_equal_names(scene.parts, "part");
    refuse_equal_names(scene.regions, "region");
    refuse_equal_names(scene.measures, "measure");
    need_something_to_move(scene);
    need_largest_speed(scene, document);
    need_axis_in_space(scene);
    need_thick_walls(scene);
    need_plane_formulas("flow.acceleration", scene.flow.acceleration[2], document);
    need_plane_formulas("flow.initial_velocity", (*scene.flow.initial_velocity)[2], document);
    need_start_without_time(scene);
    need_plane_walls(scene);
    need_regions(scene, document);
    for (const auto& region : scene.regions) check_region(scene, region);
    for (const auto& measure : scene.measures) check_measure(scene, measure);
}

}  // namespace dmp
