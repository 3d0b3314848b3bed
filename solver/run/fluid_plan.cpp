// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run of a fluid is going to do.
#include <algorithm>
#include <cmath>

#include "base/number_text.hpp"
#include "solver/contact/surface_contact.hpp"
#include "solver/results/expected_steps.hpp"
#include "solver/run/fluid_run.hpp"
#include "solver/run/models_in_use.hpp"
#include "solver/run/sound_speed.hpp"
#include "solver/run/warnings.hpp"
#include "solver/time/margins.hpp"
#include "solver/time/step_limits.hpp"

namespace dmp::solver {

Plan FluidRun::plan() const {
    Plan plan;
    plan.particles = count_;
    plan.bytes_per_particle = particles_.bytes() / std::max<std::size_t>(1, particles_.owned());
    plan.sound_speed = settings_.sound_speed;
    plan.largest_speed = scene_.flow.largest_speed;
    plan.sound = sound_;
    plan.at_rest = scales_.at_rest;
    double g = 0;  // largest over one run, sampled
    for (int k = 0; k <= 64; ++k) g = std::max(g, fluid_.body_force().largest(scene_.run.duration * k / 64));
    plan.limits = fluid_step_limits(scales_, plan.largest_speed, g);
    add_driving_limit(plan.limits, fluid_.driving(), scales_.support, time_);
    const StepLimit ruling = ruling_limit(plan.limits);
    plan.dt = ruling.dt;
    plan.ruling_limit = ruling.model;
    plan.steps = expected_steps(scene_, plan.dt, scene_.run.duration);
    const std::optional<Warning> better_implicit = viscosity_better_implicit(scene_, plan.limits);
    plan.warnings = warnings_of(scene_, fluid_.springs().bodies().size());
    add_margins(plan, scene_);
    plan.spring_substeps = fluid_.springs().substeps(plan.dt);
    if (settings_.viscosity.implicit && scales_.kinematic_viscosity > 0) {
        plan.limits.push_back(viscous_step_limit(scales_));
        // Backward Euler: what decays with exp(-t / 10 dt) is (1 + 1/10)^-10 after 10 steps.
        const double layer = std::sqrt(10 * scales_.kinematic_viscosity * plan.dt);
        plan.limits.back().formula +=
            "; not binding, stepped implicitly: what changes within 10 steps, such as shear "
            "layers of " +
            number_text(1e3 * layer, 2) + " mm, lags behind by 5 %";
    }
    if (scales_.implicit_species && scales_.diffusivity > 0) {
        plan.limits.push_back(species_step_limit(scales_));
        plan.limits.back().formula += "; not binding, stepped implicitly";
    }
    add_limits_of_elastic_solids(plan);
    plan.models = models_in_use(scene_, settings_, fluid_.sweeps(), fluid_.springs(), fluid_.surface_contact());
    plan.warnings.insert(plan.warnings.end(), foreseen_.begin(), foreseen_.end());
    if (better_implicit) plan.warnings.push_back(*better_implicit);
    if (const auto stirred = stirred_interface(scene_, fluid_.body_force().largest(time_)))
        plan.warnings.push_back(*stirred);
    add_fields(plan);
    return plan;
}

void FluidRun::add_limits_of_elastic_solids(Plan& plan) const {
    if (fluid_.surface_contact() != nullptr && fluid_.surface_contact()->stepping() == ContactStepping::in_parts &&
        std::isfinite(fluid_.surface_contact()->step_limit()))
        plan.limits.push_back({"contact of surfaces", fluid_.surface_contact()->step_limit(),
                               "0.8 of 2 / omega where all surfaces touch; not binding, as steps in which they may are "
                               "taken in parts"});
    for (const auto& limit : fluid_.springs().step_limits())
        plan.limits.push_back({"elastic (" + limit.part + ")", limit.dt,
                               std::string("2 / omega_max of the initial lattice; ") +
                                   (fluid_.springs().implicit() ? "not binding, stepped implicitly" : "sub-cycled")});
    for (const Solidify& rule : scene_.solidify)
        plan.limits.push_back({"elastic (" + *rule.name + ")", new_bond_limit(scene_, rule),
                               std::string("2 / omega of one new bond alone; ") +
                                   (fluid_.springs().implicit() ? "not binding, stepped implicitly"
                                                                : "sub-cycled, by the stiffest body there is")});
}

void FluidRun::add_fields(Plan& plan) const {
    for (const ParticleGroup& group : particles_.groups()) {
        if (group.empty()) continue;
        for (const Field field : group.declared()) {
            const auto bytes = static_cast<std::size_t>(group.axes(field)) * sizeof(double);
            plan.fields.push_back(to_string(group.kind()) + std::string(": ") + std::string(info(field).name) + ", " +
                                  std::to_string(bytes) + " bytes");
            const std::string_view owner = info(field).needed_by;
            const auto model = std::ranges::find_if(plan.models, [&](const ModelUse& use) {
                return !owner.empty() && use.model.find(owner) != std::string::npos;
            });
            if (model == plan.models.end()) {
                plan.common_fields.push_back(plan.fields.back());
            } else {
                model->fields.push_back(plan.fields.back());
                model->bytes += bytes;
            }
        }
    }
}

}  // namespace dmp::solver
