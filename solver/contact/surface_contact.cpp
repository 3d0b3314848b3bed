// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/surface_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "base/errors.hpp"
#include "base/length_text.hpp"
#include "models/elastic/strain.hpp"
#include "solver/state/loaded_groups.hpp"

namespace dmp::solver {

namespace {

constexpr std::size_t points_of_piece = ContactSurfaces::points_of_piece;
/// How far behind a surface contact looks [spacings].
constexpr double looks_behind = 1;
/// Normals of surfaces that touch have a cosine below this.
constexpr double most_facing = -0.3;
/// Surfaces drawn deeper into each other than this overlap; else their contact begins there [spacings].
constexpr double deepest_start = 0.2;
/// The time step, or a part of it, as a fraction of the largest stable one.
constexpr double step_factor = 0.8;
constexpr double most_parts = 1e6;

std::size_t number(int index) { return static_cast<std::size_t>(index); }

/// In liquid, kicks of the fluid meet modes of the bodies that the implicit step of a whole one does not have: leaflets
/// of springs and stiff bodies of cells diverged.
bool may_take_parts(const Scene& scene) { return scene.parts_of(PartKind::fluid).empty(); }

}  // namespace

SurfaceContact::SurfaceContact(const Scene& scene, const ParticleSet& set, const SpringBodies& bodies,
                               double longest_step, int threads)
    : space_(static_cast<const ParticleSpace&>(set)),
      threads_(threads),
      law_{scene.contact.friction, scene.contact.damping},
      given_stiffness_(scene.contact.stiffness),
      at_walls_(scene.contact.stiffness > 0 ? 1 : 2),
      in_parts_(may_take_parts(scene)),
      deepest_(looks_behind * set.spacing),
      surfaces_(set, bodies),
      pairs_(space_, deepest_) {
    const std::size_t points = surfaces_.pieces().size() * points_of_piece;
    touches_.resize(points);
    memory_.resize(points);
    start_.resize(points);
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
    inverse_mass_.clear();
    for (const auto& body : bodies.bodies())
        for (std::size_t n = 0; n < body->unknowns(); ++n)
            inverse_mass_.push_back(body->unknown_fixed(n) ? 0 : 1 / body->unknown_mass(n));
    rate_.clear();
    for (std::size_t part = 0; part < space_.parts.size(); ++part)
        rate_.push_back(rate_of_full_touch(static_cast<int>(part)));
}

void SurfaceContact::read_bodies(const SpringBodies& bodies) {
    for (std::size_t b = 0; b < bodies.bodies().size(); ++b)
        for (std::size_t n = 0; n < bodies.bodies()[b]->unknowns(); ++n) {
            position_[surfaces_.first_unknown()[b] + n] = bodies.bodies()[b]->unknown_position(n);
            velocity_[surfaces_.first_unknown()[b] + n] = bodies.bodies()[b]->unknown_velocity(n);
        }
}

/// Largest eigenvalue of M^-1 K of the contact of all of a part's surface with something rigid, of stiffness 1, by
/// power iteration from below.
double SurfaceContact::rate_of_full_touch(int part) const {
    constexpr int iterations = 60;
    constexpr double below = 1.05;
    std::vector<Vec> mode(position_.size());
    for (std::size_t n = 0; n < mode.size(); ++n) {
        const auto number_of_it = static_cast<double>(n + 1);
        mode[n] = Vec(std::sin(1.7 * number_of_it), std::cos(2.3 * number_of_it), 0);
    }
    double largest = 0;
    for (int k = 0; k < iterations; ++k) {
        std::vector<Vec> image(mode.size(), Vec::Zero());
        for (std::size_t p = 0; p < surfaces_.pieces().size(); ++p) {
            const auto& piece = surfaces_.pieces()[p];
            if (piece.part != part || !piece.is_there) continue;
            for (std::size_t point = 0; point < points_of_piece; ++point) {
                const Vec normal = piece.at_rest.normal(gauss_points[point]);
                double moved = 0;
                const auto each = [&](const auto& visit) {
                    surfaces_.for_each_share(static_cast<int>(p), gauss_points[point], visit);
                };
                each([&](int unknown, double share) { moved += share * mode[number(unknown)].dot(normal); });
                each([&](int unknown, double share) {
                    image[number(unknown)] +=
                        share * piece.weight[point] * moved * inverse_mass_[number(unknown)] * normal;
                });
            }
        }
        double square = 0;
        for (const Vec& of_unknown : image) square += of_unknown.squaredNorm();
        if (square == 0) return 0;
        largest = std::sqrt(square);
        for (std::size_t n = 0; n < mode.size(); ++n) mode[n] = image[n] / largest;
    }
    return below * largest;
}

/// As stiff as the step allows, up to 10 M / h (M = lambda + 2 mu). Where steps may be taken in parts, also as stiff as
/// bodies need that meet with the largest speed of the flow, up to 3 M / h: they are stopped by the pressure of an
/// elastic wave, rho c v, thin ones within a swing on the contact, k = rho T v^2 / d^2.
void SurfaceContact::find_stiffness(const Scene& scene, const SpringBodies& bodies, double longest_step) {
    constexpr double of_step_at_most = 10, at_most = 3;  // over M / h
    constexpr double depth = 0.04;                       // [spacings]
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
            if (number(piece.part) == part) thickness = std::max(thickness, piece.thickness);
        const double density = 2 / (rate_[part] * spacing);
        const double by_wave = std::sqrt(density * of_body * spacing) * speed / (depth * spacing);
        const bool is_thin = thickness < 2.9 * spacing;
        const double by_swing = is_thin ? density * thickness * std::pow(speed / (depth * spacing), 2) : infinite;
        const double by_step = std::min(of_step / rate_[part], of_step_at_most * of_body);
        stiffness_.push_back(in_parts_ ? std::max(by_step, std::min({at_most * of_body, by_wave, by_swing})) : by_step);
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

double SurfaceContact::stiffness_of(int piece, int other) const {
    const auto &own = surfaces_.pieces()[number(piece)], &met = surfaces_.pieces()[number(other)];
    return (own.is_wall || met.is_wall ? at_walls_ : 1) *
           std::min(stiffness_[number(own.part)], stiffness_[number(met.part)]);
}

/// Where surfaces are drawn into each other, their gap counts from there; bodies that are free must not overlap.
void SurfaceContact::find_start(const Scene& scene, const SpringBodies& bodies) {
    read_bodies(bodies);
    surfaces_.place(position_, nullptr, threads_);
    pairs_.update(surfaces_);
    find_touches();
    const auto is_held = [&](int piece, double t) {
        bool held = surfaces_.pieces()[number(piece)].is_wall;
        surfaces_.for_each_share(piece, t, [&](int unknown, double share) {
            held = held || (inverse_mass_[number(unknown)] == 0 && std::abs(share) > 1e-9);
        });
        return held;
    };
    std::vector<Start> starts(touches_.size());
    for (std::size_t point = 0; point < touches_.size(); ++point) {
        const Touch& touch = touches_[point];
        if (!touch.is_one) continue;
        const int piece = static_cast<int>(point / points_of_piece);
        const auto& own = surfaces_.pieces()[number(piece)];
        const auto& other = surfaces_.pieces()[number(touch.piece)];
        starts[point] = {other.solid, touch.gap};
        const bool is_joined =
            is_held(own.is_wall ? touch.piece : piece, own.is_wall ? touch.t : gauss_points[point % points_of_piece]);
        if (is_joined || -touch.gap < deepest_start * space_.spacing) continue;
        throw InputError(scene.contact.between.location,
                         "'" + space_.parts[number(own.part)].name + "' and '" + space_.parts[number(other.part)].name +
                             "' overlap at the start, by " + length_text(-touch.gap) + " at " +
                             position_text(touch.from, space_.dimension),
                         "draw them apart, or write [contact] between = \"particles\"");
    }
    start_ = starts;
    for (Touch& touch : touches_) touch = {};
    for (Memory& memory : memory_) memory = {};
}

/// The gap of a point before the place t of a piece; `normal` out of it, along the gap.
double SurfaceContact::gap_at(const Vec& from, int piece, double t, const Vec& shift, Vec& normal) const {
    const auto& other = surfaces_.pieces()[number(piece)];
    const Vec off = from - (other.now.at(t) + shift);
    normal = other.now.normal(t);
    const int beside = t == 0 ? other.previous : t == 1 ? other.next : -1;
    const bool is_end = t == 0 || t == 1;
    if (!is_end) return off.dot(normal);
    // A corner: in front of it is where the mean of the normals beside it points to.
    Vec mean = normal;
    if (beside >= 0) mean += surfaces_.pieces()[number(beside)].now.normal(t == 0 ? 1 : 0);
    const double distance = off.norm(), gap = off.dot(mean) < 0 ? -distance : distance;
    if (distance > 1e-9 * space_.spacing) normal = off / gap;
    return gap;
}

SurfaceContact::Touch SurfaceContact::touch_of(int piece, std::size_t point) const {
    const auto& own = surfaces_.pieces()[number(piece)];
    const std::size_t index = number(piece) * points_of_piece + point;
    Touch touch;
    touch.from = own.now.at(gauss_points[point]);
    const Vec facing_from = own.now.normal(gauss_points[point]);
    double nearest = deepest_ * deepest_;
    Vec shift = Vec::Zero();
    for (const PiecePairs::Other& other : pairs_.others(piece)) {
        const CurvePiece& curve = surfaces_.pieces()[number(other.piece)].now;
        // Nothing of the curve is nearer than the box around it.
        const Vec at = touch.from - other.shift;
        const auto [low, high] = curve.box();
        if ((low - at).cwiseMax(at - high).cwiseMax(0).squaredNorm() >= nearest) continue;
        const double t = curve.nearest(at);
        const double square = (at - curve.at(t)).squaredNorm();
        if (square >= nearest || curve.normal(t).dot(facing_from) > most_facing) continue;
        nearest = square;
        touch.piece = other.piece;
        touch.t = t;
        shift = other.shift;
    }
    if (touch.piece < 0) return touch;
    const auto& other = surfaces_.pieces()[number(touch.piece)];
    touch.gap = gap_at(touch.from, touch.piece, touch.t, shift, touch.normal);
    touch.at = other.now.at(touch.t) + shift;
    // What a thin body has passed through in one step it is beyond; once it touches, it is followed deeper.
    const bool touched = memory_[index].solid == other.solid;
    const double deepest = touched ? deepest_ : std::min(deepest_, 0.5 * (own.thickness + other.thickness));
    touch.is_apart = touch.gap > 0;
    if (start_[index].solid == other.solid) touch.gap -= start_[index].gap;
    if (-touch.gap > deepest) return touch;
    // Beyond a corner that sticks out, or an end, there is nothing.
    const bool is_beyond = (touch.t == 0 && (other.is_sharp[0] || other.previous < 0)) ||
                           (touch.t == 1 && (other.is_sharp[1] || other.next < 0));
    touch.is_one = touch.gap < 0 && !is_beyond;
    const double here = ContactSurfaces::weight(own, gauss_points[point]).value;
    const auto [there, slope] = ContactSurfaces::weight(other, touch.t);
    touch.share = there / (here + there);
    touch.share_slope = slope * here / ((here + there) * (here + there));
    return touch;
}

void SurfaceContact::find_touches() {
    const auto count = static_cast<std::ptrdiff_t>(surfaces_.pieces().size());
#pragma omp parallel for num_threads(threads_) schedule(dynamic, 16)
    for (std::ptrdiff_t k = 0; k < count; ++k)
        for (std::size_t p = 0; p < points_of_piece; ++p) {
            const std::size_t index = static_cast<std::size_t>(k) * points_of_piece + p;
            touches_[index] = pairs_.others(static_cast<int>(k)).empty() ? Touch{} : touch_of(static_cast<int>(k), p);
            const Touch& touch = touches_[index];
            const int other = touch.piece < 0 ? no_solid : surfaces_.pieces()[number(touch.piece)].solid;
            // What was drawn into another solid has left it once it is in front of it.
            if (start_[index].solid != other || touch.is_apart) start_[index] = {};
            const int touched = touch.is_one ? other : no_solid;
            if (memory_[index].solid != touched) memory_[index] = {touched, Vec::Zero()};
        }
}

Vec SurfaceContact::velocity_at(int piece, double t, const WallMotion& walls, double time) const {
    const auto& of = surfaces_.pieces()[number(piece)];
    if (of.is_wall) return walls.velocity(static_cast<std::uint16_t>(of.part), of.at_rest.at(t), time);
    Vec velocity = Vec::Zero();
    surfaces_.for_each_share(piece, t,
                             [&](int unknown, double share) { velocity += share * velocity_[number(unknown)]; });
    return velocity;
}

/// Opposite forces across an arm turn the bodies; the piece takes that at its ends.
void SurfaceContact::add_couple(int piece, const Vec& arm, const Vec& force) {
    const auto& control = surfaces_.pieces()[number(piece)].now.control;
    const Vec chord = control[2] - control[0];
    const double moment = arm[0] * force[1] - arm[1] * force[0];
    const Vec at_end = -moment / chord.squaredNorm() * Vec(-chord[1], chord[0], 0);
    surfaces_.for_each_share_of_chord(piece,
                                      [&](int unknown, double share) { force_[number(unknown)] += share * at_end; });
}

void SurfaceContact::add_forces(const WallMotion& walls, double t, double dt) {
    std::ranges::fill(force_, Vec::Zero());
    std::ranges::fill(on_walls_, Vec::Zero());
    const bool needs_velocity = law_.friction > 0 || law_.damping > 0;
    const auto push = [&](int piece, double at, const Vec& force) {
        if (surfaces_.pieces()[number(piece)].is_wall) on_walls_[number(piece)] += force;
        surfaces_.for_each_share(piece, at,
                                 [&](int unknown, double share) { force_[number(unknown)] += share * force; });
    };
    for (std::size_t index = 0; index < touches_.size(); ++index) {
        const Touch& touch = touches_[index];
        if (!touch.is_one) continue;
        const int piece = static_cast<int>(index / points_of_piece);
        const auto& own = surfaces_.pieces()[number(piece)];
        const double at = gauss_points[index % points_of_piece],
                     area = touch.share * own.weight[index % points_of_piece];
        const double stiffness = stiffness_of(piece, touch.piece);
        if (!std::isfinite(stiffness)) continue;  // both are held

        Vec past = Vec::Zero();
        if (needs_velocity) past = velocity_at(piece, at, walls, t) - velocity_at(touch.piece, touch.t, walls, t);
        const double inverse_mass =
            rate_[number(own.part)] + rate_[number(surfaces_.pieces()[number(touch.piece)].part)];
        const double mass_per_area = inverse_mass > 0 ? 1 / inverse_mass : 0;
        const double pressure = law_.pressure(stiffness, touch.gap, past.dot(touch.normal), mass_per_area);
        // Towards where there is more of the contact, its energy grows.
        Vec tangential = Vec::Zero();
        if (touch.share_slope != 0) {
            tangential = -touch.share_slope * own.weight[index % points_of_piece] *
                         SurfaceContactLaw::energy(stiffness, touch.gap) *
                         surfaces_.pieces()[number(touch.piece)].now.tangent(touch.t).normalized();
            add_couple(touch.piece, touch.from - touch.at, tangential);
        }
        if (law_.friction > 0) {
            Vec& slip = memory_[index].slip;
            const double length = slip.norm();
            slip -= slip.dot(touch.normal) * touch.normal;
            if (slip.norm() > 0) slip *= length / slip.norm();
            slip += dt * (past - past.dot(touch.normal) * touch.normal);
            const Vec friction = area * law_.traction(stiffness, pressure, slip);
            add_couple(piece, touch.from - touch.at, friction);
            tangential += friction;
        }
        const Vec force = area * pressure * touch.normal + tangential;
        push(piece, at, force);
        push(touch.piece, touch.t, -force);

        if (-touch.gap > deepest_of_all_.depth)
            deepest_of_all_ = {-touch.gap, t, touch.from, {own.part, surfaces_.pieces()[number(touch.piece)].part}};
    }
}

int SurfaceContact::parts_of_step(const SpringBodies& bodies, const WallMotion& walls, double t, double dt) {
    const double parts = std::ceil(dt / step_limit() * (1 - 1e-9));
    if (!in_parts_ || !(parts > 1)) return 1;
    read_bodies(bodies);
    surfaces_.place(position_, &walls, threads_);
    pairs_.update(surfaces_);
    double fastest = walls.largest_speed(t);
    for (const Vec& velocity : velocity_) fastest = std::max(fastest, velocity.norm());
    // Bodies may be as fast again at the end of the step as they are now.
    return pairs_.nearest(surfaces_) <= 4 * fastest * dt ? static_cast<int>(std::min(parts, most_parts)) : 1;
}

SurfaceContact::Impulses SurfaceContact::kick(SpringBodies& bodies, const WallMotion& walls, double t, double dt) {
    read_bodies(bodies);
    surfaces_.place(position_, &walls, threads_);
    pairs_.update(surfaces_);
    find_touches();
    add_forces(walls, t, dt);
    Impulses impulses{Vec::Zero(), Vec::Zero()};
    for (std::size_t b = 0; b < bodies.bodies().size(); ++b)
        impulses.of_supports += bodies.bodies()[b]->kick(std::span(force_).subspan(surfaces_.first_unknown()[b]), dt);
    for (std::size_t k = 0; k < on_walls_.size(); ++k) {
        impulse_on_walls_[k] += dt * on_walls_[k];
        impulses.on_walls += dt * on_walls_[k];
    }
    return impulses;
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
        if (parts[k] < 0 || number(parts[k]) >= space_.parts.size())
            throw unlike_any_run("contact of a part that is not there");
    }
}

void SurfaceContact::archive(Archive& file) {
    std::vector<double> parts;
    std::vector<Vector<double, 3>> slips;
    for (const Memory& memory : memory_) {
        parts.push_back(memory.solid);
        slips.push_back({memory.slip[0], memory.slip[1], memory.slip[2]});
    }
    std::vector<double> starts, start_gaps;
    for (const Start& start : start_) {
        starts.push_back(start.solid);
        start_gaps.push_back(start.gap);
    }
    const std::size_t points = memory_.size();
    file("contact/solids", parts);
    file("contact/starts", starts);
    file("contact/start_gaps", start_gaps);
    if (law_.friction > 0) file("contact/slips", slips);
    if (!file.starts_run()) archive_deepest(file);
    if (!file.loading()) return;
    if (parts.size() != points || slips.size() != points || starts.size() != points || start_gaps.size() != points)
        throw unlike_any_run("contact of other surfaces");
    for (std::size_t k = 0; k < points; ++k) {
        memory_[k] = {static_cast<int>(parts[k]), Vec(slips[k][0], slips[k][1], slips[k][2])};
        start_[k] = {static_cast<int>(starts[k]), start_gaps[k]};
    }
}

}  // namespace dmp::solver
