// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/surface_contact.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "solver/state/loaded_groups.hpp"

namespace dmp::solver {

namespace {

/// Normals of surfaces that touch have a cosine below this.
constexpr double most_facing = -0.3;
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
    pairs_.update(surfaces_);
}

/// How far surfaces may approach each other in this step, if nothing is more than twice as fast as it is now [m].
double SurfaceContact::farthest_way() const {
    double fastest = walls_->largest_speed(t_);
    for (const Vec& velocity : velocity_) fastest = std::max(fastest, velocity.norm());
    return 4 * fastest * dt_;
}

double SurfaceContact::stiffness_of(int piece, int other) const {
    const auto &own = surfaces_.pieces()[index_of(piece)], &met = surfaces_.pieces()[index_of(other)];
    return (own.is_wall || met.is_wall ? at_walls_ : 1) *
           std::min(stiffness_[index_of(own.part)], stiffness_[index_of(met.part)]);
}

/// The gap of a point before the place t of a piece; `normal` out of it, along the gap.
double SurfaceContact::gap_at(const Vec& from, int piece, double t, const Vec& shift, Vec& normal) const {
    const auto& other = surfaces_.pieces()[index_of(piece)];
    const Vec off = from - (other.now.at(t) + shift);
    normal = other.now.normal(t);
    const int beside = t == 0 ? other.previous : t == 1 ? other.next : -1;
    const bool is_end = t == 0 || t == 1;
    if (!is_end) return off.dot(normal);
    // A corner: in front of it is where the mean of the normals beside it points to.
    Vec mean = normal;
    if (beside >= 0) mean += surfaces_.pieces()[index_of(beside)].now.normal(t == 0 ? 1 : 0);
    const double distance = off.norm(), gap = off.dot(mean) < 0 ? -distance : distance;
    if (distance > 1e-9 * space_.spacing) normal = off / gap;
    return gap;
}

SurfaceContact::Touch SurfaceContact::touch_of(int piece, std::size_t point, double margin) const {
    const auto& own = surfaces_.pieces()[index_of(piece)];
    const std::size_t index = index_of(piece) * points_of_piece + point;
    Touch touch;
    touch.from = own.now.at(gauss_points[point]);
    const Vec facing_from = own.now.normal(gauss_points[point]);
    double nearest = deepest_ * deepest_;
    Vec shift = Vec::Zero();
    for (const PiecePairs::Other& other : pairs_.others(piece)) {
        const CurvePiece& curve = surfaces_.pieces()[index_of(other.piece)].now;
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
    const auto& other = surfaces_.pieces()[index_of(touch.piece)];
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
    touch.is_one = touch.gap < margin && !is_beyond && !(is_held_[index_of(piece)] && is_held_[index_of(touch.piece)]);
    const double here = ContactSurfaces::weight(own, gauss_points[point]).value;
    const auto [there, slope] = ContactSurfaces::weight(other, touch.t);
    touch.share = there / (here + there);
    touch.share_slope = slope * here / ((here + there) * (here + there));
    return touch;
}

void SurfaceContact::find_touches(double margin) {
    const auto count = static_cast<std::ptrdiff_t>(surfaces_.pieces().size());
#pragma omp parallel for num_threads(threads_) schedule(dynamic, 16)
    for (std::ptrdiff_t k = 0; k < count; ++k)
        for (std::size_t p = 0; p < points_of_piece; ++p) {
            const std::size_t index = static_cast<std::size_t>(k) * points_of_piece + p;
            touches_[index] =
                pairs_.others(static_cast<int>(k)).empty() ? Touch{} : touch_of(static_cast<int>(k), p, margin);
            const Touch& touch = touches_[index];
            const int other = touch.piece < 0 ? no_solid : surfaces_.pieces()[index_of(touch.piece)].solid;
            // What was drawn into another solid has left it once it is in front of it.
            if (start_[index].solid != other || touch.is_apart) start_[index] = {};
            if (memory_[index].solid != (touch.is_one ? other : no_solid)) memory_[index] = {};
        }
}

/// [m/s]
Vec SurfaceContact::velocity_at(int piece, double t) const {
    const auto& of = surfaces_.pieces()[index_of(piece)];
    if (of.is_wall) return walls_->velocity(static_cast<std::uint16_t>(of.part), of.at_rest.at(t), t_);
    Vec velocity = Vec::Zero();
    surfaces_.for_each_share(piece, t,
                             [&](int unknown, double share) { velocity += share * velocity_[index_of(unknown)]; });
    return velocity;
}

/// Opposite forces across an arm turn the bodies; the piece takes that at its ends.
void SurfaceContact::add_couple(int piece, const Vec& arm, const Vec& force) {
    const auto& control = surfaces_.pieces()[index_of(piece)].now.control;
    const Vec chord = control[2] - control[0];
    const double moment = arm[0] * force[1] - arm[1] * force[0];
    const Vec at_end = -moment / chord.squaredNorm() * Vec(-chord[1], chord[0], 0);
    surfaces_.for_each_share_of_chord(piece,
                                      [&](int unknown, double share) { force_[index_of(unknown)] += share * at_end; });
}

void SurfaceContact::push(int piece, double t, const Vec& force) {
    if (surfaces_.pieces()[index_of(piece)].is_wall) on_walls_[index_of(piece)] += force;
    surfaces_.for_each_share(piece, t, [&](int unknown, double share) { force_[index_of(unknown)] += share * force; });
}

void SurfaceContact::find_forces(double ahead, bool remembers) {
    std::ranges::fill(force_, Vec::Zero());
    std::ranges::fill(on_walls_, Vec::Zero());
    for (std::size_t point = 0; point < touches_.size(); ++point)
        if (touches_[point].is_one) add_force(point, ahead, remembers);
}

void SurfaceContact::add_force(std::size_t point, double ahead, bool remembers) {
    Touch& touch = touches_[point];
    const int piece = static_cast<int>(point / points_of_piece);
    const auto &own = surfaces_.pieces()[index_of(piece)], &other = surfaces_.pieces()[index_of(touch.piece)];
    const double at = gauss_points[point % points_of_piece], weight = own.weight[point % points_of_piece];
    const double stiffness = stiffness_of(piece, touch.piece);
    const bool touched = touch.gap < 0;  // before this step: friction and dashpot begin after that

    Vec past = Vec::Zero();  // at which it passes
    double gap = touch.gap;
    if (ahead > 0 || law_.friction > 0 || law_.damping > 0) {
        const Vec of_own = velocity_at(piece, at), of_other = velocity_at(touch.piece, touch.t);
        past = of_own - of_other;
        // Walls are in the middle of the step when bodies are at its start.
        gap += ahead * ((own.is_wall ? 0.5 : 1) * of_own - (other.is_wall ? 0.5 : 1) * of_other).dot(touch.normal);
    }
    touch.normal_slope = touch.tangent_slope = touch.pressure = 0;
    touch.force.setZero();
    Vec slip = memory_[point].slip;
    if (gap < 0) {
        const double inverse_mass = rate_[index_of(own.part)] + rate_[index_of(other.part)];
        const double mass_per_area = inverse_mass > 0 ? 1 / inverse_mass : 0;
        const double pressure = law_.pressure(stiffness, gap, touched ? past.dot(touch.normal) : 0, mass_per_area);
        touch.pressure = pressure;
        const double area = touch.share * weight;
        if (pressure > 0)
            touch.normal_slope = area * (ahead * stiffness + (touched ? law_.dashpot(stiffness, mass_per_area) : 0));
        // Towards where there is more of the contact, its energy grows.
        Vec tangential = Vec::Zero();
        if (touch.share_slope != 0) {
            tangential = -touch.share_slope * weight * SurfaceContactLaw::energy(stiffness, gap) *
                         other.now.tangent(touch.t).normalized();
            add_couple(touch.piece, touch.from - touch.at, tangential);
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
            add_couple(piece, touch.from - touch.at, friction);
            tangential += friction;
        }
        const Vec force = area * pressure * touch.normal + tangential;
        push(piece, at, force);
        push(touch.piece, touch.t, -force);
        touch.force = force;
    }
    if (remembers) remember(point, gap, slip);
}

void SurfaceContact::remember(std::size_t point, double gap, const Vec& slip) {
    const Touch& touch = touches_[point];
    const auto& own = surfaces_.pieces()[point / points_of_piece];
    const auto& other = surfaces_.pieces()[index_of(touch.piece)];
    memory_[point] = gap < 0 ? Memory{other.solid, slip} : Memory{};
    if (-gap > deepest_of_all_.depth) deepest_of_all_ = {-gap, t_, touch.from, {own.part, other.part}};
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
    return pairs_.nearest(surfaces_) <= farthest_way() ? static_cast<int>(std::min(parts, most_parts)) : 1;
}

ContactImpulses SurfaceContact::kick(SpringBodies& bodies, const WallMotion& walls, double t, double dt) {
    place(bodies, walls, t, dt);
    find_touches(0);
    find_forces(0, true);
    ContactImpulses impulses{Vec::Zero(), impulse_on_walls()};
    for (std::size_t b = 0; b < bodies.bodies().size(); ++b)
        impulses.of_supports += bodies.bodies()[b]->kick(std::span(force_).subspan(surfaces_.first_unknown()[b]), dt);
    return impulses;
}

SurfaceContact::Sums SurfaceContact::sums(const std::string& part, const std::string& against) const {
    Sums sums;
    const auto is_of = [&](int piece, const std::string& name) {
        return name.empty() || space_.parts[index_of(surfaces_.pieces()[index_of(piece)].part)].name == name;
    };
    for (std::size_t k = 0; k < surfaces_.pieces().size(); ++k) {
        double on_piece = 0, length = 0;
        for (std::size_t p = 0; p < points_of_piece; ++p) {
            const Touch& touch = touches_[k * points_of_piece + p];
            const double weight = surfaces_.pieces()[k].weight[p];
            length += weight;
            if (!touch.is_one || !(touch.pressure > 0)) continue;
            const bool own = is_of(static_cast<int>(k), part) && is_of(touch.piece, against);
            const bool met = is_of(touch.piece, part) && is_of(static_cast<int>(k), against);
            if (own) sums.force += touch.force;
            if (met) sums.force -= touch.force;
            if (!own && !met) continue;
            sums.area += touch.share * weight;
            on_piece += weight * touch.pressure;
        }
        if (length > 0) sums.pressure = std::max(sums.pressure, on_piece / length);
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
