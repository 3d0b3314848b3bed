// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/step_margins.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "base/number_text.hpp"
#include "base/unlisted_value.hpp"
#include "models/sph/kernels.hpp"
#include "scene/schema.hpp"

namespace dmp::scene {

namespace {

using Numerics = decltype(Scene::numerics);

/// Margins that differ by less are alike.
constexpr double rounding = 1e-9;

/// Largest stable c dt / R by linear theory.
template <int D>
double sound_limit_of(KernelKind kind) {
    switch (kind) {
        case KernelKind::wendland_c2:
            return WendlandC2<D>::sound_limit;
        case KernelKind::wendland_c4:
            return WendlandC4<D>::sound_limit;
        case KernelKind::lucy:
            return Lucy<D>::sound_limit;
        case KernelKind::cubic_spline:
            return CubicSpline<D>::sound_limit;
        case KernelKind::quintic_spline:
            return QuinticSpline<D>::sound_limit;
    }
    unlisted_value(kind);
}

/// c0 dt / R above which the corrected scheme is unstable, measured (docs/scheme.md): of liquids and walls, and where
/// elastic nodes, stepped implicitly or sub-cycled, are as heavy as the liquid that they displace.
constexpr double of_liquid = 0.7, of_elastic = 0.6, of_subcycled_elastic = 0.33;

StatedLimit largest_step_factor(const Scene& scene) {
    const auto at = [](double limit, const std::string& source) {
        return StatedLimit{limit, "c0 dt / R = " + number_text(limit, 3) + ", " + source};
    };
    switch (*scene.numerics.scheme) {
        case FluidScheme::corrected:
            if (!scene.may_have_elastic()) return at(of_liquid, "measured");
            return *scene.numerics.spring_stepping == SpringStepping::subcycled
                       ? at(of_subcycled_elastic, "measured, with sub-cycled elastic solids")
                       : at(of_elastic, "measured, with elastic solids");
        case FluidScheme::plain:
            return at(*scene.dimension == 3 ? sound_limit_of<3>(scene.numerics.kernel)
                                            : sound_limit_of<2>(scene.numerics.kernel),
                      "linear theory of the kernel");
    }
    unlisted_value(*scene.numerics.scheme);
}

bool has_fluid(const Scene& scene) { return !scene.parts_of(PartKind::fluid).empty(); }

/// Solids, in which the velocity is extrapolated, raise the largest eigenvalue: measured, it breaks between 0.6 and
/// 0.84 (docs/limits.md).
StatedLimit largest_viscous_factor(const Scene& scene) {
    const bool has_solids = scene.may_have_elastic() || !scene.parts_of(PartKind::rigid).empty();
    if (has_solids) return {0.65, "of the linear limit of nu dt / R^2, measured, with solids"};
    return {1, "of nu dt / R^2, linear theory of the kernel"};
}

using Limits = std::function<StatedLimit(const Scene&)>;

/// Of all scenes.
Limits same(double value, const std::string& formula) {
    return [limit = StatedLimit{value, formula}](const Scene& /*all*/) { return limit; };
}

/// A key that sets the length of steps.
struct Row {
    std::string key;
    std::string model;
    Value<double> Numerics::*member;
    std::function<bool(const Scene&)> is_used;
    Limits stated;
    std::string idle;  ///< why it is not used, where it is not; "": told elsewhere
    bool is_least = false;
};

std::vector<Row> made_rows() {
    return {
        {"numerics.step_factor", "sound", &Numerics::step_factor, has_fluid, largest_step_factor, ""},
        {"numerics.viscous_step_factor", "viscosity", &Numerics::viscous_step_factor,
         [](const Scene& scene) {
             return has_fluid(scene) && *scene.numerics.viscosity_stepping == ViscosityStepping::explicitly;
         },
         largest_viscous_factor, "no viscosity is stepped explicitly"},
        {"numerics.species_step_factor", "species", &Numerics::species_step_factor,
         [](const Scene& scene) {
             return !scene.species.empty() && *scene.numerics.species_stepping == SpeciesStepping::explicitly;
         },
         same(1, "of D dt / R^2, linear theory of the kernel"), "no species is stepped explicitly"},
        {"numerics.contact_step_factor", "contact", &Numerics::contact_step_factor,
         [](const Scene& scene) { return *scene.contact.range > 0 && scene.parts_of(PartKind::spheres).empty(); },
         same(1, "of 2 / omega of the repulsion"), "contact.range is 0"},
        {"numerics.light_solid_step_factor", "light solids", &Numerics::light_solid_step_factor,
         [](const Scene& scene) {
             return has_fluid(scene) && scene.may_have_elastic() && *scene.numerics.scheme == FluidScheme::corrected;
         },
         same(0.6, "0.6 sqrt(m / m_liquid) R / (c0 + U), measured"),
         "it is of elastic solids in a fluid with scheme = \"corrected\""},
        {"numerics.density_diffusion_step_factor", "density diffusion", &Numerics::density_diffusion_step_factor,
         [](const Scene& scene) { return has_fluid(scene) && *scene.numerics.density_diffusion > 0; },
         same(0.15, "delta (c0 + U) dt / R = 0.15, measured"), "there is no density diffusion"},
        {"numerics.spring_step_factor", "", &Numerics::spring_step_factor,
         [](const Scene& scene) {
             return scene.may_have_elastic() && *scene.numerics.spring_stepping == SpringStepping::subcycled;
         },
         same(1, "2 / omega_max of the initial lattice"), ""},
        {"numerics.steps_per_contact", "", &Numerics::steps_per_contact,
         [](const Scene& scene) {
             return !scene.parts_of(PartKind::spheres).empty() && *scene.numerics.contact_step == 0;
         },
         same(least_steps_per_contact, "the least number that is accepted"), "", true},
    };
}

const std::vector<Row>& all_rows() {
    static const std::vector<Row> rows = made_rows();
    return rows;
}

const Row& row_of(const std::string& key) {
    const auto found = std::ranges::find(all_rows(), key, &Row::key);
    if (found == all_rows().end()) throw std::out_of_range(key + " sets no steps");
    return *found;
}

StepMargin margin_of(const Scene& scene, const Row& row) {
    return {row.key, row.model, scene.numerics.*row.member, row.stated(scene), row.is_least};
}

/// As it stands in the schema.
std::string default_text(const Scene& scene, const std::string& key) {
    for (const KeyFacts& fact : schema().facts())
        if (fact.path == key) return fact.fallback.at(scene.quality, scene.numerics.scheme);
    throw std::out_of_range("no key " + key);
}

}  // namespace

bool StepMargin::is_small(double held_shorter) const { return margin() * held_shorter < least_margin * (1 - rounding); }

std::string StepMargin::too_large_text() const {
    return key + " = " + number_text(*own) + " is too large; its stated limit is " + number_text(stated.value, 3);
}

double StepMargin::with_least_margin() const {
    constexpr double decimals = 1000;
    if (is_least) return std::ceil(stated.value * least_margin * decimals * (1 - rounding)) / decimals;
    return std::floor(stated.value / least_margin * decimals * (1 + rounding)) / decimals;
}

std::vector<StepMargin> step_margins(const Scene& scene) {
    std::vector<StepMargin> margins;
    for (const Row& row : all_rows())
        if (row.is_used(scene)) margins.push_back(margin_of(scene, row));
    return margins;
}

std::vector<IdleKey> idle_step_keys(const Scene& scene) {
    std::vector<IdleKey> idle;
    for (const Row& row : all_rows())
        if (const Value<double>& value = scene.numerics.*row.member;
            !row.idle.empty() && value.given() && !row.is_used(scene))
            idle.push_back({row.key, value.location, row.idle});
    return idle;
}

void lower_defaults(Scene& scene) {
    for (const StepMargin& margin : step_margins(scene))
        if (!margin.own.given() && margin.is_small())
            (scene.numerics.*row_of(margin.key).member).value = margin.with_least_margin();
}

std::string lowered_text(const Scene& scene, const std::string& key) {
    const auto row = std::ranges::find(all_rows(), key, &Row::key);
    if (row == all_rows().end() || !row->is_used(scene)) return "";
    const StepMargin margin = margin_of(scene, *row);
    const std::string usual = default_text(scene, key);
    if (margin.own.given() || number_text(*margin.own, 9) == number_text(std::stod(usual), 9)) return "";
    return "lowered from " + usual + " to 1 / " + number_text(least_margin) + " of its stated limit, " +
           margin.stated.formula;
}

}  // namespace dmp::scene
