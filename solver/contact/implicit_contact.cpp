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
    find_touches(films_ ? deepest_ : std::min(farthest_way() + at_rest * space_.spacing, deepest_));
    find_touched_controls();
    for (const int control : touched_controls_)
        control_velocity_[index_of(control)] = surfaces_.carried(control, velocity_);
    if (films_) find_films();
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
    return !touches_.empty() || !in_films_.empty();
}

/// Whether a point in front of a surface may meet it in this step, if neither is more than twice as fast there as now.
bool SurfaceContact::meets_soon(const Touch& touch) const {
    const double speed = velocity_at(touch.own, place_of(touch)).norm() + velocity_at(touch.other, touch.place).norm();
    return touch.gap < 2 * speed * dt_ + at_rest * space_.spacing;
}

void SurfaceContact::find_films() {
    in_films_.clear();
    std::vector<LiquidFilm::Point> points;
    for (const Touch& touch : touches_) {
        if (!(touch.gap < films_->law().thickest)) continue;
        in_films_.push_back(touch);
        points.push_back({touch.own, touch.number, touch.gap, touch.normal});
    }
    films_->find(std::move(points));
}

/// Of points in films, past what they are in front of [m/s].
std::vector<Vec> SurfaceContact::past_in_films() const {
    std::vector<Vec> past;
    for (const Touch& touch : in_films_)
        past.emplace_back(velocity_at(touch.own, place_of(touch)) - velocity_at(touch.other, touch.place));
    return past;
}

/// By the mean velocities of the step, over which they act: what they do is the energy that they take, and no more.
void SurfaceContact::add_film_forces() {
    if (in_films_.empty()) return;
    const std::vector<LiquidFilm::Traction> tractions = films_->tractions(past_in_films());
    for (std::size_t k = 0; k < in_films_.size(); ++k) {
        const Touch& touch = in_films_[k];
        // Both surfaces are sampled.
        const double area = 0.5 * piece(touch.own).weight[touch.number];
        const auto& [normal, tangential] = tractions[k];
        push(touch.own, place_of(touch), area * (normal + tangential));
        push(touch.other, touch.place, -area * (normal + tangential));
        add_couple(touch.own, touch.from - touch.at, area * tangential);
    }
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
    // Of a touch's own piece, and of the other.
    const auto value_at = [&](int number, const PiecePlace& place) {
        const auto& of = piece(number);
        const auto shares = of.now.shares(place);
        Vec value = Vec::Zero();
        for (std::size_t c = 0; c < of.now.controls() && !of.is_wall; ++c)
            value += shares[c] * control_velocity_[index_of(of.control[c])];
        return value;
    };
    const auto hold = [&](int number, const PiecePlace& place, const Vec& held) {
        const auto& of = piece(number);
        const auto shares = of.now.shares(place);
        for (std::size_t c = 0; c < of.now.controls() && !of.is_wall; ++c)
            control_force_[index_of(of.control[c])] += shares[c] * held;
    };
    const auto past_of = [&](const Touch& touch) {
        return Vec(value_at(touch.own, place_of(touch)) - value_at(touch.other, touch.place));
    };
    for (const Touch& touch : touches_) {
        if (touch.normal_slope == 0 && touch.tangent_slope == 0) continue;
        const Vec past = past_of(touch), along_normal = past.dot(touch.normal) * touch.normal;
        const Vec held = touch.normal_slope * along_normal + touch.tangent_slope * (past - along_normal);
        hold(touch.own, place_of(touch), held);
        hold(touch.other, touch.place, -held);
    }
    if (!in_films_.empty()) {
        std::vector<Vec> past;
        for (const Touch& touch : in_films_) past.push_back(past_of(touch));
        const std::vector<LiquidFilm::Traction> tractions = films_->tractions(past);
        for (std::size_t k = 0; k < in_films_.size(); ++k) {
            const Touch& touch = in_films_[k];
            const Vec held =
                -0.5 * piece(touch.own).weight[touch.number] * (tractions[k].normal + tractions[k].tangential);
            hold(touch.own, place_of(touch), held);
            hold(touch.other, touch.place, -held);
        }
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
