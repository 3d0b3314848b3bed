// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// What FluidStep does for elastic bodies and their contact.
#include <functional>

#include "solver/contact/surface_contact.hpp"
#include "solver/time/fluid_step.hpp"

namespace dmp::solver {

void FluidStep::start_surface_contact(const Scene& scene, const ParticleSet& set, double longest_step) {
    if (settings_.surface_contact)
        surface_contact_ = std::make_unique<SurfaceContact>(scene, set, springs_, longest_step, settings_.threads);
}

/// Contact of surfaces: at once, or in shorter parts along with the bodies' own step (advance_elastic).
void FluidStep::touch(double t, double dt) {
    timer_.timed("contact", [&] {
        contact_parts_ = surface_contact_->parts_of_step(springs_, walls_, t, dt);
        if (contact_parts_ == 1) kick_by_contact(t, dt);
    });
}

void FluidStep::kick_by_contact(double t, double dt) {
    const auto [of_supports, on_walls] = surface_contact_->kick(springs_, walls_, t, dt);
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        impulses_.of_fixed.at(static_cast<std::size_t>(axis)) += of_supports[axis] - on_walls[axis];
}

void FluidStep::advance_elastic(double t, double dt) {
    if (springs_.empty()) return;
    std::function<void(double)> contact;
    if (contact_parts_ > 1)
        contact = [this, t](double part) { timer_.timed("contact", [&] { kick_by_contact(t, part); }); };
    const auto given = springs_.advance(particles_, dt, settings_.threads, contact_parts_, contact);
    if (surface_contact_) surface_contact_->show_on_walls(particles_, dt);
    for (int axis = 0; axis < 3; ++axis) {
        impulses_.of_fixed[axis] += given.of_anchors[axis];
        impulses_.of_drag[axis] += given.of_drag[axis];
    }
}

}  // namespace dmp::solver
