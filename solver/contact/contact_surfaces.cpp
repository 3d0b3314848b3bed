// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/contact_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "base/errors.hpp"
#include "base/length_text.hpp"
#include "particles/cell_grid.hpp"

namespace dmp::solver {

namespace {

/// Particles that carry a point are within this distance of it [spacings], and not more than so many.
constexpr double carried_from = 2.5;
constexpr std::size_t most_carriers_in_plane = 8, most_carriers_in_space = 24;

/// Walls go on beyond planes of symmetry by this [spacings].
constexpr double walls_go_on = 4;

bool is_wall(const ParticleSpace& space, int part) {
    return space.parts[static_cast<std::size_t>(part)].kind == PartKind::rigid;
}

}  // namespace

ContactSurfaces::ContactSurfaces(const ParticleSet& set, const SpringBodies& bodies)
    : space_(static_cast<const ParticleSpace&>(set)), drawn_points_(add_images(space_, walls_go_on * set.spacing)) {
    DrawnSurfaces drawn = set.dimension == 2 ? draw_curves(space_) : draw_triangles(space_);
    corners_ = drawn.corners;
    controls_ = std::move(drawn.controls);
    is_end_ = std::move(drawn.is_end);
    for (const DrawnSurfaces::OfPoints& control : controls_) {
        control_at_rest_.emplace_back(Vec::Zero());
        for (const auto& [point, share] : control)
            control_at_rest_.back() += share * space_.contact_points[static_cast<std::size_t>(point)];
    }
    for (const DrawnSurfaces::Piece& from : drawn.pieces) {
        Piece& piece = pieces_.emplace_back();
        piece.part = from.part;
        piece.is_wall = is_wall(space_, from.part);
        piece.thickness = from.thickness;
        piece.control = from.control;
        piece.at_rest.corners = corners_;
        for (std::size_t k = 0; k < piece.at_rest.controls(); ++k)
            piece.at_rest.control[k] = control_at_rest_[static_cast<std::size_t>(piece.control[k])];
        for (std::size_t k = 0; k < corners_; ++k)
            piece.of_corners[k] = drawn.is_sharp[static_cast<std::size_t>(piece.control[k])] ? 0 : 1;
        // In 2-D a piece may lie on a plane of symmetry, half of it an image.
        const Vec middle = piece.at_rest.at(piece.at_rest.middle());
        piece.reflection = Reflection::back_from(middle, space_);
        const double own = piece.reflection.is_none() ? std::pow(0.5, Reflection::planes_through(middle, space_)) : 0;
        for (std::size_t p = 0; p < points().size(); ++p)
            piece.weight[p] = own * points()[p].weight * piece.at_rest.measure(points()[p].place);
        piece.now = piece.at_rest;
        std::tie(piece.low, piece.high) = piece.now.box();
    }
    find_particles(set);
    find_images_of_other_bodies();
    find_pieces_at_controls();
    find_sources();
    find_bodies(bodies);
}

void ContactSurfaces::find_pieces_at_controls() {
    // The middle control point of a curve is none that it meets others at.
    const std::size_t shared = corners_ == 2 ? 2 : SurfacePiece::most_controls;
    first_piece_at_.assign(controls_.size() + 1, 0);
    for (const Piece& piece : pieces_)
        for (std::size_t k = 0; k < shared; ++k) ++first_piece_at_[static_cast<std::size_t>(piece.control[k]) + 1];
    for (std::size_t c = 0; c < controls_.size(); ++c) first_piece_at_[c + 1] += first_piece_at_[c];
    pieces_at_.resize(first_piece_at_.back());
    std::vector<std::size_t> next = first_piece_at_;
    for (std::size_t n = 0; n < pieces_.size(); ++n)
        for (std::size_t k = 0; k < shared; ++k)
            pieces_at_[next[static_cast<std::size_t>(pieces_[n].control[k])]++] = static_cast<int>(n);
    // In 3-D edges that only one triangle has, with their ends.
    is_border_.assign(controls_.size(), false);
    for (const Piece& piece : pieces_)
        for (std::size_t k = 0; k < corners_; ++k) {
            const int control = piece.control[corners_ == 2 ? k : corners_ + k];
            if (pieces_at(control).size() > 1) continue;
            is_border_[static_cast<std::size_t>(control)] = true;
            if (corners_ == 2) continue;
            is_border_[static_cast<std::size_t>(piece.control[k])] = true;
            is_border_[static_cast<std::size_t>(piece.control[(k + 1) % corners_])] = true;
        }
}

/// In 2-D pieces may lie across a plane of symmetry. An image has the same shares of the same drawn points.
void ContactSurfaces::find_sources() {
    source_.resize(controls_.size());
    std::iota(source_.begin(), source_.end(), 0);
    if (corners_ == 3 || drawn_points_.empty() || drawn_points_.back().reflection.is_none()) return;
    std::map<std::map<int, double>, int> number;
    for (int& source : source_) {
        std::map<int, double> shares;
        for (const auto& [point, share] : controls_[static_cast<std::size_t>(source)])
            shares[drawn_points_[static_cast<std::size_t>(point)].source] += share;
        source = number.try_emplace(shares, source).first->second;
    }
}

/// A body that does not reach a plane of symmetry meets its image as another body.
void ContactSurfaces::find_images_of_other_bodies() {
    std::set<std::tuple<int, int, double>> reached;  // solid, axis, twice where its plane is
    int bodies = 0;
    for (const Piece& piece : pieces_) {
        bodies = std::max(bodies, piece.solid + 1);
        for (int axis = 0; axis < space_.dimension; ++axis)
            for (const double plane : {space_.box.low[axis], space_.box.high[axis]})
                for (std::size_t k = 0; k < corners_; ++k)
                    if (std::abs(piece.at_rest.control[k][axis] - plane) <= 1e-6 * space_.spacing)
                        reached.emplace(piece.solid, axis, 2 * plane);
    }
    for (Piece& piece : pieces_) {
        int apart = 0;
        for (int axis = 0; axis < space_.dimension; ++axis)
            if (Reflection::has(piece.reflection.axes, axis) &&
                !reached.contains({piece.solid, axis, piece.reflection.twice[axis]}))
                apart |= 1 << axis;
        if (!piece.is_wall) piece.solid += apart * bodies;
    }
}

int ContactSurfaces::control_at(const Piece& piece, const PiecePlace& place) const {
    std::size_t corner = 0, zeros = 0, without = 0;
    for (std::size_t k = 0; k < corners_; ++k) {
        if (place[k] != 0) {
            corner = k;
        } else {
            ++zeros;
            without = k;
        }
    }
    if (zeros == 0) return -1;
    return zeros + 1 == corners_ ? piece.control[corner] : piece.control[corners_ + (without + 1) % corners_];
}

Vec ContactSurfaces::normal_at_border(int number, const PiecePlace& place) const {
    const Piece& piece = pieces_[static_cast<std::size_t>(number)];
    const int control = control_at(piece, place);
    if (control < 0) return piece.now.normal(place);
    Vec sum = Vec::Zero();
    for (const int at_control : pieces_at(control)) {
        const Piece& other = pieces_[static_cast<std::size_t>(at_control)];
        if (!other.is_there) continue;
        PiecePlace there{};
        for (std::size_t a = 0; a < corners_; ++a)
            for (std::size_t b = 0; b < corners_; ++b)
                if (other.control[b] == piece.control[a]) there[b] = place[a];
        sum += other.now.angle_at(there) * other.now.normal(there);
    }
    return sum;
}

bool ContactSurfaces::is_end(int number, const PiecePlace& place) const {
    const int control = control_at(pieces_[static_cast<std::size_t>(number)], place);
    if (control < 0) return false;
    return is_end_[static_cast<std::size_t>(control)] || std::ranges::any_of(pieces_at(control), [&](int piece) {
               return !pieces_[static_cast<std::size_t>(piece)].is_there;
           });
}

ContactSurfaces::Weight ContactSurfaces::weight(const Piece& piece, const PiecePlace& place) {
    constexpr double least = 1e-3;
    const std::size_t corners = piece.now.corners;
    const auto of_corners = std::span(piece.of_corners).first(corners);
    const auto sharp = static_cast<std::size_t>(std::ranges::count(of_corners, 0));
    if (sharp == 0) return {1, Vec::Zero()};
    // Smooth from 0 at sharp corners to 1 at others, or in the middle.
    std::array<double, 3> values = piece.of_corners;
    if (sharp == corners) {
        values = {};
        const auto nearest = std::min_element(place.begin(), place.begin() + static_cast<std::ptrdiff_t>(corners));
        values[static_cast<std::size_t>(nearest - place.begin())] = static_cast<double>(corners);
    }
    double x = 0;
    for (std::size_t k = 0; k < corners; ++k) x += place[k] * values[k];
    x = std::min(x, 1.0);
    return {least + (1 - least) * x * x * (3 - 2 * x),
            (1 - least) * 6 * x * (1 - x) * piece.now.gradient(place, values)};
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
    const std::size_t most = set.dimension == 2 ? most_carriers_in_plane : most_carriers_in_space;
    const CellGrid grid(places, ids.size(), set.dimension, reach);
    particles_near_.resize(space_.contact_points.size());
    const auto find = [&](int point, int part) {
        std::vector<int>& near = particles_near_[static_cast<std::size_t>(point)];
        const Vec& at = space_.contact_points[static_cast<std::size_t>(point)];
        if (!near.empty()) return;
        std::vector<std::pair<double, int>> found;
        const auto look = [&](const Vec& from) {
            grid.for_each_near({from[0], from[1], from[2]}, reach, [&](int k) {
                const auto id = static_cast<std::size_t>(ids[static_cast<std::size_t>(k)]);
                if (set.part[id] != part) return;
                const double distance = nearest_image(set.position[id] - at, set).norm();
                if (distance < reach) found.emplace_back(distance, static_cast<int>(id));
            });
        };
        look(at);
        for (int axis = 0; axis < set.dimension; ++axis)
            for (const double period : {-set.box.extent()[axis], set.box.extent()[axis]})
                if (set.periodic[static_cast<std::size_t>(axis)]) look(at + period * Vec::Unit(axis));
        std::ranges::sort(found);
        found.erase(std::unique(found.begin(), found.end()), found.end());
        if (found.size() > most) found.resize(most);
        for (const auto& [distance, id] : found) near.push_back(id);
        if (near.empty() && !is_wall(space_, part))
            throw InputError("the surface of '" + set.parts[static_cast<std::size_t>(part)].name + "' at " +
                                 position_text(at, set.dimension) + " has none of its particles near",
                             "refine particles.spacing, or write [contact] between = \"particles\"");
    };
    for (const ContactPiece& piece : set.contact_pieces)
        for (const int point : {piece.a, piece.b, piece.c})
            if (point != ContactPiece::none) find(point, piece.part);
    for (Piece& piece : pieces_) {
        const auto& middle = controls_[static_cast<std::size_t>(piece.control[piece.now.controls() - 1])];
        const DrawnPoint& point = drawn_points_[static_cast<std::size_t>(middle.front().first)];
        const std::vector<int>& near = particles_near_[static_cast<std::size_t>(point.source)];
        if (piece.is_wall && !near.empty()) piece.wall_particle = near.front();
        piece.solid =
            piece.is_wall || near.empty() ? -2 - piece.part : set.body[static_cast<std::size_t>(near.front())];
    }
}

void ContactSurfaces::find_bodies(const SpringBodies& bodies) {
    first_unknown_.assign(1, 0);
    std::map<const SpringBody*, int> number;
    for (const auto& body : bodies.bodies()) {
        number[body.get()] = static_cast<int>(first_unknown_.size()) - 1;
        first_unknown_.push_back(first_unknown_.back() + body->unknowns());
    }
    struct OfPoint {
        int body = no_body;
        CarriedPoint carried;
    };
    std::vector<OfPoint> carried(drawn_points_.size());  // of images none
    for (std::size_t point = 0; point < carried.size(); ++point) {
        std::vector<int> nodes;
        const SpringBody* nearest = nullptr;
        for (const int id : particles_near_[point]) {
            if (!bodies.holds(id)) break;  // a wall's
            const auto [body, node] = bodies.node_of(id);
            if (nearest == nullptr) nearest = body;
            if (body == nearest) nodes.push_back(static_cast<int>(node));
        }
        if (nearest != nullptr)
            carried[point] = {number.at(nearest), nearest->carry(space_.contact_points[point], nodes, space_)};
    }
    carriers_.clear();
    first_carrier_.assign(1, 0);
    body_.assign(controls_.size(), no_body);
    shift_.assign(controls_.size(), Vec::Zero());
    std::vector<bool> is_torn(controls_.size(), false);
    for (std::size_t c = 0; c < controls_.size(); ++c) {
        std::map<std::pair<int, std::uint8_t>, double> shares;
        const auto carried_point = [&](int point) -> const OfPoint& {
            return carried[static_cast<std::size_t>(drawn_points_[static_cast<std::size_t>(point)].source)];
        };
        body_[c] = carried_point(controls_[c].front().first).body;
        for (const auto& [point, of_control] : controls_[c]) {
            const auto& [body, of_point] = carried_point(point);
            const Reflection& reflection = drawn_points_[static_cast<std::size_t>(point)].reflection;
            is_torn[c] = is_torn[c] || body != body_[c];
            shift_[c] += of_control * reflection.of_point(of_point.shift);
            for (const auto& [unknown, share] : of_point.shares)
                shares[{unknown, reflection.axes}] += of_control * share;
        }
        if (!is_torn[c] && body_[c] != no_body)
            for (const auto& [carrier, share] : shares)
                carriers_.push_back(
                    {static_cast<int>(first_unknown_[static_cast<std::size_t>(body_[c])]) + carrier.first,
                     carrier.second, share});
        first_carrier_.push_back(carriers_.size());
    }
    control_position_ = control_at_rest_;
    for (Piece& piece : pieces_) {
        piece.is_held = true;
        if (piece.is_wall) continue;
        piece.is_there = true;
        for (std::size_t k = 0; k < piece.now.controls(); ++k) {
            const auto c = static_cast<std::size_t>(piece.control[k]);
            piece.is_there = piece.is_there && !is_torn[c] && body_[c] == body_of(piece.control[0]);
            for (const Share& share : carriers(piece.control[k]))
                piece.is_held = piece.is_held && is_fixed(bodies, body_[c], share.unknown);
        }
    }
    find_roots(bodies);
}

/// Pieces near where their body is held, as a leaflet at its root: near a control point that held unknowns carry.
void ContactSurfaces::find_roots(const SpringBodies& bodies) {
    constexpr double least_held = 0.25;
    Coordinates places;
    std::size_t count = 0;
    for (std::size_t c = 0; c < controls_.size(); ++c) {
        double held = 0;
        for (const Share& share : carriers(static_cast<int>(c)))
            if (is_fixed(bodies, body_[c], share.unknown)) held += share.share;
        if (held < least_held) continue;
        ++count;
        for (int axis = 0; axis < space_.dimension; ++axis) places[axis].push_back(control_at_rest_[c][axis]);
    }
    const double reach = neighbourhood * space_.spacing;
    const CellGrid grid(places, count, space_.dimension, reach);
    for (Piece& piece : pieces_) {
        piece.is_root = false;
        if (piece.is_wall || count == 0) continue;
        const Vec at = piece.at_rest.at(piece.at_rest.middle());
        grid.for_each_near({at[0], at[1], at[2]}, reach, [&](int k) {
            Vec apart = Vec::Zero();
            for (int axis = 0; axis < space_.dimension; ++axis)
                apart[axis] = places[axis][static_cast<std::size_t>(k)] - at[axis];
            piece.is_root = piece.is_root || apart.norm() < reach;
        });
    }
}

bool ContactSurfaces::is_fixed(const SpringBodies& bodies, int body, int unknown) const {
    const auto b = static_cast<std::size_t>(body);
    return bodies.bodies()[b]->unknown_fixed(static_cast<std::size_t>(unknown) - first_unknown_[b]);
}

void ContactSurfaces::place(std::span<const Vec> position, const WallMotion* walls, int threads) {
    walls_move_ = walls != nullptr && walls->moves();
    const auto controls = static_cast<std::ptrdiff_t>(controls_.size());
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::ptrdiff_t k = 0; k < controls; ++k)
        if (const auto c = static_cast<std::size_t>(k); body_[c] != no_body)
            control_position_[c] = shift_[c] + carried(static_cast<int>(k), position);
    const auto pieces = static_cast<std::ptrdiff_t>(pieces_.size());
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::ptrdiff_t k = 0; k < pieces; ++k) {
        Piece& piece = pieces_[static_cast<std::size_t>(k)];
        if (!piece.is_there || (piece.is_wall && !walls_move_)) continue;
        for (std::size_t c = 0; c < piece.now.controls(); ++c)
            piece.now.control[c] =
                piece.is_wall
                    ? piece.reflection.of_point(walls->carried(static_cast<std::uint16_t>(piece.part),
                                                               piece.reflection.of_point(piece.at_rest.control[c])))
                    : control_position_[static_cast<std::size_t>(piece.control[c])];
        std::tie(piece.low, piece.high) = piece.now.box();
    }
}

}  // namespace dmp::solver
