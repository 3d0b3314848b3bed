// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/driving_keys.hpp"

#include <algorithm>

#include "base/nearest_name.hpp"

namespace dmp::scene {

// Columns as in schema.cpp.
// clang-format off

std::vector<Key<ForceOnPart>> force_keys() {
    return {
        {"name", &ForceOnPart::name, name(), required, "Name of the force."},
        {"part", &ForceOnPart::part, name(), required,
         "Part on which the force acts: a fluid, an elastic solid or spheres."},
        {"force", &ForceOnPart::force, formulas("1 mN", PlacesKnown::now_and_at_start), required,
         "Force, as formulas of t, x, y, z and, on elastic parts, X, Y, Z: where a particle is now, and where it was in "
         "the initial state. In 2-D the part is 1 m deep."},
        {"amount", &ForceOnPart::amount, one_of<ForceAmount>(), required,
         "\"total\": the force on the whole part, spread over its particles by their volumes; \"per_particle\": the force on "
         "each particle."},
        {"from", &ForceOnPart::from, quantity("1 s", not_negative), "0", "Time at which the force starts."},
        {"until", &ForceOnPart::until, quantity("2 s", positive), not_given,
         "Time at which the force ends; never by default."},
        {"period", &ForceOnPart::period, quantity("4 s", positive), not_given,
         "Period after which the schedule repeats; no repetition by default."},
    };
}

std::vector<Key<MovingShape>> moving_shape_keys() {
    const Kinds all, parabola = {"parabola"}, circle = {"circle"};
    return {
        {"name", all, &MovingShape::name, name(), required, "Name of the shape."},
        {"kind", all, &MovingShape::kind, one_of<ShapeKind>(), required,
         "Shape: an arc of a parabola whose axis is parallel to y, or a circle; in 3-D it is the same for all z."},
        {"parts", all, &MovingShape::parts, names(), required,
         "Parts that the shape pushes: fluids, elastic solids or spheres. It does not affect other parts."},
        {"position", all, &MovingShape::position, formulas("1 mm"), required,
         "Position of the parabola's vertex or the circle's centre, as formulas of t; along periodic axes its "
         "nearest image acts."},
        {"half_width", parabola, &MovingShape::half_width, quantity("1 mm", positive), required,
         "Distance from the parabola's axis to its ends."},
        {"height", parabola, &MovingShape::height, quantity("1 mm"), required,
         "Height of the parabola's ends above its vertex; negative if it opens downward."},
        {"radius", circle, &MovingShape::radius, quantity("1 mm", positive), required, "Radius of the circle."},
        {"strength", all, &MovingShape::strength, quantity("1 uN", positive), required,
         "Strength K of the force K (1 + cos(pi d / range)) on each particle at distance d."},
        {"range", all, &MovingShape::range, quantity("0.2 mm", positive), required,
         "Distance beyond which there is no force."},
        {"side", all, &MovingShape::side, one_of<PushedSide>(), "both",
         "Side of the shape on which particles belong: \"both\" pushes them away from it on either side; \"inside\" "
         "(where the focus or centre is) and \"outside\" push particles on the wrong side back."},
        {"from", all, &MovingShape::from, quantity("1 s", not_negative), "0", "Time at which the shape appears."},
        {"until", all, &MovingShape::until, quantity("2 s", positive), not_given,
         "Time at which the shape disappears; never by default."},
        {"period", all, &MovingShape::period, quantity("4 s", positive), not_given,
         "Period after which the schedule repeats; no repetition by default."},
    };
}
// clang-format on

namespace {

void need_pushable(const Scene& scene, const SourceLocation& location, const std::string& name) {
    std::vector<std::string> can;
    const Part* part = scene.part_named(name);
    for (const Part& each : scene.parts) {
        const bool moves =
            *each.kind == PartKind::fluid || *each.kind == PartKind::elastic || *each.kind == PartKind::spheres;
        if (moves) can.push_back(*each.name);
    }
    if (part == nullptr) {
        const std::string nearest = nearest_name(name, can);
        throw InputError(
            location, "the scene has no part '" + name + "'",
            nearest.empty() ? "parts that can be pushed are " + quoted_list(can) : "did you mean '" + nearest + "'?");
    }
    if (std::ranges::find(can, name) == can.end())
        throw InputError(location,
                         "part '" + name + "' is of kind '" + to_string(*part->kind) +
                             "', whose motion is prescribed: no force acts on it",
                         "give the part a velocity, or name a part of kind 'fluid', 'elastic' or 'spheres'");
    if (!*part->enabled)
        throw InputError(location, "part '" + name + "' is not enabled", "enable it, or leave out what pushes it");
}

template <class Driver>
void check_schedule(const Driver& driver, const std::string& what) {
    if (driver.until.given() && *driver.until <= *driver.from)
        throw InputError(driver.until.location, what + " ends before it starts", "give an until that is after from");
    if (!driver.period.given()) return;
    if (!driver.until.given()) throw InputError(driver.period.location, what + " has a period but no end", "add until");
    if (*driver.period < *driver.until - *driver.from)
        throw InputError(driver.period.location, what + " repeats before it has ended",
                         "give a period of at least until - from");
}

/// Of liquids and spheres nobody knows where a particle was.
void check_initial_position(const Scene& scene, const ForceOnPart& force, const std::string& what) {
    const auto& formulas = *force.force;
    if (std::ranges::none_of(formulas, &Expression::depends_on_initial_position)) return;
    const PartKind kind = *scene.part_named(force.part)->kind;
    if (kind != PartKind::elastic)
        throw InputError(force.force.location,
                         what + " depends on X, Y or Z, and '" + *force.part + "', of kind '" + to_string(kind) +
                             "', has no rest coordinates",
                         "write x, y and z, the present place, or name an elastic part");
    const auto asks_for_z = [](const Expression& formula) { return formula.depends_on("Z"); };
    if (scene.dimension == 2 && std::ranges::any_of(formulas, asks_for_z))
        throw InputError(force.force.location, what + " depends on Z in a 2-D scene",
                         "write a formula of X and Y, or dimension = 3");
}

void check_force(const Scene& scene, const ForceOnPart& force) {
    const std::string what = "the force '" + *force.name + "'";
    need_pushable(scene, force.part.location, force.part);
    check_schedule(force, what);
    const auto& formulas = *force.force;
    if (scene.dimension == 2 && !formulas[2].is_zero())
        throw InputError(force.force.location, what + " has a third component in a 2-D scene",
                         "leave it out, or write 0");
    if (std::ranges::all_of(formulas, &Expression::is_zero))
        throw InputError(force.force.location, what + " is 0", "give it a component, or leave it out");
    check_initial_position(scene, force, what);
    for (const BoxSide side : *scene.flow.symmetry) {
        const std::size_t axis = side == BoxSide::x_low || side == BoxSide::x_high ? 0 : 1;
        const Expression& across = formulas.at(axis);
        if (!across.is_zero() && !across.depends_on_position() && !across.depends_on_initial_position())
            throw InputError(force.force.location,
                             what + " pushes across the plane of symmetry '" + to_string(side) +
                                 "': the two sides would not be alike",
                             "leave out that component, or the side");
    }
}

void check_shape(const Scene& scene, const MovingShape& shape) {
    const std::string what = "the moving shape '" + *shape.name + "'";
    for (const std::string& part : *shape.parts) need_pushable(scene, shape.parts.location, part);
    check_schedule(shape, what);
    if (std::ranges::any_of(*shape.position, &Expression::depends_on_position))
        throw InputError(shape.position.location, what + ": its position depends on x, y or z", "give formulas of t");
    if (*shape.kind == ShapeKind::parabola && *shape.height == 0)
        throw InputError(shape.height.location, what + " is flat: its height is 0", "give the height of its ends");
}

template <class Item>
void refuse_equal_names(const std::vector<Item>& items, const std::string& what) {
    for (auto item = items.begin(); item != items.end(); ++item) {
        const auto first =
            std::find_if(items.begin(), item, [&](const Item& other) { return *other.name == *item->name; });
        if (first != item)
            throw InputError(
                item->name.location,
                "there is already a " + what + " called '" + *item->name + "', at " + first->name.location.text(),
                "give each " + what + " its own name");
    }
}

}  // namespace

void check_driving(const Scene& scene) {
    refuse_equal_names(scene.forces, "force");
    refuse_equal_names(scene.moving_shapes, "moving shape");
    for (const ForceOnPart& force : scene.forces) check_force(scene, force);
    for (const MovingShape& shape : scene.moving_shapes) check_shape(scene, shape);
}

}  // namespace dmp::scene
