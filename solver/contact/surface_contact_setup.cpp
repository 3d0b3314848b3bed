// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// How stiff contact is, and what touches where bodies were drawn.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "base/length_text.hpp"
#include "models/elastic/strain.hpp"
#include "solver/contact/surface_contact.hpp"

namespace dmp::solver {

namespace {

/// How far behind a surface contact looks [spacings].
constexpr double looks_behind = 1;
/// Films that are not thicker than this are not resolved by particles [spacings].
constexpr double thickest_film = 1;
/// Surfaces drawn deeper into each other than this overlap; else their contact begins there [spacings].
constexpr double deepest_start = 0.2;
/// The time step, or a part of it, as a fraction of the largest stable one.
constexpr double step_factor = 0.8;

ContactStepping stepping_of(const Scene& scene, const SpringBodies& bodies) {
    if (scene.parts_of(PartKind::fluid).empty()) return ContactStepping::in_parts;
    return bodies.implicit() ? ContactStepping::at_end : ContactStepping::at_start;
}

}  // namespace

SurfaceContact::SurfaceContact(const Scene& scene, const ParticleSet& set, const SpringBodies& bodies,
                               double longest_step, double viscosity, int threads)
    : space_(static_cast<const ParticleSpace&>(set)),
      threads_(threads),
      law_{scene.contact.friction, scene.contact.damping},
      given_stiffness_(scene.contact.stiffness),
      at_walls_(scene.contact.stiffness > 0 ? 1 : 2),
      stepping_(stepping_of(scene, bodies)),
      deepest_(looks_behind * set.spacing),
      surfaces_(set, bodies),
      pairs_(space_, deepest_) {
    if (viscosity > 0 && stepping_ == ContactStepping::at_end)
        films_.emplace(LiquidFilmLaw{viscosity, thickest_film * set.spacing}, surfaces_);
    const std::size_t points = surfaces_.pieces().size() * surfaces_.points().size();
    memory_.resize(points);
    start_.resize(points);
    near_.resize(points);
    is_drawn_inside_.resize(points, false);
    on_walls_.resize(surfaces_.pieces().size());
    impulse_on_walls_.resize(surfaces_.pieces().size(), Vec::Zero());
    find_bodies(bodies);
    find_stiffness(scene, bodies, longest_step);
    find_start(scene, bodies);
}

void SurfaceContact::find_bodies(const SpringBodies& bodies) {
    surfaces_.find_bodies(bodies);
    pairs_.forget();
    position_.assign(surfaces_.unknowns(), Vec::Zero());
    velocity_ = force_ = position_;
    control_velocity_.assign(surfaces_.controls(), Vec::Zero());
    control_force_ = control_velocity_;
    touches_.clear();
    touched_controls_.clear();
    is_touched_.assign(surfaces_.controls(), false);
    inverse_mass_.clear();
    for (const auto& body : bodies.bodies())
        for (std::size_t n = 0; n < body->unknowns(); ++n)
            inverse_mass_.push_back(body->unknown_fixed(n) ? 0 : 1 / body->unknown_mass(n));
    rate_.clear();
    for (std::size_t part = 0; part < space_.parts.size(); ++part)
        rate_.push_back(rate_of_full_touch(static_cast<int>(part)));
}

/// Largest eigenvalue of M^-1 K of the contact of all of a part's surface with something rigid, of stiffness 1, by
/// power iteration from below.
double SurfaceContact::rate_of_full_touch(int part) const {
    constexpr int iterations = 60;
    constexpr double below = 1.05;
    std::vector<int> controls;
    for (const auto& of : surfaces_.pieces())
        if (of.part == part && of.is_there && !of.is_wall)
            controls.insert(controls.end(), of.control.begin(),
                            of.control.begin() + static_cast<std::ptrdiff_t>(of.now.controls()));
    if (controls.empty()) return 0;
    std::ranges::sort(controls);
    controls.erase(std::unique(controls.begin(), controls.end()), controls.end());
    std::vector<Vec> mode(position_.size());
    for (std::size_t n = 0; n < mode.size(); ++n) {
        const auto number_of_it = static_cast<double>(n + 1);
        mode[n] = Vec(std::sin(1.7 * number_of_it), std::cos(2.3 * number_of_it), 0);
        if (space_.dimension == 3) mode[n][2] = std::sin(1.3 * number_of_it);
    }
    double largest = 0;
    std::vector<Vec> of_control(surfaces_.controls()), on_control(surfaces_.controls()), image(mode.size());
    for (int k = 0; k < iterations; ++k) {
        for (const int control : controls) {
            of_control[index_of(control)] = surfaces_.carried(control, mode);
            on_control[index_of(control)] = Vec::Zero();
        }
        for (const auto& of : surfaces_.pieces()) {
            if (of.part != part || !of.is_there) continue;
            for (std::size_t p = 0; p < surfaces_.points().size(); ++p) {
                const PiecePlace& place = surfaces_.points()[p].place;
                const Vec normal = of.at_rest.normal(place);
                const auto shares = of.at_rest.shares(place);
                double moved = 0;
                for (std::size_t c = 0; c < of.now.controls(); ++c)
                    moved += shares[c] * of_control[index_of(of.control[c])].dot(normal);
                for (std::size_t c = 0; c < of.now.controls(); ++c)
                    on_control[index_of(of.control[c])] += shares[c] * of.weight[p] * moved * normal;
            }
        }
        std::ranges::fill(image, Vec::Zero());
        for (const int control : controls)
            for (const auto& share : surfaces_.carriers(control))
                image[index_of(share.unknown)] +=
                    inverse_mass_[index_of(share.unknown)] * share.of(on_control[index_of(control)]);
        double square = 0;
        for (const Vec& of_unknown : image) square += of_unknown.squaredNorm();
        if (square == 0) return 0;
        largest = std::sqrt(square);
        for (std::size_t n = 0; n < mode.size(); ++n) mode[n] = image[n] / largest;
    }
    return below * largest;
}

/// Implicit contact: 6 M / h (M = lambda + 2 mu). Else as stiff as the step allows, up to 10 M / h, and where steps may
/// be taken in parts at least 3 M / h, with which a pressure p goes p / 3 M spacings deep. For thin bodies, which give
/// way, it is what stops them within a swing on the contact, k = rho T v^2 / d^2, if that is less.
void SurfaceContact::find_stiffness(const Scene& scene, const SpringBodies& bodies, double longest_step) {
    constexpr double of_step_at_most = 10, of_implicit = 6, of_parts = 3;  // over M / h
    constexpr double depth = 0.04;                                         // [spacings]
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const double spacing = space_.spacing;
    const double of_step = std::pow(2 * step_factor / longest_step, 2) / (2 * law_.stiffening());
    const double speed = scene.flow.largest_speed > 0 ? scene.flow.largest_speed.value
                                                      : scene.numerics.mach_number * scene.numerics.sound_speed;
    for (std::size_t part = 0; part < space_.parts.size(); ++part) {
        if (rate_[part] == 0 || given_stiffness_ > 0) {
            stiffness_.push_back(rate_[part] == 0 ? infinite : given_stiffness_);
            continue;
        }
        // A square lattice swings with 8 (c / h)^2 at most, and its surface has rho h / 2 per area.
        double of_body = infinite, thickness = 0;
        for (const SpringBodies::PartLimit& limit : bodies.step_limits())
            if (limit.part == space_.parts[part].name) of_body = 4 / (limit.dt * limit.dt) / (4 * rate_[part]);
        const Part& material = scene.part_of_particles(space_.parts[part].name);
        if (material.model == ElasticModel::cells && material.youngs_modulus > 0) {
            const LameConstants constants = LameConstants::of(material.youngs_modulus, material.poisson_ratio);
            of_body = (constants.lambda + 2 * constants.mu) / spacing;
        }
        for (const auto& piece : surfaces_.pieces())
            if (index_of(piece.part) == part) thickness = std::max(thickness, piece.thickness);
        const double density = 2 / (rate_[part] * spacing);
        const bool is_thin = thickness < 2.9 * spacing;
        const double by_swing = is_thin ? density * thickness * std::pow(speed / (depth * spacing), 2) : infinite;
        const double by_step = std::min(of_step / rate_[part], of_step_at_most * of_body);
        switch (stepping_) {
            case ContactStepping::at_start:
                stiffness_.push_back(by_step);
                break;
            case ContactStepping::in_parts:
                stiffness_.push_back(
                    std::max(by_step, std::min(by_swing, std::isfinite(of_body) ? of_parts * of_body : 0)));
                break;
            case ContactStepping::at_end:
                // The limit of a joined body is that of the first of its parts.
                stiffness_.push_back(std::isfinite(of_body) ? of_implicit * of_body : by_step);
                break;
        }
    }
}

double SurfaceContact::step_limit() const {
    double fastest = 0;
    for (std::size_t a = 0; a < rate_.size(); ++a) {
        if (!std::isfinite(stiffness_[a])) continue;
        fastest = std::max(fastest, at_walls_ * stiffness_[a] * rate_[a]);
        for (std::size_t b = 0; b < rate_.size(); ++b)
            fastest = std::max(fastest, 2 * std::min(stiffness_[a], stiffness_[b]) * std::max(rate_[a], rate_[b]));
    }
    return step_factor * 2 / std::sqrt(law_.stiffening() * fastest);
}

/// Where surfaces are drawn into each other, their gap counts from there; bodies that are free must not overlap.
void SurfaceContact::find_start(const Scene& scene, const SpringBodies& bodies) {
    read_bodies(bodies);
    surfaces_.place(position_, nullptr, threads_);
    find_pairs();
    find_touches(0, true);
    const auto is_held = [&](int number, const PiecePlace& place) {
        const auto& of = piece(number);
        if (of.is_wall) return true;
        const auto shares = of.now.shares(place);
        for (std::size_t c = 0; c < of.now.controls(); ++c)
            for (const auto& share : surfaces_.carriers(of.control[c]))
                if (inverse_mass_[index_of(share.unknown)] == 0 && std::abs(shares[c] * share.share) > 1e-9)
                    return true;
        return false;
    };
    std::vector<Start> starts(start_.size());
    for (const Touch& touch : touches_) {
        const auto &own = piece(touch.own), &other = piece(touch.other);
        starts[index_of(touch.own, touch.number)] = {other.solid, touch.gap};
        const bool is_joined = own.is_wall ? is_held(touch.other, touch.place) : is_held(touch.own, place_of(touch));
        if (is_joined || -touch.gap < deepest_start * space_.spacing) continue;
        throw InputError(scene.contact.between.location,
                         "'" + space_.parts[index_of(own.part)].name + "' and '" +
                             space_.parts[index_of(other.part)].name + "' overlap at the start, by " +
                             length_text(-touch.gap) + " at " + position_text(touch.from, space_.dimension),
                         "draw them apart, or write [contact] between = \"particles\"");
    }
    start_ = starts;
    for (const int number : pairs_.active())
        for (std::size_t p = 0; p < surfaces_.points().size(); ++p) {
            int other = -1;
            is_drawn_inside_[index_of(number, p)] = depth_behind(number, p, other) > 0;
        }
    touches_.clear();
    for (Memory& memory : memory_) memory = {};
}

}  // namespace dmp::solver
