// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/surface_contact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>
#include <unordered_map>

#include "solver/state/loaded_groups.hpp"

namespace dmp::solver {

namespace {

constexpr double most_parts = 1e6;

}  // namespace

void SurfaceContact::read_bodies(const SpringBodies& bodies) {
    for (std::size_t b = 0; b < bodies.bodies().size(); ++b)
        for (std::size_t n = 0; n < bodies.bodies()[b]->unknowns(); ++n) {
            position_[surfaces_.first_unknown()[b] + n] = bodies.bodies()[b]->unknown_position(n);
            velocity_[surfaces_.first_unknown()[b] + n] = bodies.bodies()[b]->unknown_velocity(n);
        }
}

void SurfaceContact::place(const SpringBodies& bodies, const WallMotion& walls, double t, double dt) {
    walls_ = &walls;
    t_ = t;
    dt_ = dt;
    read_bodies(bodies);
    surfaces_.place(position_, &walls, threads_);
    find_pairs();
}

/// How far surfaces may approach each other in this step, if nothing is more than twice as fast as it is now [m].
double SurfaceContact::farthest_way() const {
    double fastest = walls_->largest_speed(t_);
    for (const Vec& velocity : velocity_) fastest = std::max(fastest, velocity.norm());
    return 4 * fastest * dt_;
}

double SurfaceContact::stiffness_of(int number, int other) const {
    const auto &own = piece(number), &met = piece(other);
    return (own.is_wall || met.is_wall ? at_walls_ : 1) *
           std::min(stiffness_[index_of(own.part)], stiffness_[index_of(met.part)]);
}

void SurfaceContact::find_touched_controls() {
    for (const int control : touched_controls_) is_touched_[index_of(control)] = false;
    touched_controls_.clear();
    for (const std::vector<Touch>* touches : {&touches_, &in_films_})
        for (const Touch& touch : *touches)
            for (const int number : {touch.own, touch.other}) {
                const auto& of = piece(number);
                for (std::size_t c = 0; c < of.now.controls() && !of.is_wall; ++c) {
                    if (is_touched_[index_of(of.control[c])]) continue;
                    is_touched_[index_of(of.control[c])] = true;
                    touched_controls_.push_back(of.control[c]);
                }
            }
}

/// [m/s]
Vec SurfaceContact::velocity_at(int number, const PiecePlace& place) const {
    const auto& of = piece(number);
    if (!of.is_wall) return carried_at(number, place);
    return of.reflection.of_vector(
        walls_->velocity(static_cast<std::uint16_t>(of.part), of.reflection.of_point(of.at_rest.at(place)), t_));
}

Vec SurfaceContact::carried_at(int number, const PiecePlace& place) const {
    const auto& of = piece(number);
    const auto shares = of.now.shares(place);
    Vec velocity = Vec::Zero();
    for (std::size_t c = 0; c < of.now.controls(); ++c)
        velocity += shares[c] * control_velocity_[index_of(of.control[c])];
    return velocity;
}

/// Opposite forces across an arm turn the bodies; the piece takes that at its corners.
void SurfaceContact::add_couple(int number, const Vec& arm, const Vec& force) {
    const auto& of = piece(number);
    if (of.is_wall) return;
    const auto at_corners = of.now.couple(-arm.cross(force));
    for (std::size_t c = 0; c < of.now.corners; ++c) control_force_[index_of(of.control[c])] += at_corners[c];
}

void SurfaceContact::push(int number, const PiecePlace& place, const Vec& force) {
    if (piece(number).is_wall)
        on_walls_[index_of(number)] += piece(number).reflection.of_vector(force);
    else
        give(number, place, force);
}

void SurfaceContact::give(int number, const PiecePlace& place, const Vec& force) {
    const auto& of = piece(number);
    const auto shares = of.now.shares(place);
    for (std::size_t c = 0; c < of.now.controls(); ++c) control_force_[index_of(of.control[c])] += shares[c] * force;
}

void SurfaceContact::find_forces(double ahead, bool remembers) {
    std::ranges::fill(force_, Vec::Zero());
    std::ranges::fill(on_walls_, Vec::Zero());
    for (const int control : touched_controls_) {
        control_force_[index_of(control)] = Vec::Zero();
        control_velocity_[index_of(control)] = surfaces_.carried(control, velocity_);
    }
    for (Touch& touch : touches_) add_force(touch, ahead, remembers);
    add_film_forces();
    for (const int control : touched_controls_)
        for (const auto& share : surfaces_.carriers(control))
            force_[index_of(share.unknown)] += share.of(control_force_[index_of(control)]);
}

void SurfaceContact::add_force(Touch& touch, double ahead, bool remembers) {
    const auto &own = piece(touch.own), &other = piece(touch.other);
    const PiecePlace& at = place_of(touch);
    const double weight = own.weight[touch.number];
    const double stiffness = stiffness_of(touch.own, touch.other);
    const bool touched = touch.gap < 0;  // before this step: friction and dashpot begin after that

    Vec past = Vec::Zero();  // at which it passes
    double gap = touch.gap;
    if (ahead > 0 || law_.friction > 0 || law_.damping > 0) {
        const Vec of_own = velocity_at(touch.own, at), of_other = velocity_at(touch.other, touch.place);
        past = of_own - of_other;
        // Walls are in the middle of the step when bodies are at its start.
        gap += ahead * ((own.is_wall ? 0.5 : 1) * of_own - (other.is_wall ? 0.5 : 1) * of_other).dot(touch.normal);
    }
    touch.normal_slope = touch.tangent_slope = touch.pressure = 0;
    touch.force.setZero();
    Vec slip = memory_[index_of(touch.own, touch.number)].slip;
    if (gap < 0) {
        const double inverse_mass = rate_[index_of(own.part)] + rate_[index_of(other.part)];
        const double mass_per_area = inverse_mass > 0 ? 1 / inverse_mass : 0;
        const double pressure = law_.pressure(stiffness, gap, touched ? past.dot(touch.normal) : 0, mass_per_area);
        touch.pressure = pressure;
        const double area = touch.share * weight;
        if (pressure > 0)
            touch.normal_slope = area * (ahead * stiffness + (touched ? law_.dashpot(stiffness, mass_per_area) : 0));
        // Towards where there is more of the contact, its energy grows. By the present gap: by that at the end of an
        // implicit step it would grow with the square of w, and Newton's method with it.
        Vec tangential = Vec::Zero();
        if (touched && touch.share_slope != Vec::Zero()) {
            tangential = -weight * SurfaceContactLaw::energy(stiffness, touch.gap) * touch.share_slope;
            add_couple(touch.other, touch.from - touch.at, tangential);
        }
        if (law_.friction > 0 && touched) {
            const double length = slip.norm();
            slip -= slip.dot(touch.normal) * touch.normal;
            if (slip.norm() > 0) slip *= length / slip.norm();
            slip += dt_ * (past - past.dot(touch.normal) * touch.normal);
            const double before = slip.norm();
            const Vec friction = area * law_.traction(stiffness, pressure, slip);
            if (slip.norm() == before)
                touch.tangent_slope = area * dt_ * SurfaceContactLaw::tangential_stiffness * stiffness;
            add_couple(touch.own, touch.from - touch.at, friction);
            tangential += friction;
        }
        const Vec force = area * pressure * touch.normal + tangential;
        push(touch.own, at, force);
        push(touch.other, touch.place, -force);
        touch.force = force;
    }
    if (remembers) remember(touch, gap, slip);
}

void SurfaceContact::remember(const Touch& touch, double gap, const Vec& slip) {
    memory_[index_of(touch.own, touch.number)] = gap < 0 ? Memory{piece(touch.other).solid, gap, slip} : Memory{};
    if (-gap > deepest_of_all_.depth)
        deepest_of_all_ = {-gap, t_, touch.from, {piece(touch.own).part, piece(touch.other).part}};
}

/// Of the step, or the part of it [N s].
Vec SurfaceContact::impulse_on_walls() {
    Vec sum = Vec::Zero();
    for (std::size_t k = 0; k < on_walls_.size(); ++k) {
        impulse_on_walls_[k] += dt_ * on_walls_[k];
        sum += dt_ * on_walls_[k];
    }
    return sum;
}

int SurfaceContact::parts_of_step(const SpringBodies& bodies, const WallMotion& walls, double t, double dt) {
    const double parts = std::ceil(dt / step_limit() * (1 - 1e-9));
    if (!(parts > 1)) return 1;
    place(bodies, walls, t, dt);
    return pairs_.nearest(surfaces_) <= std::max(farthest_way(), at_rest * space_.spacing)
               ? static_cast<int>(std::min(parts, most_parts))
               : 1;
}

ContactImpulses SurfaceContact::kick(SpringBodies& bodies, const WallMotion& walls, double t, double dt) {
    place(bodies, walls, t, dt);
    find_touches(0);
    find_touched_controls();
    find_forces(0, true);
    ContactImpulses impulses{Vec::Zero(), impulse_on_walls()};
    for (std::size_t b = 0; b < bodies.bodies().size(); ++b)
        impulses.of_supports += bodies.bodies()[b]->kick(std::span(force_).subspan(surfaces_.first_unknown()[b]), dt);
    return impulses;
}

SurfaceContact::Sums SurfaceContact::sums(const std::string& part, const std::string& against) const {
    Sums sums;
    const auto is_of = [&](int number, const std::string& name) {
        return name.empty() || space_.parts[index_of(piece(number).part)].name == name;
    };
    const auto end = touches_.end();
    for (auto begin = touches_.begin(); begin != end;) {
        const int number = begin->own;
        double on_piece = 0, size = 0;
        for (std::size_t p = 0; p < surfaces_.points().size(); ++p) size += piece(number).weight[p];
        for (; begin != end && begin->own == number; ++begin) {
            const Touch& touch = *begin;
            if (!(touch.pressure > 0)) continue;
            const double weight = piece(number).weight[touch.number];
            const bool own = is_of(number, part) && is_of(touch.other, against);
            const bool met = is_of(touch.other, part) && is_of(number, against);
            // What acts beyond a plane of symmetry acts on this side as its image.
            if (own) sums.force += Reflection::back_from(touch.from, space_).of_vector(touch.force);
            if (met) sums.force -= Reflection::back_from(touch.at, space_).of_vector(touch.force);
            if (!own && !met) continue;
            sums.area += touch.share * weight;
            on_piece += weight * touch.pressure;
        }
        if (size > 0) sums.pressure = std::max(sums.pressure, on_piece / size);
    }
    return sums;
}

/// The forces on a wall are those of its particles.
void SurfaceContact::show_on_walls(ParticleStore& particles, double dt) {
    std::unordered_map<std::int64_t, Vec> of_particle;
    for (std::size_t k = 0; k < impulse_on_walls_.size(); ++k) {
        if (impulse_on_walls_[k] == Vec::Zero()) continue;
        of_particle.try_emplace(surfaces_.pieces()[k].wall_particle, Vec::Zero()).first->second +=
            impulse_on_walls_[k] / dt;
        impulse_on_walls_[k] = Vec::Zero();
    }
    if (of_particle.empty()) return;
    ParticleGroup& walls = particles.of(PartKind::rigid);
    for (std::size_t i = 0; i < walls.owned(); ++i)
        if (const auto found = of_particle.find(walls.tags()[i].id); found != of_particle.end())
            for (int axis = 0; axis < walls.dimension(); ++axis)
                walls.data(Field::force, axis)[i] += found->second[axis];
}

void SurfaceContact::archive_deepest(Archive& file) {
    auto& [depth, time, place, parts] = deepest_of_all_;
    std::array<double, 3> at{place[0], place[1], place[2]}, of_parts{double(parts[0]), double(parts[1]), 0};
    file("contact/depth", depth);
    file("contact/time", time);
    file("contact/place", at);
    file("contact/parts_of_depth", of_parts);
    place = Vec(at[0], at[1], at[2]);
    for (std::size_t k = 0; k < 2; ++k) {
        parts[k] = static_cast<int>(of_parts[k]);
        if (parts[k] < 0 || index_of(parts[k]) >= space_.parts.size())
            throw unlike_any_run("contact of a part that is not there");
    }
}

void SurfaceContact::archive(Archive& file) {
    std::vector<double> parts, gaps;
    std::vector<Vector<double, 3>> slips;
    for (const Memory& memory : memory_) {
        parts.push_back(memory.solid);
        gaps.push_back(memory.gap);
        slips.push_back({memory.slip[0], memory.slip[1], memory.slip[2]});
    }
    std::vector<double> starts, start_gaps;
    for (const Start& start : start_) {
        starts.push_back(start.solid);
        start_gaps.push_back(start.gap);
    }
    const std::size_t points = memory_.size();
    file("contact/solids", parts);
    file("contact/gaps", gaps);
    file("contact/starts", starts);
    file("contact/start_gaps", start_gaps);
    if (law_.friction > 0) file("contact/slips", slips);
    if (!file.starts_run()) archive_deepest(file);
    if (!file.loading()) return;
    if (parts.size() != points || gaps.size() != points || slips.size() != points || starts.size() != points ||
        start_gaps.size() != points)
        throw unlike_any_run("contact of other surfaces");
    examined_.clear();
    for (std::size_t k = 0; k < surfaces_.pieces().size(); ++k) examined_.push_back(static_cast<int>(k));
    for (std::size_t k = 0; k < points; ++k) {
        memory_[k] = {static_cast<int>(parts[k]), gaps[k], Vec(slips[k][0], slips[k][1], slips[k][2])};
        start_[k] = {static_cast<int>(starts[k]), start_gaps[k]};
    }
}

}  // namespace dmp::solver
