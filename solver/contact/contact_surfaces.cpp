// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/contact_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/errors.hpp"
#include "base/length_text.hpp"
#include "particles/cell_grid.hpp"

namespace dmp::solver {

namespace {

/// A point where the surface turns by more is a corner; by less it is straight there [rad].
constexpr double corner_angle = 30 * std::numbers::pi / 180, straight_angle = 1e-4;
/// Particles that carry a point are within this distance of it [spacings], and not more than so many.
constexpr double carried_from = 2.5;
constexpr std::size_t most_carriers = 8;

/// The drawn pieces before and after each point; -1: none.
struct Neighbours {
    std::vector<int> before, after;

    explicit Neighbours(const ParticleSpace& space)
        : before(space.contact_points.size(), -1), after(space.contact_points.size(), -1) {
        for (std::size_t k = 0; k < space.contact_pieces.size(); ++k) {
            after[static_cast<std::size_t>(space.contact_pieces[k].a)] = static_cast<int>(k);
            before[static_cast<std::size_t>(space.contact_pieces[k].b)] = static_cast<int>(k);
        }
    }
};

}  // namespace

ContactSurfaces::ContactSurfaces(const ParticleSet& set, const SpringBodies& bodies)
    : space_(static_cast<const ParticleSpace&>(set)), points_(set.contact_points) {
    make_pieces(set);
    find_particles(set);
    find_bodies(bodies);
}

/// A smooth point has a piece around it, from the middle of the line before to the middle of the line after; between
/// two corners (or straight points) the line is a piece.
void ContactSurfaces::make_pieces(const ParticleSet& set) {
    const Neighbours lines(set);
    const auto line = [&](int k) -> const ContactPiece& { return set.contact_pieces[static_cast<std::size_t>(k)]; };
    const auto is_smooth = [&](int point) {
        const int before = lines.before[static_cast<std::size_t>(point)],
                  after = lines.after[static_cast<std::size_t>(point)];
        if (before < 0 || after < 0) return false;
        const Vec in = points_[static_cast<std::size_t>(point)] - points_[static_cast<std::size_t>(line(before).a)];
        const Vec out = points_[static_cast<std::size_t>(line(after).b)] - points_[static_cast<std::size_t>(point)];
        const double turn = std::abs(std::atan2(in[0] * out[1] - in[1] * out[0], in.dot(out)));
        return turn > straight_angle && turn < corner_angle;
    };
    // So that the curve goes through the drawn points.
    const auto control_of = [&](int point) -> OfPoints {
        if (!is_smooth(point)) return {{point, 1.0}};
        return {{point, 1.25},
                {line(lines.before[static_cast<std::size_t>(point)]).a, -0.125},
                {line(lines.after[static_cast<std::size_t>(point)]).b, -0.125}};
    };
    const auto middle = [&](int a, int b) {
        OfPoints both;
        for (const int point : {a, b})
            for (const auto& [of, share] : control_of(point)) both.emplace_back(of, 0.5 * share);
        return both;
    };
    for (std::size_t k = 0; k < set.contact_pieces.size(); ++k) {
        const auto& [part, a, b, c, thickness] = set.contact_pieces[k];
        if (!is_smooth(a) && !is_smooth(b))
            add_piece(set, part, thickness, {control_of(a), middle(a, b), control_of(b)});
        if (!is_smooth(b)) continue;
        const ContactPiece& next = line(lines.after[static_cast<std::size_t>(b)]);
        add_piece(set, part, std::min(thickness, next.thickness),
                  {is_smooth(a) ? middle(a, b) : control_of(a), control_of(b),
                   is_smooth(next.b) ? middle(b, next.b) : control_of(next.b)});
    }
    const auto sticks_out = [&](int point) {
        const int before = lines.before[static_cast<std::size_t>(point)],
                  after = lines.after[static_cast<std::size_t>(point)];
        if (before < 0 || after < 0) return false;
        const Vec in = points_[static_cast<std::size_t>(point)] - points_[static_cast<std::size_t>(line(before).a)];
        const Vec out = points_[static_cast<std::size_t>(line(after).b)] - points_[static_cast<std::size_t>(point)];
        return std::atan2(in[0] * out[1] - in[1] * out[0], in.dot(out)) >= corner_angle;
    };
    for (std::size_t k = 0; k < pieces_.size(); ++k)
        for (const std::size_t end : {0U, 1U}) {
            const OfPoints& control = drawn_[k].control[2 * end];
            pieces_[k].is_sharp[end] = control.size() == 1 && sticks_out(control.front().first);
        }
    // Pieces follow each other where they begin and end as the same shares of points.
    std::map<OfPoints, int> beginning;
    const auto key = [](OfPoints of) {
        std::ranges::sort(of);
        return of;
    };
    for (std::size_t k = 0; k < pieces_.size(); ++k) beginning[key(drawn_[k].control[0])] = static_cast<int>(k);
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
        const auto next = beginning.find(key(drawn_[k].control[2]));
        if (next == beginning.end() || next->second == static_cast<int>(k)) continue;
        pieces_[k].next = next->second;
        pieces_[static_cast<std::size_t>(next->second)].previous = static_cast<int>(k);
    }
}

void ContactSurfaces::add_piece(const ParticleSet& set, int part, double thickness,
                                const std::array<OfPoints, 3>& control) {
    Piece piece;
    piece.part = part;
    piece.is_wall = set.parts[static_cast<std::size_t>(part)].kind == PartKind::rigid;
    piece.thickness = thickness;
    for (std::size_t k = 0; k < control.size(); ++k) {
        piece.at_rest.control[k] = Vec::Zero();
        for (const auto& [point, share] : control[k])
            piece.at_rest.control[k] += share * points_[static_cast<std::size_t>(point)];
    }
    for (std::size_t k = 0; k < points_of_piece; ++k)
        piece.weight[k] = gauss_weights[k] * piece.at_rest.tangent(gauss_points[k]).norm();
    piece.now = piece.at_rest;
    pieces_.push_back(piece);
    drawn_.push_back({control});
}

ContactSurfaces::Weight ContactSurfaces::weight(const Piece& piece, double t) {
    constexpr double least = 1e-3;
    const auto [start, end] = piece.is_sharp;
    if (!start && !end) return {1, 0};
    // Smooth from 0 at the corner to 1 at the other end, or in the middle.
    const double scale = start && end ? 2 : 1;
    const bool from_start = start && (!end || t < 0.5);
    const double x = scale * (from_start ? t : 1 - t), slope = (from_start ? scale : -scale) * 6 * x * (1 - x);
    return {least + (1 - least) * x * x * (3 - 2 * x), (1 - least) * slope / piece.now.tangent(t).norm()};
}

void ContactSurfaces::find_particles(const ParticleSet& set) {
    Coordinates places;
    std::vector<int> ids;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) == PartKind::fluid) continue;
        ids.push_back(static_cast<int>(i));
        for (int axis = 0; axis < set.dimension; ++axis) places[axis].push_back(set.position[i][axis]);
    }
    const double reach = carried_from * set.spacing;
    const CellGrid grid(places, ids.size(), set.dimension, reach);
    particles_near_.resize(points_.size());
    for (const ContactPiece& piece : set.contact_pieces)
        for (const int point : {piece.a, piece.b}) {
            std::vector<int>& near = particles_near_[static_cast<std::size_t>(point)];
            const Vec& at = points_[static_cast<std::size_t>(point)];
            if (!near.empty()) continue;
            std::vector<std::pair<double, int>> found;
            const auto look = [&](const Vec& from) {
                grid.for_each_near({from[0], from[1], from[2]}, reach, [&](int k) {
                    const auto id = static_cast<std::size_t>(ids[static_cast<std::size_t>(k)]);
                    const double distance = nearest_image(set.position[id] - at, set).norm();
                    if (set.part[id] == piece.part && distance < reach)
                        found.emplace_back(distance, static_cast<int>(id));
                });
            };
            look(at);
            for (int axis = 0; axis < set.dimension; ++axis)
                for (const double period : {-set.box.extent()[axis], set.box.extent()[axis]})
                    if (set.periodic[static_cast<std::size_t>(axis)]) look(at + period * Vec::Unit(axis));
            std::ranges::sort(found);
            found.erase(std::unique(found.begin(), found.end()), found.end());
            if (found.size() > most_carriers) found.resize(most_carriers);
            for (const auto& [distance, id] : found) near.push_back(id);
            if (near.empty() && set.parts[static_cast<std::size_t>(piece.part)].kind == PartKind::elastic)
                throw InputError("the surface of '" + set.parts[static_cast<std::size_t>(piece.part)].name + "' at " +
                                     position_text(at, 2) + " has none of its particles near",
                                 "refine particles.spacing, or write [contact] between = \"particles\"");
        }
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
        const std::vector<int>& near = particles_near_[static_cast<std::size_t>(drawn_[k].control[1].front().first)];
        if (pieces_[k].is_wall && !near.empty()) pieces_[k].wall_particle = near.front();
        pieces_[k].solid = pieces_[k].is_wall || near.empty() ? -2 - pieces_[k].part
                                                              : set.body[static_cast<std::size_t>(near.front())];
    }
}

void ContactSurfaces::find_bodies(const SpringBodies& bodies) {
    first_unknown_.assign(1, 0);
    std::map<const SpringBody*, std::size_t> number;
    for (const auto& body : bodies.bodies()) {
        number[body.get()] = first_unknown_.size() - 1;
        first_unknown_.push_back(first_unknown_.back() + body->unknowns());
    }
    struct OfPoint {
        const SpringBody* body = nullptr;
        CarriedPoint carried;
    };
    std::vector<OfPoint> carried(points_.size());
    for (std::size_t point = 0; point < points_.size(); ++point) {
        std::vector<int> nodes;
        for (const int id : particles_near_[point]) {
            if (!bodies.holds(id)) break;  // a wall's
            const auto [body, node] = bodies.node_of(id);
            if (carried[point].body == nullptr) carried[point].body = body;
            if (body == carried[point].body) nodes.push_back(static_cast<int>(node));
        }
        if (carried[point].body != nullptr)
            carried[point].carried = carried[point].body->carry(points_[point], nodes, space_);
    }
    carriers_.clear();
    first_carrier_.assign(1, 0);
    shift_.assign(pieces_.size(), {Vec::Zero(), Vec::Zero(), Vec::Zero()});
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
        Piece& piece = pieces_[k];
        if (!piece.is_wall) {
            std::map<int, std::array<double, 3>> shares;
            const SpringBody* only = nullptr;
            piece.is_there = true;
            for (std::size_t c = 0; c < 3; ++c)
                for (const auto& [point, of_control] : drawn_[k].control[c]) {
                    const auto& [body, of_point] = carried[static_cast<std::size_t>(point)];
                    if (only == nullptr) only = body;
                    piece.is_there = piece.is_there && body == only;
                    shift_[k][c] += of_control * of_point.shift;
                    for (const auto& [unknown, share] : of_point.shares)
                        shares[static_cast<int>(first_unknown_[number.at(body)]) + unknown][c] += of_control * share;
                }
            if (piece.is_there)
                for (const auto& [unknown, share] : shares) carriers_.push_back({unknown, share});
        }
        first_carrier_.push_back(carriers_.size());
    }
}

void ContactSurfaces::place(std::span<const Vec> position, const WallMotion* walls, int threads) {
    const auto count = static_cast<std::ptrdiff_t>(pieces_.size());
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        const auto at = static_cast<std::size_t>(k);
        Piece& piece = pieces_[at];
        if (!piece.is_there) continue;
        if (piece.is_wall) {
            if (walls == nullptr || !walls->moves()) continue;
            for (std::size_t c = 0; c < 3; ++c)
                piece.now.control[c] = walls->carried(static_cast<std::uint16_t>(piece.part), piece.at_rest.control[c]);
            continue;
        }
        std::array<Vec, 3> control = shift_[at];
        for_each_control(static_cast<int>(k), [&](const Carrier& carrier) {
            for (std::size_t c = 0; c < 3; ++c)
                control[c] += carrier.share[c] * position[static_cast<std::size_t>(carrier.unknown)];
        });
        piece.now.control = control;
    }
}

}  // namespace dmp::solver
