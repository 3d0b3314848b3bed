// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact by the places at the end of the step.
#include <algorithm>
#include <tuple>

#include "solver/contact/surface_contact.hpp"

namespace dmp::solver {

namespace {

/// In a midpoint step, forces give half of their impulse to its mean velocity (SpringBody::balance).
constexpr double of_balance = 0.5;

}  // namespace

bool SurfaceContact::may_touch(const SpringBodies& bodies, const WallMotion& walls, double t, double dt) {
    place(bodies, walls, t, dt);
    find_touches(std::min(farthest_way() + at_rest * space_.spacing, deepest_));
    find_touched_controls();
    for (const int control : touched_controls_)
        control_velocity_[index_of(control)] = surfaces_.carried(control, velocity_);
    std::erase_if(touches_, [&](const Touch& touch) {
        if (!(touch.gap > 0) || meets_soon(touch)) return false;
        memory_[index_of(touch.own, touch.number)] = {};
        return true;
    });
    find_touched_controls();
    touched_bodies_.assign(surfaces_.first_unknown().size() - 1, false);
    for (const int control : touched_controls_)
        if (const int body = surfaces_.body_of(control); body != ContactSurfaces::no_body)
            touched_bodies_[index_of(body)] = true;
    return !touches_.empty();
}

/// Whether a point in front of a surface may meet it in this step, if neither is more than twice as fast there as now.
bool SurfaceContact::meets_soon(const Touch& touch) const {
    const double speed = velocity_at(touch.own, place_of(touch)).norm() + velocity_at(touch.other, touch.place).norm();
    return touch.gap < 2 * speed * dt_ + at_rest * space_.spacing;
}

void SurfaceContact::add_forces_at_end(std::span<const Vec> w, std::span<Vec> force) {
    std::ranges::copy(w, velocity_.begin());
    find_forces(dt_, false);
    for (std::size_t n = 0; n < force_.size(); ++n)
        if (inverse_mass_[n] > 0) force[n] += of_balance * force_[n];
}

void SurfaceContact::add_stiffness_times(std::span<const Vec> values, std::span<Vec> image) {
    for (const int control : touched_controls_) {
        control_velocity_[index_of(control)] = surfaces_.carried(control, values);
        control_force_[index_of(control)] = Vec::Zero();
    }
    for (const Touch& touch : touches_) {
        if (touch.normal_slope == 0 && touch.tangent_slope == 0) continue;
        Vec past = Vec::Zero();
        const auto for_each_control = [&](const auto& visit) {
            for (const auto& [number, place, sign] :
                 {std::tuple(touch.own, place_of(touch), 1.0), std::tuple(touch.other, touch.place, -1.0)}) {
                const auto& of = piece(number);
                if (of.is_wall) continue;
                const auto shares = of.now.shares(place);
                for (std::size_t c = 0; c < of.now.controls(); ++c) visit(index_of(of.control[c]), sign * shares[c]);
            }
        };
        for_each_control([&](std::size_t control, double share) { past += share * control_velocity_[control]; });
        const Vec along_normal = past.dot(touch.normal) * touch.normal;
        const Vec held = touch.normal_slope * along_normal + touch.tangent_slope * (past - along_normal);
        for_each_control([&](std::size_t control, double share) { control_force_[control] += share * held; });
    }
    for (const int control : touched_controls_)
        for (const auto& [unknown, share] : surfaces_.carriers(control))
            if (inverse_mass_[index_of(unknown)] > 0)
                image[index_of(unknown)] += of_balance * share * control_force_[index_of(control)];
}

Vec SurfaceContact::press(SpringBodies& bodies) {
    find_forces(dt_, true);
    for (std::size_t b = 0; b < bodies.bodies().size(); ++b)
        bodies.bodies()[b]->press(std::span(force_).subspan(surfaces_.first_unknown()[b]));
    return impulse_on_walls();
}

}  // namespace dmp::solver
