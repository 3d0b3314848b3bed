// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact by the places at the end of the step.
#include <algorithm>

#include "solver/contact/surface_contact.hpp"

namespace dmp::solver {

namespace {

/// In a midpoint step, forces give half of their impulse to its mean velocity (SpringBody::balance).
constexpr double of_balance = 0.5;
/// Both surfaces of a film are sampled.
constexpr double of_films = 0.5;

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
        const double area = of_films * piece(touch.own).weight[touch.number];
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
    const auto past_of = [&](const Touch& touch) {
        return Vec(carried_at(touch.own, place_of(touch)) - carried_at(touch.other, touch.place));
    };
    const auto hold = [&](const Touch& touch, const Vec& held) {
        give(touch.own, place_of(touch), held);
        give(touch.other, touch.place, -held);
    };
    for (const Touch& touch : touches_) {
        if (touch.normal_slope == 0 && touch.tangent_slope == 0) continue;
        const Vec past = past_of(touch), along_normal = past.dot(touch.normal) * touch.normal;
        const Vec held = touch.normal_slope * along_normal + touch.tangent_slope * (past - along_normal);
        hold(touch, held);
    }
    if (!in_films_.empty()) {
        std::vector<Vec> past;
        for (const Touch& touch : in_films_) past.push_back(past_of(touch));
        const std::vector<LiquidFilm::Traction> tractions = films_->tractions(past);
        for (std::size_t k = 0; k < in_films_.size(); ++k) {
            const Touch& touch = in_films_[k];
            hold(touch,
                 -of_films * piece(touch.own).weight[touch.number] * (tractions[k].normal + tractions[k].tangential));
        }
    }
    for (const int control : touched_controls_)
        for (const auto& share : surfaces_.carriers(control))
            if (inverse_mass_[index_of(share.unknown)] > 0)
                image[index_of(share.unknown)] += of_balance * share.of(control_force_[index_of(control)]);
}

ContactMatrix SurfaceContact::matrix() const {
    const int axes = space_.dimension;
    constexpr int none = -1;
    std::vector<int> row(surfaces_.controls(), none);
    for (std::size_t k = 0; k < touched_controls_.size(); ++k)
        row[index_of(touched_controls_[k])] = static_cast<int>(k) * axes;
    // Calls visit(its first row, its share in how fast the point passes the other surface) for each control point.
    const auto for_each_control = [&](const Touch& touch, const auto& visit) {
        const auto visit_all = [&](int number, const PiecePlace& place, double sign) {
            const auto& of = piece(number);
            const auto shares = of.now.shares(place);
            for (std::size_t c = 0; c < of.now.controls() && !of.is_wall; ++c)
                visit(row[index_of(of.control[c])], sign * shares[c]);
        };
        visit_all(touch.own, place_of(touch), 1);
        visit_all(touch.other, touch.place, -1);
    };
    using Entries = std::vector<Eigen::Triplet<double>>;
    Entries of_controls, films, carried;
    const auto add = [&](const Touch& touch, double along_normal, double along_surface) {
        const Eigen::Matrix3d held = along_surface * Eigen::Matrix3d::Identity() +
                                     (along_normal - along_surface) * touch.normal * touch.normal.transpose();
        for_each_control(touch, [&](int a, double of_a) {
            for_each_control(touch, [&](int b, double of_b) {
                for (int i = 0; i < axes; ++i)
                    for (int j = 0; j < axes; ++j) of_controls.emplace_back(a + i, b + j, of_a * of_b * held(i, j));
            });
        });
    };
    for (const Touch& touch : touches_)
        if (touch.normal_slope != 0 || touch.tangent_slope != 0) add(touch, touch.normal_slope, touch.tangent_slope);
    for (std::size_t k = 0; k < in_films_.size(); ++k) {
        const Touch& touch = in_films_[k];
        add(touch, 0, of_films * piece(touch.own).weight[touch.number] * films_->law().drag(touch.gap));
        films_->for_each_pressure(k, [&](int pressure, const Vec& force) {
            for_each_control(touch, [&](int a, double of_a) {
                for (int i = 0; i < axes; ++i) films.emplace_back(a + i, pressure, of_a * force[i]);
            });
        });
    }
    for (const int control : touched_controls_)
        for (const auto& [unknown, reflected, share] : surfaces_.carriers(control))
            for (int i = 0; i < axes && inverse_mass_[index_of(unknown)] > 0; ++i)
                carried.emplace_back(row[index_of(control)] + i, unknown * axes + i,
                                     Reflection::has(reflected, i) ? -share : share);
    const auto rows = static_cast<Eigen::Index>(touched_controls_.size()) * axes;
    const auto made_of = [&](const Entries& entries, Eigen::Index columns) {
        Eigen::SparseMatrix<double> matrix(rows, columns);
        matrix.setFromTriplets(entries.begin(), entries.end());
        return matrix;
    };
    const Eigen::SparseMatrix<double> carry = made_of(carried, static_cast<Eigen::Index>(surfaces_.unknowns()) * axes);
    ContactMatrix matrix;
    matrix.stiffness = of_balance * carry.transpose() * made_of(of_controls, rows) * carry;
    if (in_films_.empty()) return matrix;
    matrix.conductance = films_->conductance() / (of_balance * of_films);
    matrix.films = carry.transpose() * made_of(films, matrix.conductance.rows());
    return matrix;
}

Vec SurfaceContact::press(SpringBodies& bodies) {
    find_forces(dt_, true);
    for (std::size_t b = 0; b < bodies.bodies().size(); ++b)
        bodies.bodies()[b]->press(std::span(force_).subspan(surfaces_.first_unknown()[b]));
    return impulse_on_walls();
}

}  // namespace dmp::solver
