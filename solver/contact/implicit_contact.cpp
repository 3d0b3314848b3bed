// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact by the places at the end of the step.
#include <algorithm>

#include "solver/contact/surface_contact.hpp"

namespace dmp::solver {

namespace {

/// In a midpoint step, forces give half of their impulse to its mean velocity (SpringBody::balance).
constexpr double of_balance = 0.5;

}  // namespace

bool SurfaceContact::may_touch(const SpringBodies& bodies, const WallMotion& walls, double t, double dt) {
    place(bodies, walls, t, dt);
    find_touches(std::min(farthest_way() + at_rest * space_.spacing, deepest_));
    for (std::size_t point = 0; point < touches_.size(); ++point)
        if (touches_[point].gap > 0 && touches_[point].is_one && !meets_soon(point)) {
            touches_[point].is_one = false;
            memory_[point] = {};
        }
    std::vector<bool> touched(position_.size());
    bool any = false;
    for (std::size_t point = 0; point < touches_.size(); ++point) {
        if (!touches_[point].is_one) continue;
        any = true;
        const auto mark = [&](int unknown, double) { touched[index_of(unknown)] = true; };
        surfaces_.for_each_share(static_cast<int>(point / points_of_piece), 0.5, mark);
        surfaces_.for_each_share(touches_[point].piece, 0.5, mark);
    }
    touched_bodies_.clear();
    const auto& first = surfaces_.first_unknown();
    for (std::size_t b = 0; b + 1 < first.size(); ++b)
        touched_bodies_.push_back(std::find(touched.begin() + static_cast<std::ptrdiff_t>(first[b]),
                                            touched.begin() + static_cast<std::ptrdiff_t>(first[b + 1]),
                                            true) != touched.begin() + static_cast<std::ptrdiff_t>(first[b + 1]));
    return any;
}

/// Whether a point in front of a surface may meet it in this step, if neither is more than twice as fast there as now.
bool SurfaceContact::meets_soon(std::size_t point) const {
    const Touch& touch = touches_[point];
    const int piece = static_cast<int>(point / points_of_piece);
    const double speed =
        velocity_at(piece, gauss_points[point % points_of_piece]).norm() + velocity_at(touch.piece, touch.t).norm();
    return touch.gap < 2 * speed * dt_ + at_rest * space_.spacing;
}

void SurfaceContact::add_forces_at_end(std::span<const Vec> w, std::span<Vec> force) {
    std::ranges::copy(w, velocity_.begin());
    find_forces(dt_, false);
    for (std::size_t n = 0; n < force_.size(); ++n)
        if (inverse_mass_[n] > 0) force[n] += of_balance * force_[n];
}

void SurfaceContact::add_stiffness_times(std::span<const Vec> values, std::span<Vec> image) const {
    for (std::size_t point = 0; point < touches_.size(); ++point) {
        const Touch& touch = touches_[point];
        if (!touch.is_one || (touch.normal_slope == 0 && touch.tangent_slope == 0)) continue;
        const int piece = static_cast<int>(point / points_of_piece);
        const double at = gauss_points[point % points_of_piece];
        Vec past = Vec::Zero();
        surfaces_.for_each_share(piece, at,
                                 [&](int unknown, double share) { past += share * values[index_of(unknown)]; });
        surfaces_.for_each_share(touch.piece, touch.t,
                                 [&](int unknown, double share) { past -= share * values[index_of(unknown)]; });
        const Vec along_normal = past.dot(touch.normal) * touch.normal;
        const Vec held = touch.normal_slope * along_normal + touch.tangent_slope * (past - along_normal);
        const auto add = [&](double sign) {
            return [&, sign](int unknown, double share) {
                if (inverse_mass_[index_of(unknown)] > 0) image[index_of(unknown)] += sign * of_balance * share * held;
            };
        };
        surfaces_.for_each_share(piece, at, add(1));
        surfaces_.for_each_share(touch.piece, touch.t, add(-1));
    }
}

Vec SurfaceContact::press(SpringBodies& bodies) {
    find_forces(dt_, true);
    for (std::size_t b = 0; b < bodies.bodies().size(); ++b)
        bodies.bodies()[b]->press(std::span(force_).subspan(surfaces_.first_unknown()[b]));
    return impulse_on_walls();
}

}  // namespace dmp::solver
