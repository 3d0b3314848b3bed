// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/spring_checks.hpp"

namespace dmp {

namespace {

/// How stiff a springs part is: as a strip, or as a material and a thickness.
void need_one_stiffness(const Part& part) {
    const std::string part_name = "part '" + *part.name + "'";
    const bool as_strip = part.bending_stiffness.given() || part.axial_stiffness.given();
    const bool as_material = part.youngs_modulus.given() || part.thickness.given() || part.poisson_ratio.given();
    const auto first = [](const auto& a, const auto& b) { return a.given() ? a.place : b.place; };
    if (as_strip && as_material)
        throw InputError(
            part.youngs_modulus.given() ? part.youngs_modulus.place : first(part.thickness, part.poisson_ratio),
            part_name + " has its stiffness twice: as a strip, at " +
                first(part.bending_stiffness, part.axial_stiffness).text() + ", and as a material",
            "give bending_stiffness and axial_stiffness, or youngs_modulus, thickness and poisson_ratio");
    if (part.bending_stiffness.given() && part.axial_stiffness.given()) return;
    if (part.youngs_modulus.given() && part.thickness.given()) return;
    const char* missing = as_strip ? (part.bending_stiffness.given() ? "axial_stiffness" : "bending_stiffness")
                                   : (part.youngs_modulus.given() ? "thickness" : "youngs_modulus");
    throw InputError(part.name.place,
                     as_strip || as_material ? part_name + ": " + missing + " is missing"
                                             : part_name + " does not say how stiff it is",
                     as_strip      ? "add " + std::string(missing) + ", or give youngs_modulus and thickness instead"
                     : as_material ? "add " + std::string(missing) + ", or give bending_stiffness and axial_stiffness"
                                   : "give bending_stiffness and axial_stiffness, or youngs_modulus and thickness");
}

/// In the plane a springs part is a strip; in space a body of a material.
void need_what_springs_are_made_of(const Scene& scene, const Part& part) {
    const std::string part_name = "part '" + *part.name + "'";
    if (scene.dimension == 2) {
        if (!part.mass_per_length.given())
            throw InputError(part.name.place, part_name + ": mass_per_length is missing",
                             "add mass_per_length, such as mass_per_length = \"0.4 kg/m\": of a strip 1 m deep");
        if (part.density.given())
            throw InputError(part.density.place, part_name + ": a springs part in the plane has no density",
                             "give its mass_per_length only: density times thickness times 1 m");
        return need_one_stiffness(part);
    }
    const auto refuse = [&](const Place& place, bool given, const char* key) {
        if (given)
            throw InputError(place, part_name + ": " + key + " is of springs in the plane, and the scene is in space",
                             "give density, youngs_modulus and poisson_ratio, and of a surface its thickness");
    };
    refuse(part.mass_per_length.place, part.mass_per_length.given(), "mass_per_length");
    refuse(part.bending_stiffness.place, part.bending_stiffness.given(), "bending_stiffness");
    refuse(part.axial_stiffness.place, part.axial_stiffness.given(), "axial_stiffness");
    refuse(part.cross_bonds.place, part.cross_bonds.given(), "cross_bonds");
    const auto need = [&](bool given, const char* key, const char* example) {
        if (!given)
            throw InputError(part.name.place, part_name + ": " + key + " is missing",
                             std::string("add ") + key + ", such as " + key + " = \"" + example + "\"");
    };
    need(part.density.given(), "density", "1100 kg/m^3");
    need(part.youngs_modulus.given(), "youngs_modulus", "2 MPa");
}

}  // namespace

void check_springs(const Scene& scene) {
    for (const Part& part : scene.parts)
        if (*part.kind == PartKind::springs) need_what_springs_are_made_of(scene, part);
}

}  // namespace dmp
