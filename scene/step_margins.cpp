// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/step_margins.hpp"

#include <algorithm>
#include <cmath>
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

/// A key that sets the length of steps.
struct Row {
    const char* key;
    const char* model;
    Value<double> Numerics::*member;
    bool is_least;
    bool (*is_used)(const Scene&);
    StatedLimit (*stated)(const Scene&);
};

const Row all_rows[] = {
    {"numerics.step_factor", "sound", &Numerics::step_factor, false,
     [](const Scene& scene) { return !scene.parts_of(PartKind::fluid).empty(); }, largest_step_factor},
    {"numerics.spring_step_factor", "", &Numerics::spring_step_factor, false,
     [](const Scene& scene) {
         return scene.may_have_elastic() && *scene.numerics.spring_stepping == SpringStepping::subcycled;
     },
     [](const Scene& /*the same of all*/) {
         return StatedLimit{1, "2 / omega_max of the initial lattice"};
     }},
    {"numerics.steps_per_contact", "", &Numerics::steps_per_contact, true,
     [](const Scene& scene) { return !scene.parts_of(PartKind::spheres).empty() && *scene.numerics.contact_step == 0; },
     [](const Scene& /*the same of all*/) {
         return StatedLimit{least_steps_per_contact, "the least number that is accepted"};
     }},
};

const Row& row_of(const std::string& key) {
    const auto* const found = std::ranges::find(all_rows, key, &Row::key);
    if (found == std::end(all_rows)) throw std::out_of_range(key + " sets no steps");
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

double StepMargin::with_least_margin() const {
    constexpr double decimals = 1000;
    if (is_least) return std::ceil(stated.value * least_margin * decimals * (1 - rounding)) / decimals;
    return std::floor(stated.value / least_margin * decimals * (1 + rounding)) / decimals;
}

std::vector<StepMargin> step_margins(const Scene& scene) {
    std::vector<StepMargin> margins;
    for (const Row& row : all_rows)
        if (row.is_used(scene)) margins.push_back(margin_of(scene, row));
    return margins;
}

StepMargin step_margin(const Scene& scene, const std::string& key) {
    const Row& row = row_of(key);
    if (!row.is_used(scene)) throw std::out_of_range(key + " sets no steps of this scene");
    return margin_of(scene, row);
}

void lower_defaults(Scene& scene) {
    for (const StepMargin& margin : step_margins(scene))
        if (!margin.own.given() && margin.is_small())
            (scene.numerics.*row_of(margin.key).member).value = margin.with_least_margin();
}

std::string lowered_text(const Scene& scene, const std::string& key) {
    const auto* const row = std::ranges::find(all_rows, key, &Row::key);
    if (row == std::end(all_rows) || !row->is_used(scene)) return "";
    const StepMargin margin = margin_of(scene, *row);
    const std::string usual = default_text(scene, key);
    if (margin.own.given() || number_text(*margin.own, 9) == number_text(std::stod(usual), 9)) return "";
    return "lowered from " + usual + " to 1 / " + number_text(least_margin) + " of its stated limit, " +
           margin.stated.formula;
}

}  // namespace dmp::scene
