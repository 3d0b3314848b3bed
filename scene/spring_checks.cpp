// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/spring_checks.hpp"

namespace dmp::scene {

namespace {

/// The stiffness of a strip is given either directly, or by a material and a thickness.
void need_one_stiffness(const Part& part) {
    const std::string part_name = "part '" + *part.name + "'";
    if (part.shear_stiffness.given() && part.cross_bonds)
        throw InputError(part.cross_bonds.location,
                         part_name + " has cross_bonds and shear_stiffness, at " +
                             part.shear_stiffness.location.text() + ", which determines the cross bonds itself",
                         "leave out cross_bonds");
    const bool as_strip = part.bending_stiffness.given() || part.axial_stiffness.given();
    // A thickness alone says where the surfaces of a strip of known stiffness are.
    const bool as_material =
        part.youngs_modulus.given() || part.poisson_ratio.given() || (part.thickness.given() && !as_strip);
    const auto first = [](const auto& a, const auto& b) { return a.given() ? a.location : b.location; };
    if (as_strip && as_material)
        throw InputError(first(part.youngs_modulus, part.poisson_ratio),
                         part_name + " has its stiffness twice: as a strip, at " +
                             first(part.bending_stiffness, part.axial_stiffness).text() + ", and as a material",
                         "give bending_stiffness and axial_stiffness, or youngs_modulus, thickness and poisson_ratio");
    if (part.bending_stiffness.given() && part.axial_stiffness.given()) return;
    if (part.youngs_modulus.given() && part.thickness.given()) return;
    const char* missing = as_strip ? (part.bending_stiffness.given() ? "axial_stiffness" : "bending_stiffness")
                                   : (part.youngs_modulus.given() ? "thickness" : "youngs_modulus");
    throw InputError(part.name.location,
                     as_strip || as_material ? part_name + ": " + missing + " is missing"
                                             : part_name + " does not say how stiff it is",
                     as_strip      ? "add " + std::string(missing) + ", or give youngs_modulus and thickness instead"
                     : as_material ? "add " + std::string(missing) + ", or give bending_stiffness and axial_stiffness"
                                   : "give bending_stiffness and axial_stiffness, or youngs_modulus and thickness");
}

/// bonds_within is for solids only, and its Poisson's ratio is 0.25.
void check_bonds_within(const Scene& scene, const Part& part) {
    if (!part.bonds_within.given()) return;
    const std::string part_name = "part '" + *part.name + "'";
    const bool is_strip = scene.dimension == 2 && !part.density.given();
    if (is_strip || part.thickness.given())
        throw InputError(
            part.bonds_within.location,
            part_name + ": bonds_within is for solids, and this is a " + (is_strip ? "strip" : "shell"),
            "leave it out, or model the part as " + std::string(scene.dimension == 2 ? "an area" : "a volume"));
    if (part.poisson_ratio.given() && *part.poisson_ratio != 0.25)
        throw InputError(part.poisson_ratio.location, part_name + ": bonds_within gives a Poisson's ratio of 0.25 only",
                         "write poisson_ratio = 0.25, or leave out bonds_within");
}

void refuse_what_strips_have(const Part& part, const std::string& why, const std::string& what_to_do) {
    const auto refuse = [&](const auto& value, const char* key) {
        if (value.given())
            throw InputError(value.location, "part '" + *part.name + "': " + key + " " + why, what_to_do);
    };
    refuse(part.mass_per_length, "mass_per_length");
    refuse(part.bending_stiffness, "bending_stiffness");
    refuse(part.axial_stiffness, "axial_stiffness");
    refuse(part.shear_stiffness, "shear_stiffness");
    if (part.cross_bonds) refuse(part.cross_bonds, "cross_bonds");  // resolved scenes have it, as false
}

/// In 2-D, a part with a density is an area.
void need_what_an_area_is_made_of(const Part& part) {
    const std::string why = "is for strips, and a part with a density is an area";
    const std::string what_to_do =
        "for an area give density, youngs_modulus and poisson_ratio; for a curve give mass_per_length and no density";
    refuse_what_strips_have(part, why, what_to_do);
    if (part.thickness.given())
        throw InputError(part.thickness.location, "part '" + *part.name + "': thickness " + why, what_to_do);
    if (!part.youngs_modulus.given())
        throw InputError(part.name.location, "part '" + *part.name + "': youngs_modulus is missing",
                         "add youngs_modulus, such as youngs_modulus = \"2 MPa\"");
}

/// In 2-D an elastic solid is a strip, or an area of a material; in 3-D a body of a material.
void check_elastic_material(const Scene& scene, const Part& part) {
    const std::string part_name = "part '" + *part.name + "'";
    if (scene.dimension == 2) {
        if (part.density.given()) return need_what_an_area_is_made_of(part);
        if (!part.mass_per_length.given())
            throw InputError(
                part.name.location, part_name + ": mass_per_length is missing",
                "add mass_per_length, such as mass_per_length = \"0.4 kg/m\" (of a strip 1 m deep), or, for an area "
                "of the geometry, density");
        return need_one_stiffness(part);
    }
    refuse_what_strips_have(part, "is for strips in 2-D, and the scene is 3-D",
                            "give density, youngs_modulus and poisson_ratio, and thickness for a surface");
    const auto need = [&](bool given, const char* key, const char* example) {
        if (!given)
            throw InputError(part.name.location, part_name + ": " + key + " is missing",
                             std::string("add ") + key + ", such as " + key + " = \"" + example + "\"");
    };
    need(part.density.given(), "density", "1100 kg/m^3");
    need(part.youngs_modulus.given(), "youngs_modulus", "2 MPa");
}

/// What is given as cells has to be an area or a volume.
void check_model(const Scene& scene, const Part& part) {
    const std::string part_name = "part '" + *part.name + "'";
    if (part.elastic_law.given() && !scene.is_of_cells(part))
        throw InputError(
            part.elastic_law.location, part_name + ": elastic_law is for solids of cells: areas in 2-D, volumes in 3-D",
            part.model.given() || part.bonds_within.given() ? "leave out model and bonds_within, or elastic_law"
                                                            : "leave out elastic_law");
    if (!part.model.given() || *part.model == ElasticModel::springs) return;
    if (scene.dimension == 2 && !part.density.given())
        throw InputError(part.model.location, part_name + " is a strip, and model = \"cells\" is for areas",
                         "leave out model, or draw the part as an area, with density");
    if (part.thickness.given())
        throw InputError(part.model.location, part_name + " is a shell, and model = \"cells\" is for volumes",
                         "leave out model, or draw the part as a volume, without thickness");
    if (part.bonds_within.given())
        throw InputError(part.bonds_within.location, part_name + ": bonds_within is for solids of springs",
                         "write model = \"springs\", or leave out bonds_within");
}

/// Cells stand alone: nothing is bonded to them.
void check_cells(const Scene& scene, const Part& part) {
    if (!scene.is_of_cells(part)) return;
    const std::string part_name = "part '" + *part.name + "'";
    const auto use_springs = [&](const std::string& key) {
        return "write model = \"springs\" for '" + *part.name + "', or leave out " + key;
    };
    if (*part.poisson_ratio >= 0.5)
        throw InputError(part.poisson_ratio.location, part_name + ": a Poisson's ratio of 0.5 cannot be reached",
                         "write 0.49 for a solid that keeps its volume");
    if (!*part.enabled) return;
    for (const Join* join : scene.joins_of_enabled())
        for (const std::string& joined : *join->parts)
            if (joined == *part.name)
                throw InputError(join->parts.location,
                                 "'" + *join->name + "' joins '" + joined + "', a solid of cells, which takes no bonds",
                                 use_springs("the [[join]]"));
    for (const Solidify& rule : scene.solidify)
        if (rule.seed_part.given() && *rule.seed_part == *part.name)
            throw InputError(
                rule.seed_part.location,
                "'" + *rule.name + "' grows from '" + *part.name + "', a solid of cells, which takes no bonds",
                use_springs("the [[solidify]]"));
}

/// Both or neither, and of cells.
void check_damping(const Scene& scene, const Part& part) {
    const std::string part_name = "part '" + *part.name + "'";
    const Value<double>&ratio = part.damping_ratio, &frequency = part.damping_frequency;
    if (!ratio.given() && !frequency.given()) return;
    const Value<double>& first = ratio.given() ? ratio : frequency;
    if (!scene.is_of_cells(part))
        throw InputError(first.location,
                         part_name +
                             ": damping_ratio and damping_frequency are for solids of cells, and this is one of "
                             "springs",
                         "write bond_damping");
    if (!ratio.given() || !frequency.given())
        throw InputError(first.location,
                         part_name + " has " +
                             (ratio.given() ? "damping_ratio and no damping_frequency, at which it holds"
                                            : "damping_frequency and no damping_ratio"),
                         ratio.given() ? "add damping_frequency, such as damping_frequency = \"1.1 Hz\""
                                       : "add damping_ratio, such as damping_ratio = 0.02");
    if (part.bond_damping.given())
        throw InputError(part.bond_damping.location, part_name + ": bond_damping and damping_ratio are both given",
                         "leave one of them out");
}

/// Of x, y and z, and in 2-D without a third component.
void check_start(const Scene& scene, const Part& part) {
    const auto& velocity = part.initial_velocity;
    const std::string what = "initial_velocity of '" + *part.name + "'";
    for (const Expression& formula : *velocity)
        if (formula.depends_on_time())
            throw InputError(velocity.location, what + " depends on t: \"" + formula.text() + "\"",
                             "write formulas of x, y and z: initial values do not depend on time");
    if (scene.dimension == 2 && !(*velocity)[2].is_zero())
        throw InputError(velocity.location, what + " has a third component in a 2-D scene", "leave it out, or write 0");
}

}  // namespace

void check_elastic(const Scene& scene) {
    for (const Part& part : scene.parts)
        if (*part.kind == PartKind::elastic) {
            check_bonds_within(scene, part);
            check_elastic_material(scene, part);
            check_model(scene, part);
            check_cells(scene, part);
            check_damping(scene, part);
            check_start(scene, part);
        }
}

}  // namespace dmp::scene
