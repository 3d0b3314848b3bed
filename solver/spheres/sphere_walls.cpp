// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/sphere_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "base/closest_point.hpp"
#include "base/disjoint_sets.hpp"
#include "solver/spheres/triangle_grid.hpp"
#include "solver/state/loaded_groups.hpp"

namespace dmp::solver {

namespace {

/// Places closer than this part of a sphere's radius are one.
constexpr double one_position = 1e-6;
/// The cosine between the normals of touches of a smooth surface that are one contact, and of a contact now and of one
/// before on the same part, that it may come from.
constexpr double same_direction = 0.5;

Vec position_of(const SphereMotion& sphere) {
    return {sphere.position.c[0], sphere.position.c[1], sphere.position.c[2]};
}

Vector<double, 3> three(const Vec& v) { return {{v[0], v[1], v[2]}}; }

Vec closest_on(const Vec& position, const std::array<Vec, 3>& corners) {
    return closest_on_triangle(position, corners[0], corners[1], corners[2]);
}

}  // namespace

Vec SphereWalls::Motion::at(double t) const { return {velocity[0](t), velocity[1](t), velocity[2](t)}; }

SphereWalls::SphereWalls(const ParticleSpace& space, std::vector<std::array<Expression, 3>> velocity, WallPairs pairs)
    : space_(space),
      planes_(space.wall_planes),
      triangles_(space.wall_triangles),
      smooth_edges_(space),
      pairs_(std::move(pairs)) {
    for (auto& axes : velocity) {
        const bool moves = !std::ranges::all_of(axes, [](const Expression& axis) { return axis.is_zero(); });
        motion_.push_back({std::move(axes), moves});
    }
}

int SphereWalls::part_of(std::int32_t surface) const {
    const auto k = static_cast<std::size_t>(surface);
    return k < planes_.size() ? planes_[k].part : triangles_[k - planes_.size()].part;
}

std::array<Vec, 3> SphereWalls::corners_of(std::int32_t surface) const {
    const WallTriangle& triangle = triangles_[static_cast<std::size_t>(surface) - planes_.size()];
    const Vec& moved = motion_[static_cast<std::size_t>(triangle.part)].displacement;
    const auto corner = [&](int number) -> Vec {
        return space_.wall_corners[static_cast<std::size_t>(number)] + moved;
    };
    return {corner(triangle.a), corner(triangle.b), corner(triangle.c)};
}

double SphereWalls::largest_speed_at(double t) const {
    double largest = 0;
    for (const Motion& part : motion_)
        if (part.moves) largest = std::max(largest, part.at(t).norm());
    return largest;
}

/// The displacement by Gauss' rule of three points.
void SphereWalls::advance(double t, double dt) {
    largest_speed_ = 0;
    const double outer = std::sqrt(0.15);
    for (Motion& part : motion_) {
        if (!part.moves) continue;
        const Vec early = part.at(t + (0.5 - outer) * dt), late = part.at(t + (0.5 + outer) * dt);
        part.middle = part.at(t + 0.5 * dt);
        part.displacement += dt / 18 * (5 * early + 8 * part.middle + 5 * late);
        largest_speed_ = std::max({largest_speed_, early.norm(), part.middle.norm(), late.norm()});
    }
}

void SphereWalls::list(const SphereRows& rows, std::span<const ParticleTag> tags, double gap) {
    std::vector<std::vector<Candidate>> of_row(rows.owned());
    for (std::size_t k = 0; k < planes_.size(); ++k)
        for (std::size_t i = 0; i < rows.owned(); ++i) {
            const SphereMotion& sphere = rows.motion()[i];
            const Candidate candidate{static_cast<std::int32_t>(k), {}};
            if (touch_of(candidate, position_of(sphere)).distance < sphere.radius() + gap)
                of_row[i].push_back(candidate);
        }
    if (!triangles_.empty()) list_triangles(rows, gap, of_row);
    listed_.clear();
    candidates_.clear();
    for (std::size_t i = 0; i < rows.owned(); ++i) {
        const auto& laws = pairs_[tags[i].part];
        const std::size_t first = candidates_.size();
        if (!rows.motion()[i].fixed())
            for (const Candidate& candidate : of_row[i])
                if (laws[static_cast<std::size_t>(part_of(candidate.surface))]) candidates_.push_back(candidate);
        if (candidates_.size() > first) listed_.push_back({static_cast<std::int32_t>(i), first, candidates_.size()});
    }
    assign_contacts(tags);
}

void SphereWalls::list_triangles(const SphereRows& rows, double gap,
                                 std::vector<std::vector<Candidate>>& of_row) const {
    double reach = gap;
    for (const SphereMotion& sphere : rows.motion().first(rows.owned())) reach = std::max(reach, sphere.radius() + gap);
    std::vector<std::array<Vec, 3>> corners;
    for (std::size_t k = 0; k < triangles_.size(); ++k)
        corners.push_back(corners_of(static_cast<std::int32_t>(planes_.size() + k)));
    const TriangleGrid grid(corners, reach);
    for (std::size_t i = 0; i < rows.owned(); ++i) {
        const SphereMotion& sphere = rows.motion()[i];
        const double near = sphere.radius() + gap;
        const Vec position = position_of(sphere);
        for (const Vec& shift : shifts_near(space_, position, reach))
            grid.for_each_near(position - shift, [&](std::size_t k) {
                if ((closest_on(position - shift, corners[k]) + shift - position).norm() < near)
                    of_row[i].push_back(
                        {static_cast<std::int32_t>(planes_.size() + k), {shift[0], shift[1], shift[2]}});
            });
    }
}

/// Contacts in the order of the listed spheres; those of others go.
void SphereWalls::assign_contacts(std::span<const ParticleTag> tags) {
    std::unordered_map<std::int64_t, std::size_t> first_of;
    for (std::size_t k = contacts_.size(); k-- > 0;) first_of[contacts_[k].id] = k;
    next_contacts_.clear();
    for (ListedSphere& sphere : listed_) {
        const std::int64_t id = tags[static_cast<std::size_t>(sphere.row)].id;
        sphere.first_contact = next_contacts_.size();
        if (const auto found = first_of.find(id); found != first_of.end())
            for (std::size_t k = found->second; k < contacts_.size() && contacts_[k].id == id; ++k)
                next_contacts_.push_back(contacts_[k]);
        sphere.end_contact = next_contacts_.size();
    }
    contacts_.swap(next_contacts_);
}

SphereWalls::Touch SphereWalls::touch_of(const Candidate& candidate, const Vec& position) const {
    Touch touch{candidate.surface, part_of(candidate.surface), {}, {}, 0, {}};
    if (static_cast<std::size_t>(candidate.surface) < planes_.size()) {
        const WallPlane& plane = planes_[static_cast<std::size_t>(candidate.surface)];
        const Vec& moved = motion_[static_cast<std::size_t>(plane.part)].displacement;
        touch.normal = plane.normal;
        touch.distance = plane.normal.dot(position - plane.point - moved);
        touch.nearest = position - touch.distance * plane.normal;
        return touch;
    }
    const Vec shift(candidate.shift[0], candidate.shift[1], candidate.shift[2]);
    touch.corners = corners_of(candidate.surface);
    for (Vec& corner : touch.corners) corner += shift;
    touch.nearest = closest_on(position, touch.corners);
    const Vec away = position - touch.nearest;
    touch.distance = away.norm();
    touch.normal = touch.distance > 0 ? Vec(away / touch.distance) : Vec(Vec::UnitZ());
    return touch;
}

/// Whether this place is another triangle's too, which either counts for it or comes nearer elsewhere.
bool SphereWalls::is_hidden(std::size_t number, const std::vector<Touch>& all, double tolerance) const {
    const Touch& touch = all[number];
    if (static_cast<std::size_t>(touch.surface) < planes_.size()) return false;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Touch& other = all[k];
        if (k == number || static_cast<std::size_t>(other.surface) < planes_.size()) continue;
        if (std::pair(other.distance, k) > std::pair(touch.distance, number)) continue;
        if ((other.nearest - touch.nearest).norm() <= tolerance ||
            (closest_on(touch.nearest, other.corners) - touch.nearest).norm() <= tolerance)
            return true;
    }
    return false;
}

std::vector<SphereWalls::Touch> SphereWalls::touches_of(const ListedSphere& sphere, const SphereMotion& motion,
                                                        std::uint16_t part) const {
    std::vector<Touch> near, touches;
    for (std::size_t k = sphere.first; k < sphere.end; ++k) {
        const Touch touch = touch_of(candidates_[k], position_of(motion));
        const WallPair& pair = *pairs_[part][static_cast<std::size_t>(touch.part)];
        if (touch.distance < motion.radius() + contact_reach(pair.model, pair.constants, motion.radius()))
            near.push_back(touch);
    }
    if (near.size() < 2) return near;
    const std::vector<std::size_t> surface = smooth_surfaces(near);
    std::vector<std::size_t> deepest_first(near.size()), kept;
    std::iota(deepest_first.begin(), deepest_first.end(), std::size_t{0});
    std::ranges::stable_sort(deepest_first, {}, [&](std::size_t k) { return near[k].distance; });
    for (const std::size_t k : deepest_first) {
        const bool is_deepest = std::ranges::none_of(kept, [&](std::size_t other) {
            return surface[other] == surface[k] && near[other].normal.dot(near[k].normal) > same_direction;
        });
        if (is_deepest && !is_hidden(k, near, one_position * motion.radius())) kept.push_back(k);
    }
    std::ranges::sort(kept);
    for (const std::size_t k : kept) touches.push_back(near[k]);
    return touches;
}

/// The number of the smooth surface that each touch is on: that of its first touch.
std::vector<std::size_t> SphereWalls::smooth_surfaces(const std::vector<Touch>& touches) const {
    DisjointSets together(touches.size());
    const auto is_plane = [&](std::size_t k) { return static_cast<std::size_t>(touches[k].surface) < planes_.size(); };
    const auto triangle = [&](std::size_t k) { return static_cast<std::size_t>(touches[k].surface) - planes_.size(); };
    for (std::size_t k = 0; k < touches.size(); ++k)
        for (std::size_t before = 0; before < k; ++before)
            if (!is_plane(before) && !is_plane(k) && smooth_edges_.join(triangle(before), triangle(k)))
                together.join(before, k);
    std::vector<std::size_t> number;
    for (std::size_t k = 0; k < touches.size(); ++k) number.push_back(together.find(k));
    return number;
}

/// The contact of the last step that this one goes on from; null: it begins.
const WallContact* SphereWalls::remembered(const Touch& touch, std::span<const WallContact> before,
                                           const std::vector<Touch>& all) const {
    for (const WallContact& contact : before)
        if (contact.surface == touch.surface) return &contact;
    for (const WallContact& contact : before) {
        const Vec normal(contact.normal[0], contact.normal[1], contact.normal[2]);
        if (contact.part != touch.part || normal.dot(touch.normal) < same_direction) continue;
        if (std::ranges::none_of(all, [&](const Touch& other) { return other.surface == contact.surface; }))
            return &contact;
    }
    return nullptr;
}

void SphereWalls::add_loads(SphereRows& rows, std::span<const ParticleTag> tags, const ContactTime& time) {
    total_ = {};
    next_contacts_.clear();
    for (ListedSphere& sphere : listed_) {
        const auto row = static_cast<std::size_t>(sphere.row);
        const SphereMotion& motion = rows.motion()[row];
        const std::vector<Touch> touches = touches_of(sphere, motion, tags[row].part);
        const std::span before(contacts_.data() + sphere.first_contact, sphere.end_contact - sphere.first_contact);
        Vector<double, 3> force = Vector<double, 3>::zero(), torque = Vector<double, 3>::zero();
        const std::size_t first = next_contacts_.size();
        for (const Touch& touch : touches) {
            const WallPair& pair = *pairs_[tags[row].part][static_cast<std::size_t>(touch.part)];
            WallContact contact{tags[row].id, touch.surface, touch.part, {}, {}};
            if (const WallContact* last = remembered(touch, before, touches)) contact.history = last->history;
            for (std::size_t axis = 0; axis < 3; ++axis)
                contact.normal[axis] = touch.normal[static_cast<Eigen::Index>(axis)];
            const WallPush push = wall_law(pair.model)(
                motion,
                {three(touch.normal), touch.distance, three(motion_[static_cast<std::size_t>(touch.part)].middle)},
                pair.constants, time, contact.history.data());
            force += push.force;
            torque += push.torque;
            next_contacts_.push_back(contact);
        }
        sphere.first_contact = first;
        sphere.end_contact = next_contacts_.size();
        SphereLoad& load = rows.loads()[row];
        for (int axis = 0; axis < 3; ++axis) {
            load.force.c[axis] += force[axis];
            load.torque.c[axis] += torque[axis];
            if (!touches.empty()) total_[axis].add(force[axis]);
        }
    }
    contacts_.swap(next_contacts_);
}

SphereWalls::Overlap SphereWalls::largest_overlap(const SphereRows& rows) const {
    Overlap largest;
    for (const ListedSphere& sphere : listed_)
        for (std::size_t k = sphere.first; k < sphere.end; ++k) {
            const SphereMotion& motion = rows.motion()[static_cast<std::size_t>(sphere.row)];
            const double ratio = 1 - touch_of(candidates_[k], position_of(motion)).distance / motion.radius();
            if (ratio > largest.ratio) largest = {ratio, sphere.row};
        }
    return largest;
}

ExactSum SphereWalls::contact_energy(const SphereRows& rows, std::span<const ParticleTag> tags) const {
    ExactSum energy;
    for (const ListedSphere& sphere : listed_) {
        const auto row = static_cast<std::size_t>(sphere.row);
        const SphereMotion& motion = rows.motion()[row];
        for (const Touch& touch : touches_of(sphere, motion, tags[row].part)) {
            const WallPair& pair = *pairs_[tags[row].part][static_cast<std::size_t>(touch.part)];
            for (std::size_t k = sphere.first_contact; k < sphere.end_contact; ++k)
                if (contacts_[k].surface == touch.surface)
                    energy.add(solver::contact_energy(pair.model, pair.constants, motion.radius() - touch.distance,
                                                      motion.radius(), contacts_[k].history));
        }
    }
    return energy;
}

void SphereWalls::exchange(const Ranks& ranks, std::span<const int> rank_of) {
    std::vector<std::vector<WallContact>> to_each(static_cast<std::size_t>(ranks.size()));
    for (const ListedSphere& sphere : listed_)
        for (std::size_t k = sphere.first_contact; k < sphere.end_contact; ++k)
            to_each[static_cast<std::size_t>(rank_of[static_cast<std::size_t>(sphere.row)])].push_back(contacts_[k]);
    contacts_.clear();
    for (const auto& received : ranks.exchange(to_each))
        contacts_.insert(contacts_.end(), received.begin(), received.end());
    listed_.clear();
}

void SphereWalls::archive(Archive& file, const Ranks& ranks, std::int64_t ids) {
    for (std::size_t part = 0; part < motion_.size(); ++part) {
        if (!motion_[part].moves) continue;
        std::array<double, 3> displacement{};
        std::copy_n(motion_[part].displacement.data(), 3, displacement.begin());
        file("spheres/wall_displacement_" + std::to_string(part), displacement);
        check_finite(displacement, "a displacement of a wall");
        motion_[part].displacement = Vec(displacement[0], displacement[1], displacement[2]);
    }
    if (empty()) return;
    constexpr std::size_t width = 6 + most_history;
    std::vector<double> flat;
    if (!file.loading()) {
        std::vector<WallContact> all = ranks.gather_to_first(contacts_);
        std::ranges::stable_sort(all, {}, &WallContact::id);
        for (const WallContact& contact : all) {
            for (const double number : {static_cast<double>(contact.id), static_cast<double>(contact.surface),
                                        static_cast<double>(contact.part)})
                flat.push_back(number);
            flat.insert(flat.end(), contact.normal.begin(), contact.normal.end());
            flat.insert(flat.end(), contact.history.begin(), contact.history.end());
        }
    }
    file("spheres/wall_contacts", flat);
    if (!file.loading()) return;
    if (flat.size() % width != 0) throw unlike_any_run("a part of a contact with a wall");
    check_finite(flat, "a contact with a wall");
    const auto surfaces = static_cast<std::int64_t>(planes_.size() + triangles_.size()),
               parts = static_cast<std::int64_t>(motion_.size());
    contacts_.assign(flat.size() / width, {});
    listed_.clear();
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
        const double* values = flat.data() + k * width;
        contacts_[k].id = loaded_whole(values[0], 0, ids, "a sphere at a wall");
        contacts_[k].surface = static_cast<std::int32_t>(loaded_whole(values[1], 0, surfaces, "a surface of a wall"));
        contacts_[k].part = static_cast<std::int32_t>(loaded_whole(values[2], 0, parts, "a part that is a wall"));
        std::copy_n(values + 3, 3, contacts_[k].normal.begin());
        std::copy_n(values + 6, most_history, contacts_[k].history.begin());
    }
}

}  // namespace dmp::solver
