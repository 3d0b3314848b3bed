// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// What FluidStep does for elastic bodies and their contact.
#include <functional>

#include "solver/contact/surface_contact.hpp"
#include "solver/implicit/contact_solve.hpp"
#include "solver/time/fluid_step.hpp"

namespace dmp::solver {

void FluidStep::start_surface_contact(const Scene& scene, const ParticleSet& set, double longest_step) {
    if (!settings_.surface_contact) return;
    const bool fills_all = settings_.subtracts_level && !settings_.dry_bodies;
    surface_contact_ = std::make_unique<SurfaceContact>(scene, set, springs_, longest_step,
                                                        fills_all ? settings_.viscosity.largest : 0, settings_.threads);
}

/// Contact of surfaces: at once, in shorter parts along with the bodies' own step (advance_elastic), or by the places
/// at the end of the step, along with viscosity where that is implicit.
void FluidStep::touch(double t, double dt) {
    timer_.timed("contact", [&] {
        switch (surface_contact_->stepping()) {
            case ContactStepping::at_start:
                count_contact(surface_contact_->kick(springs_, walls_, t, dt));
                break;
            case ContactStepping::in_parts:
                contact_parts_ = surface_contact_->parts_of_step(springs_, walls_, t, dt);
                if (contact_parts_ == 1) count_contact(surface_contact_->kick(springs_, walls_, t, dt));
                break;
            case ContactStepping::at_end:
                may_touch_ = surface_contact_->may_touch(springs_, walls_, t, dt);
                if (!may_touch_ || viscosity_) break;
                if (!ContactSolve(springs_, *surface_contact_, particles_, dt).solve()) ++unsolved_contacts_;
                count_contact({Vec::Zero(), surface_contact_->press(springs_)});
                break;
        }
    });
}

void FluidStep::solve_viscous_forces(double t, double dt) {
    const auto swept = [this](const FieldList& fields, const auto& over) { sweep("viscosity", fields, over); };
    SurfaceContact* const contact = may_touch_ ? surface_contact_.get() : nullptr;
    timer_.timed("viscosity", [&] {
        viscosity_->add_forces(particles_, neighbours_.list(), springs_, contact, dt, body_force_.uniform(t), swept);
    });
    if (contact != nullptr) timer_.timed("contact", [&] { count_contact({Vec::Zero(), contact->press(springs_)}); });
}

void FluidStep::count_contact(const ContactImpulses& given) {
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        impulses_.of_fixed.at(static_cast<std::size_t>(axis)) += given.of_supports[axis] - given.on_walls[axis];
}

void FluidStep::advance_elastic(double t, double dt) {
    if (springs_.empty()) return;
    std::function<void(double)> contact;
    if (contact_parts_ > 1)
        contact = [this, t](double part) {
            timer_.timed("contact", [&] { count_contact(surface_contact_->kick(springs_, walls_, t, part)); });
        };
    const auto given = springs_.advance(particles_, dt, settings_.threads, contact_parts_, contact);
    if (surface_contact_) surface_contact_->show_on_walls(particles_, dt);
    for (int axis = 0; axis < 3; ++axis) {
        impulses_.of_fixed[axis] += given.of_anchors[axis];
        impulses_.of_drag[axis] += given.of_drag[axis];
    }
}

}  // namespace dmp::solver
