// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/start_from_state.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "base/errors.hpp"
#include "scene/formula.hpp"
#include "scene/read_scene.hpp"

namespace dmp::scene {

namespace {

using Names = std::span<const std::string_view>;

constexpr const char* other_particles = "the particles would be others";
constexpr const char* other_meaning = "the state would mean something else";
constexpr const char* acts_at_start = "it acts at the start of a run alone, and the state is of a later time";
constexpr const char* springs_in_state = "bonds form or break in this scene, and their constants are in the state";
constexpr const char* other_motion = "the state holds how far the parts that move have come, and of no others";

bool is_in(Names names, std::string_view name) { return std::ranges::find(names, name) != names.end(); }

/// Of [flow], [contact] and [numerics].
constexpr std::array<std::string_view, 21> free_keys{"flow.acceleration",
                                                     "flow.pressure_gradient",
                                                     "flow.largest_speed",
                                                     "flow.largest_pressure",
                                                     "contact.strength",
                                                     "numerics.sound_speed",  // its value is compared as it is loaded
                                                     "numerics.mach_number",
                                                     "numerics.viscosity_mean",
                                                     "numerics.viscosity_stepping",
                                                     "numerics.viscosity_tolerance",
                                                     "numerics.step_factor",
                                                     "numerics.spring_step_factor",
                                                     "numerics.viscous_step_factor",
                                                     "numerics.species_step_factor",
                                                     "numerics.contact_step_factor",
                                                     "numerics.light_solid_step_factor",
                                                     "numerics.density_diffusion_step_factor",
                                                     "numerics.shifting_step_factor",
                                                     "numerics.species_tolerance",
                                                     "numerics.steps_per_contact",
                                                     "numerics.contact_step"};
/// Tables that hold nothing of the particles and nothing of the state.
constexpr std::array<std::string_view, 5> free_tables{"run", "output", "measure", "force", "moving_shape"};
constexpr std::array<std::string_view, 4> tables_of_particles{"geometry", "select", "particles", "box"};
constexpr std::array<std::string_view, 3> free_part_keys{"viscosity", "surface_velocity", "slip"};
constexpr std::array<std::string_view, 10> spring_keys{
    "bending_stiffness", "axial_stiffness", "shear_stiffness",   "youngs_modulus", "elastic_law",
    "bond_damping",      "damping_ratio",   "damping_frequency", "drag",           "mass_damping"};
/// Of rules of which each event, or each look, asks anew.
constexpr std::array<std::string_view, 10> solidify_keys_of_events{
    "until",      "rule",         "reach",           "probability",       "seed",
    "most_bonds", "stress_above", "residence_above", "seed_stress_above", "seed_residence_above"};
/// Of those, the ones that decide by whether they are given what seeds are, or what the state has to hold.
constexpr std::array<std::string_view, 3> given_or_not{"residence_above", "seed_stress_above", "seed_residence_above"};
constexpr std::array<std::string_view, 3> break_limits{"force_above", "stress_above", "strain_above"};
constexpr std::array<std::string_view, 2> motion_keys{"velocity", "spin"};

/// A number or a formula, as it stands in a scene without its quotes.
bool is_zero(const std::string& formula) {
    try {
        return constant_formula({formula, {}, {}}, "a part's motion").si == 0;
    } catch (const InputError&) {
        return false;  // it depends on time or place
    }
}

/// "0", "[0, 0]", "\"0 m/s\"", "": formulas that move nothing.
bool is_at_rest(const std::string& value) {
    std::string formula;
    for (const char each : value) {
        if (std::string_view("[]\",").find(each) == std::string_view::npos) {
            formula += each;
        } else {
            if (formula.find_first_not_of(' ') != std::string::npos && !is_zero(formula)) return false;
            formula.clear();
        }
    }
    return formula.find_first_not_of(' ') == std::string::npos || is_zero(formula);
}

/// Why a value of a part must be the same; "": it need not.
std::string why_fixed_in_part(const Scene& scene, const std::string& part, const std::string& key,
                              const ValueDifference& difference) {
    const Part* of = scene.part_named(part);
    if (of == nullptr) return other_particles;
    if (is_in(free_part_keys, key)) return "";
    if (is_in(motion_keys, key)) return is_at_rest(difference.before) == is_at_rest(difference.now) ? "" : other_motion;
    if (*of->kind == PartKind::elastic && key == "initial_velocity") return acts_at_start;
    if (*of->kind == PartKind::elastic && is_in(spring_keys, key))
        return scene.changes_bodies() ? springs_in_state : "";
    return other_particles;
}

std::string why_fixed(const Scene& scene, const ValueDifference& difference) {
    const std::string& path = difference.key;
    if (path == "title" || path == "quality" || is_in(free_keys, path)) return "";
    const auto first = path.find('.'), last = path.rfind('.');
    if (first == std::string::npos) return other_particles;
    const std::string table = path.substr(0, first), key = path.substr(last + 1);
    if (is_in(free_tables, table)) return "";
    if (is_in(tables_of_particles, table) || path == "flow.periodic" || path == "flow.symmetry") return other_particles;
    if (table == "flow") return acts_at_start;
    if (table == "part") return why_fixed_in_part(scene, path.substr(first + 1, last - first - 1), key, difference);
    if (table == "join") return key == "damping" && !scene.changes_bodies() ? "" : other_particles;
    const bool stays_given = !difference.before.empty() && !difference.now.empty();
    if (table == "solidify" && is_in(solidify_keys_of_events, key) && (stays_given || !is_in(given_or_not, key)))
        return "";
    if (table == "break" && is_in(break_limits, key)) return "";
    return other_meaning;
}

}  // namespace

std::vector<FixedValue> fixed_in_start(const std::string& before, const Scene& scene) {
    std::vector<FixedValue> fixed;
    for (ValueDifference& difference : differences(before, resolved_scene(scene)))
        if (std::string why = why_fixed(scene, difference); !why.empty())
            fixed.push_back({std::move(difference), std::move(why)});
    return fixed;
}

std::string fixed_text(const std::vector<FixedValue>& fixed) {
    constexpr std::size_t most = 5;
    std::string text;
    for (std::size_t k = 0; k < std::min(most, fixed.size()); ++k)
        text += differences_text({fixed[k].difference}) + ": " + fixed[k].why;
    if (fixed.size() > most) text += "\n  and " + std::to_string(fixed.size() - most) + " more";
    return text;
}

}  // namespace dmp::scene
