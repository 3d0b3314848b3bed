// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/sphere_checks.hpp"

#include <algorithm>
#include <vector>

#include "base/nearest_name.hpp"
#include "models/dem/contact_laws.hpp"
#include "scene/law_lists.hpp"
#include "scene/measure_subject.hpp"
#include "scene/quantity.hpp"

namespace dmp::scene {

namespace {

std::string part_of(const Part& part) { return "part '" + *part.name + "'"; }

/// The first known location, otherwise the fallback.
SourceLocation first_given(std::initializer_list<const SourceLocation*> places, const SourceLocation& fallback) {
    for (const SourceLocation* location : places)
        if (location->known()) return *location;
    return fallback;
}

void need_room_for_spheres(const Scene& scene) {
    const Part& first = *scene.parts_of(PartKind::spheres).front();
    if (scene.dimension != 3)
        throw InputError(scene.dimension.given() ? scene.dimension.location : first.kind.location,
                         part_of(first) + " is of spheres, which need a 3-D scene, and the scene has 2 dimensions",
                         "write dimension = 3");
    for (const PartKind kind : {PartKind::fluid, PartKind::elastic, PartKind::rigid}) {
        const auto others = scene.parts_of(kind);
        if (others.empty()) continue;
        throw InputError(others.front()->kind.location,
                         "spheres ('" + *first.name + "') and parts of kind '" + to_string(kind) + "' ('" +
                             *others.front()->name + "') do not interact",
                         kind == PartKind::rigid ? "give spheres walls of kind 'plane' or 'surface'"
                                                 : "leave one of them out of the scene");
    }
    if (!scene.flow.symmetry->empty())
        throw InputError(scene.flow.symmetry.location, "flow.symmetry: scenes of spheres have no planes of symmetry",
                         "leave out flow.symmetry");
}

/// A periodic scene without a geometry needs a box.
void check_box(const Scene& scene, const TomlNode& document) {
    const auto& box = scene.box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!*scene.flow.periodic[axis]) continue;
        if (!box.from.given() || !box.to.given()) {
            const SourceLocation* location = document.location_of("box");
            throw InputError(location != nullptr ? *location : scene.flow.periodic[axis].location,
                             std::string("the scene is periodic along ") + "xyz"[axis] + ", but its period is missing",
                             R"(add [box] with from = [0, 0, 0] and to = ["1 mm", "1 mm", "1 mm"])");
        }
        const auto along = static_cast<Eigen::Index>(axis);
        if ((*box.from)[along] >= (*box.to)[along])
            throw InputError(box.to.location,
                             std::string("box.to is not beyond box.from along ") + "xyz"[axis] + ", a periodic axis",
                             "give the low corner as from and the high one as to");
    }
}

/// Exactly one of centres, positions, around and a box to fill.
void need_one_placement(const Part& part) {
    const bool fills = part.fill_from.given() || part.fill_to.given();
    std::vector<std::string> given;
    if (part.centres.given()) given.emplace_back("centres");
    if (part.positions.given()) given.emplace_back("positions");
    if (part.around.given()) given.emplace_back("around");
    if (fills) given.emplace_back("fill_from and fill_to");
    if (given.size() != 1)
        throw InputError(part.name.location,
                         given.empty() ? part_of(part) + " does not say where its spheres are"
                                       : part_of(part) + " says in " + std::to_string(given.size()) +
                                             " ways where its spheres are: " + quoted_list(given),
                         "give one of centres, positions, around, or fill_from and fill_to");
    if (fills) {
        if (!part.fill_from.given() || !part.fill_to.given())
            throw InputError(first_given({&part.fill_from.location, &part.fill_to.location}, part.name.location),
                             part_of(part) + ": a box to fill has two corners", "give fill_from and fill_to");
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            if ((*part.fill_from)[axis] >= (*part.fill_to)[axis])
                throw InputError(part.fill_to.location,
                                 part_of(part) + ": fill_to is not beyond fill_from along " + "xyz"[axis],
                                 "give the low corner as fill_from and the high one as fill_to");
    }
    const auto need_one = [&](const Value<double>& share, const char* name, bool applies) {
        if (share.given() && !applies)
            throw InputError(share.location, part_of(part) + ": " + name + " does not go with " + given.front(),
                             "leave it out");
        if (!applies || part.count.given() != share.given()) return;
        throw InputError(
            part.count.given() ? share.location : part.name.location,
            part_of(part) + (part.count.given() ? " gives both count and " : " gives neither count nor ") + name,
            std::string("give count or ") + name);
    };
    need_one(part.coverage, "coverage", part.around.given());
    need_one(part.volume_fraction, "volume_fraction", fills);
    if (part.count.given() && !part.around.given() && !fills)
        throw InputError(part.count.location, part_of(part) + ": count does not go with " + given.front(),
                         "leave it out");
}

void check_radius_and_mass(const Part& part) {
    if (!part.radius.given() && !part.positions.given())
        throw InputError(part.name.location, part_of(part) + ": radius is missing", R"(add radius = "1 mm")");
    if (part.radius->size() > 1 && part.radius->size() != part.centres->size())
        throw InputError(part.radius.location,
                         part_of(part) + " has " + std::to_string(part.radius->size()) + " radii" +
                             (part.centres.given() ? " and " + std::to_string(part.centres->size()) + " centres"
                                                   : ", and a list of them goes with centres only"),
                         "give one radius for all, or one for each of the centres");
    if (part.density.given() == part.mass.given())
        throw InputError(part.mass.given() ? part.mass.location : part.name.location,
                         part_of(part) + (part.mass.given() ? " has both a density and a mass"
                                                            : " has neither a density nor a mass"),
                         "give density, or mass of each sphere");
}

InputError unknown_part(const Scene& scene, const SourceLocation& location, const std::string& name,
                        bool spheres_only) {
    std::vector<std::string> names;
    for (const Part& part : scene.parts)
        if (!spheres_only || *part.kind == PartKind::spheres) names.push_back(*part.name);
    const std::string nearest = nearest_name(name, names);
    return {location, "the scene has no part '" + name + "'",
            nearest.empty() ? "the scene has " + quoted_list(names) : "did you mean '" + nearest + "'?"};
}

void check_around(const Scene& scene, const Part& part) {
    if (!part.around.given()) return;
    const Part* inner = scene.part_named(part.around);
    if (inner == nullptr) throw unknown_part(scene, part.around.location, part.around, true);
    if (*inner->kind != PartKind::spheres || inner == &part || !*inner->enabled)
        throw InputError(
            part.around.location,
            part_of(part) + ": its spheres cannot sit on " +
                (inner == &part     ? "themselves"
                 : !*inner->enabled ? "'" + *part.around + "', which is not enabled"
                                    : "'" + *part.around + "', which is of kind '" + to_string(*inner->kind) + "'"),
            "name an enabled part of one sphere");
    if (!inner->around.given() && inner->centres->size() == 1) return;
    if (inner->positions.given()) return;  // the mesher checks their number
    throw InputError(part.around.location,
                     part_of(part) + ": its spheres sit around one sphere, and '" + *part.around + "' has more",
                     "name a part with one centre");
}

void need_start_without_time(const Part& part) {
    const auto need = [&](const char* key, const Value<std::array<Expression, 3>>& formulas) {
        for (const Expression& formula : *formulas)
            if (formula.depends_on_time())
                throw InputError(formulas.location,
                                 std::string(key) + " of '" + *part.name + "' depends on t: \"" + formula.text() + "\"",
                                 "write formulas of x, y and z: initial values do not depend on time");
    };
    need("initial_velocity", part.initial_velocity);
    need("initial_spin", part.initial_spin);
}

void check_wall(const Part& wall) {
    if (std::ranges::any_of(*wall.velocity, &Expression::depends_on_position))
        throw InputError(wall.velocity.location, "velocity of '" + *wall.name + "' depends on x, y or z: it would bend",
                         "give formulas of t");
    if (wall.youngs_modulus.given() != wall.poisson_ratio.given())
        throw InputError(first_given({&wall.youngs_modulus.location, &wall.poisson_ratio.location}, wall.name.location),
                         part_of(wall) + " has " +
                             (wall.youngs_modulus.given() ? "a youngs_modulus" : "a poisson_ratio") + " and no " +
                             (wall.youngs_modulus.given() ? "poisson_ratio" : "youngs_modulus"),
                         "give both, or neither for a rigid wall");
}

// ---- contacts

std::string of_pair(const ContactPair& pair) {
    return "the contact of '" + (*pair.parts)[0] + "' and '" + (*pair.parts)[1] + "'";
}

void check_names(const Scene& scene, const ContactPair& pair) {
    int spheres = 0;
    for (const std::string& name : *pair.parts) {
        const Part* part = scene.part_named(name);
        if (name == "any" || (part != nullptr && *part->kind == PartKind::spheres)) ++spheres;
        if (name == "any" || (part != nullptr && (*part->kind == PartKind::spheres || part->is_wall_for_spheres())))
            continue;
        if (part == nullptr) throw unknown_part(scene, pair.parts.location, name, false);
        throw InputError(
            pair.parts.location,
            "'" + name + "' is of kind '" + to_string(*part->kind) + "'; contact pairs are for spheres and their walls",
            "name parts of kind 'spheres', 'plane' or 'surface'");
    }
    if (spheres == 0)
        throw InputError(pair.parts.location, of_pair(pair) + ": both are walls, which do not touch each other",
                         "name at least one part of spheres");
    for (const ContactPair& other : scene.contact_pairs) {
        if (&other == &pair) return;
        const auto& [a, b] = *other.parts;
        const auto& [c, d] = *pair.parts;
        if ((a == c && b == d) || (a == d && b == c))
            throw InputError(
                pair.parts.location,
                "there is already a [[contact_pair]] of '" + c + "' and '" + d + "', at " + other.parts.location.text(),
                "leave one of them out");
    }
}

void check_law(const ContactPair& pair) {
    const SourceLocation& at = pair.parts.location;
    if (!*pair.enabled) return;
    const bool damped = pair.normal_damping.given() || pair.tangential_damping.given();
    if (pair.restitution.given() && damped)
        throw InputError(first_given({&pair.normal_damping.location, &pair.tangential_damping.location}, at),
                         of_pair(pair) + " has its damping twice: as a restitution, at " +
                             pair.restitution.location.text() + ", and as coefficients",
                         "give restitution, or normal_damping and tangential_damping");
    if (!pair.restitution.given() && !pair.normal_damping.given())
        throw InputError(at, of_pair(pair) + " has neither a restitution nor damping coefficients",
                         "give restitution (1: elastic), or normal_damping and tangential_damping");
    if (!pair.friction.given())
        throw InputError(at,
                         of_pair(pair) + ": friction is missing, which the tangential law '" +
                             to_string(*pair.tangential) + "' needs",
                         "add friction = 0.3 (Coulomb's coefficient), or friction = 0 for spheres that slide freely");
}

void check_adhesion(const ContactPair& pair) {
    const SourceLocation& at = pair.adhesion.given() ? pair.adhesion.location
                               : pair.normal.given() ? pair.normal.location
                                                     : pair.parts.location;
    const ContactModel model{pair.normal, pair.tangential, pair.rolling, pair.adhesion};
    const bool has_range = pair.adhesion->visit([]<class Law>() { return Law::has_range; });
    const std::string laws =
        "normal = \"" + to_string(*pair.normal) + "\" and adhesion = \"" + to_string(*pair.adhesion) + "\"";
    if (!model.is_consistent())
        throw InputError(at, of_pair(pair) + ": " + laws + " do not go together: that normal law is adhesive itself",
                         "leave one of them out");
    const auto refuse = [&](const Value<double>& value, const char* name, const std::string& advice) {
        if (value.given())
            throw InputError(value.location, of_pair(pair) + ": " + name + " does not go with " + laws, advice);
    };
    if (!model.is_adhesive()) {
        const std::string advice = "write adhesion = " + adhesive_laws<AdhesionLaw>() +
                                   ", or normal = " + adhesive_laws<NormalLaw>() + ", or leave it out";
        refuse(pair.work_of_adhesion, "work_of_adhesion", advice);
        refuse(pair.pull_off_force, "pull_off_force", advice);
    } else if (pair.work_of_adhesion.given() == pair.pull_off_force.given()) {
        throw InputError(at,
                         of_pair(pair) + (pair.pull_off_force.given() ? " gives the strength of its adhesion twice"
                                                                      : " adheres, but the strength of the adhesion "
                                                                        "is missing"),
                         "give work_of_adhesion or pull_off_force");
    }
    if (!has_range) {
        refuse(pair.equilibrium_distance, "equilibrium_distance", "leave it out");
        refuse(pair.adhesion_cutoff, "adhesion_cutoff", "leave it out");
    } else if (!pair.equilibrium_distance.given()) {
        throw InputError(at,
                         of_pair(pair) + ": equilibrium_distance is missing, which adhesion = \"" +
                             to_string(*pair.adhesion) + "\" needs",
                         R"(add equilibrium_distance = "0.4 nm")");
    } else if (pair.adhesion_cutoff.given() && *pair.adhesion_cutoff <= *pair.equilibrium_distance) {
        throw InputError(
            pair.adhesion_cutoff.location,
            of_pair(pair) + ": adhesion_cutoff is not more than equilibrium_distance, where the force is largest",
            "give some tens of equilibrium distances");
    }
}

/// Whether the part's spheres can touch each other.
bool has_several(const Part& part) { return part.centres->size() != 1 && *part.count != 1; }

/// Each pair of parts that can touch needs a contact pair.
void need_contact_of_all(const Scene& scene) {
    std::vector<const Part*> spheres = scene.parts_of(PartKind::spheres), others = spheres;
    for (const PartKind kind : {PartKind::plane, PartKind::surface})
        for (const Part* wall : scene.parts_of(kind)) others.push_back(wall);
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        for (std::size_t j = i; j < others.size(); ++j) {
            const std::string &a = *spheres[i]->name, &b = *others[j]->name;
            if (i == j && !has_several(*spheres[i])) continue;
            if (scene.contact_between(a, b) != nullptr) continue;
            throw InputError(others[j]->name.location,
                             i == j ? "spheres of '" + a + "' can touch each other, but have no [[contact_pair]]"
                                    : "'" + a + "' and '" + b + "' can touch, but have no [[contact_pair]]",
                             "add a [[contact_pair]] with parts = [\"" + a + "\", \"" + b +
                                 "\"], restitution and friction, or enabled = false");
        }
    }
}

}  // namespace

void check_spheres(const Scene& scene, const TomlNode& document) {
    for (const ContactPair& pair : scene.contact_pairs) {
        check_names(scene, pair);
        check_law(pair);
        check_adhesion(pair);
    }
    const auto spheres = scene.parts_of(PartKind::spheres);
    for (const PartKind kind : {PartKind::plane, PartKind::surface})
        for (const Part* wall : scene.parts_of(kind)) {
            if (spheres.empty())
                throw InputError(wall->kind.location, part_of(*wall) + " is a wall for spheres, and the scene has none",
                                 "for walls of a fluid, use kind = \"rigid\"");
            check_wall(*wall);
        }
    if (spheres.empty()) return;
    need_room_for_spheres(scene);
    check_box(scene, document);
    for (const Part* part : spheres) {
        need_one_placement(*part);
        check_radius_and_mass(*part);
        need_start_without_time(*part);
    }
    for (const Part* part : spheres) check_around(scene, *part);
    need_contact_of_all(scene);
}

void check_sphere_measure(const Scene& scene, const Measure& measure) {
    const MeasureKind kind = measure.kind;
    if (subject_of(kind) == MeasureSubject::any) return;
    const bool has_spheres = !scene.parts_of(PartKind::spheres).empty();
    const bool of_spheres = subject_of(kind) == MeasureSubject::spheres;
    if (of_spheres != has_spheres)
        throw InputError(measure.kind.location,
                         "measure '" + *measure.name + "': '" + to_string(kind) + "' is for " +
                             (of_spheres ? "spheres, and the scene has none"
                                         : "scenes with a fluid or elastic solids, and the scene is of spheres"),
                         "leave it out, or choose another kind");
    if (!of_spheres || kind == MeasureKind::wall_force) return;
    const Part* part = scene.part_named(measure.part);
    if (part == nullptr) throw unknown_part(scene, measure.part.location, measure.part, true);
    if (*part->kind != PartKind::spheres)
        throw InputError(measure.part.location,
                         "part '" + *part->name + "' is of kind '" + to_string(*part->kind) + "', expected 'spheres'",
                         "name a part of spheres");
    if (kind == MeasureKind::detached && has_several(*part))
        throw InputError(measure.part.location,
                         "'" + *part->name + "' has several spheres, but detachment is counted from a single one",
                         "name a part of one sphere");
}

}  // namespace dmp::scene
