// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/time/step_limits.hpp"

#include <algorithm>
#include <cmath>

namespace dmp::solver {

StepLimit viscous_step_limit(const StepScales& scales) {
    // Half of the linear limit by default: walls with extrapolated velocity raise the largest eigenvalue.
    return {
        "viscosity",
        scales.factors.viscous * scales.viscous_limit * scales.support * scales.support / scales.kinematic_viscosity,
        "viscous_step_factor times the kernel's linear limit of nu dt / R^2"};
}

StepLimit species_step_limit(const StepScales& scales) {
    // As for viscosity: surfaces that are held at a concentration raise the eigenvalue.
    return {"species",
            scales.factors.species * scales.diffusion_limit * scales.support * scales.support / scales.diffusivity,
            "species_step_factor times the kernel's linear limit of D dt / R^2"};
}

namespace {

/// The pressure of the heavier liquid also accelerates particles of the lighter: the highest frequency of a random
/// mixture of both on a lattice is this many times that of one liquid (within 6 % for ratios up to 1000,
/// docs/scheme.md); of two layers, less.
double stiffening(double density_ratio) { return std::sqrt((1 + density_ratio) / 2); }

StepLimit sound_step_limit(const StepScales& scales, double largest_speed) {
    const double one_liquid = scales.step_factor * scales.support / (scales.sound_speed + largest_speed);
    if (scales.density_ratio == 1) return {"sound", one_liquid, "step_factor R / (c0 + U)"};
    return {"sound", one_liquid / stiffening(scales.density_ratio),
            "step_factor R / (c0 + U) / sqrt((1 + rho_max / rho_min) / 2), between liquids"};
}

}  // namespace

std::vector<StepLimit> fluid_step_limits(const StepScales& scales, double largest_speed, double acceleration) {
    std::vector<StepLimit> limits;
    if (scales.at_rest && scales.diffusivity > 0) return {species_step_limit(scales)};
    limits.push_back(sound_step_limit(scales, largest_speed));
    if (scales.kinematic_viscosity > 0 && !scales.implicit_viscosity) limits.push_back(viscous_step_limit(scales));
    if (scales.diffusivity > 0 && !scales.implicit_species) limits.push_back(species_step_limit(scales));
    if (scales.elastic_solids && scales.kinematic_viscosity > 0 && !scales.implicit_viscosity)
        // Measured: friction at elastic solids, which move with it, is stable at 0.9 of the viscous limit's default and
        // unstable at all of it.
        limits.push_back({"viscosity at elastic solids", 0.7 * scales.lightest_solid * viscous_step_limit(scales).dt,
                          "0.7 of the viscous limit, times m / m_liquid of the lightest elastic node"});
    if (scales.lightest_solid < 1 - 1e-9)  // not by rounding
        // Measured: light nodes coupled to the fluid's pressure are stable at 0.6 sqrt(m / m_liquid) and unstable at
        // 0.7, from 0.012 to 0.25 of the liquid's mass.
        limits.push_back({"light solids",
                          scales.factors.light_solid * std::sqrt(scales.lightest_solid) * scales.support /
                              (scales.sound_speed + largest_speed),
                          "light_solid_step_factor sqrt(m / m_liquid) R / (c0 + U) of the lightest elastic node"});
    if (acceleration > 0)
        limits.push_back({"body force", 0.25 * std::sqrt(0.5 * scales.support / acceleration), "0.25 sqrt(R / 2g)"});
    if (scales.shifting > 0 && largest_speed > 0)
        // A particle may be moved by shifting no further than the sum's own scale allows.
        limits.push_back({"shifting", scales.factors.shifting * scales.support / (scales.shifting * scales.sound_speed),
                          "s c0 dt / R <= shifting_step_factor"});
    add_drive_limit(limits, scales.drive_time);
    // Measured: stable at delta c0 dt / R = 0.15, unstable from 0.2 (corrected scheme) or 0.2 to 0.25 (plain).
    if (scales.density_diffusion * scales.step_factor > scales.factors.density_diffusion)
        limits.push_back({"density diffusion",
                          scales.factors.density_diffusion * scales.support /
                              (scales.density_diffusion * (scales.sound_speed + largest_speed)),
                          "delta (c0 + U) dt / R <= density_diffusion_step_factor"});
    if (scales.contact_limit > 0)
        limits.push_back({"contact", scales.factors.contact * scales.contact_limit,
                          "contact_step_factor of 2 / omega of the repulsion, at touch or nearer"});
    if (scales.surface_contact_limit > 0 && std::isfinite(scales.surface_contact_limit))
        limits.push_back({"contact of surfaces", scales.surface_contact_limit,
                          "0.8 of 2 / omega where all surfaces touch, by contact.stiffness"});
    return limits;
}

void add_drive_limit(std::vector<StepLimit>& limits, double drive_time) {
    const double dt = 0.1 * drive_time;
    const auto is_shorter = [dt](const StepLimit& limit) { return limit.dt <= dt; };
    if (!std::isfinite(dt) || std::ranges::any_of(limits, is_shorter)) return;
    limits.push_back({"drive", dt, "a tenth of the range of a driving formula over its typical rate of change"});
}

void add_driving_limit(std::vector<StepLimit>& limits, const Driving& driving, double length, double t) {
    if (driving.empty()) return;
    const double dt = driving.step_limit(length, t);
    if (std::isfinite(dt))
        limits.push_back({"driving", dt, "0.25 sqrt(R / 2a) of its forces, half of 2 / omega of shapes"});
}

const StepLimit& ruling_limit(const std::vector<StepLimit>& limits) {
    return *std::min_element(limits.begin(), limits.end(),
                             [](const StepLimit& a, const StepLimit& b) { return a.dt < b.dt; });
}

}  // namespace dmp::solver
