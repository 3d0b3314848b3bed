// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "models/dem/contact_material.hpp"

#include <cmath>
#include <sstream>
#include <string>

#include "base/errors.hpp"
#include "models/dem/restitution.hpp"

namespace dmp::models {

namespace {

void check(bool good, const char* name, double value, const char* bounds) {
    if (good) return;
    std::ostringstream what;
    what << name << " is " << value;
    throw InputError(what.str(), std::string("give it ") + bounds);
}
void check_not_negative(const char* name, double value) {
    check(value >= 0 && std::isfinite(value), name, value, "0 or a positive number");
}
void check_material(const ContactMaterial& material) {
    check(material.young_modulus > 0, "Young's modulus of a contact", material.young_modulus,
          "a number above 0 [Pa], or infinity for a rigid wall");
    check(material.poisson_ratio > -1 && material.poisson_ratio <= 0.5, "Poisson's ratio of a contact",
          material.poisson_ratio, "a number above -1 and at most 0.5");
}
void check_settings(const ContactSettings& settings) {
    check(settings.restitution > 0 && settings.restitution <= 1, "the restitution of a contact", settings.restitution,
          "a number above 0 and at most 1");
    for (const double factor : {settings.normal_stiffness_factor, settings.tangential_stiffness_factor})
        check(factor > 0 && std::isfinite(factor), "a stiffness factor of a contact", factor, "a number above 0");
    check_not_negative("the normal damping of a contact", settings.normal_rate);
    check_not_negative("the tangential damping of a contact", settings.tangential_rate);
    check_not_negative("the friction of a contact", settings.friction);
    check_not_negative("the rolling friction of a contact", settings.rolling_friction);
    check_not_negative("the damping of rolling", settings.rolling_damping);
    check_not_negative("the energy of adhesion", settings.adhesion_energy);
    check(settings.adhesion_distance > 0 && std::isfinite(settings.adhesion_distance), "the distance of adhesion",
          settings.adhesion_distance, "a number above 0 [m]");
    check(settings.adhesion_range > settings.adhesion_distance && std::isfinite(settings.adhesion_range),
          "the range of adhesion", settings.adhesion_range, "a number above the distance of adhesion [m]");
}

}  // namespace

ContactConstants<> contact_constants(const ContactMaterial& i, const ContactMaterial& j,
                                     const ContactSettings& settings) {
    check_material(i);
    check_material(j);
    check_settings(settings);
    const auto compliance = [](const ContactMaterial& m) {
        return (1 - m.poisson_ratio * m.poisson_ratio) / m.young_modulus;
    };
    const auto shear_compliance = [](const ContactMaterial& m) {
        return (2 - m.poisson_ratio) * 2 * (1 + m.poisson_ratio) / m.young_modulus;
    };
    const double normal = compliance(i) + compliance(j);
    if (!(normal > 0))
        throw InputError("both materials of a contact are rigid", "give one of them a finite Young's modulus");

    ContactConstants<> pair;
    pair.normal_stiffness = settings.normal_stiffness_factor * 4.0 / 3 / normal;
    pair.tangential_stiffness =
        settings.tangential_stiffness_factor * 8.0 / (shear_compliance(i) + shear_compliance(j));
    const auto add_dashpots = [&](double normal_ratio) {
        const double ratio = RestitutionDashpot::ratio_with_pull(settings.restitution);
        pair.normal_dashpot = RestitutionDashpot::normal(normal_ratio, pair.normal_stiffness);
        pair.tangential_dashpot = RestitutionDashpot::tangential(ratio, pair.tangential_stiffness);
    };
    switch (settings.damping) {
        case ContactDamping::restitution:
            add_dashpots(RestitutionDashpot::ratio_with_pull(settings.restitution));
            break;
        case ContactDamping::restitution_no_pull:
            add_dashpots(RestitutionDashpot::ratio_without_pull(settings.restitution));
            pair.least_normal = 0;
            break;
        case ContactDamping::coefficients:
            pair.normal_rate = settings.normal_rate;
            pair.tangential_rate = settings.tangential_rate;
    }
    pair.friction = settings.friction;
    pair.rolling_friction = settings.rolling_friction;
    pair.rolling_damping = settings.rolling_damping;
    pair.adhesion_energy = settings.adhesion_energy;
    pair.adhesion_distance = settings.adhesion_distance;
    pair.adhesion_range = settings.adhesion_range;
    return pair;
}

}  // namespace dmp::models
