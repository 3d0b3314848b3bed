// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/reflection.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace dmp::solver {

namespace {

/// Visits the planes of symmetry: their axis, where they are, and towards where it is beyond them.
template <class Visit>
void for_each_plane(const ParticleSpace& space, const Visit& visit) {
    for (int axis = 0; axis < space.dimension; ++axis)
        for (const std::size_t side : {0U, 1U})
            if (space.mirrored.at(static_cast<std::size_t>(axis)).at(side))
                visit(axis, (side == 0 ? space.box.low : space.box.high)[axis], side == 0 ? -1.0 : 1.0);
}

double tolerance(const ParticleSpace& space) { return 1e-6 * space.spacing; }

}  // namespace

Reflection Reflection::back_from(const Vec& point, const ParticleSpace& space) {
    Reflection back;
    for_each_plane(space, [&](int axis, double plane, double beyond) {
        if (beyond * (point[axis] - plane) > tolerance(space)) back.add(axis, plane);
    });
    return back;
}

int Reflection::planes_through(const Vec& point, const ParticleSpace& space) {
    int count = 0;
    for_each_plane(space, [&](int axis, double plane, double) {
        if (std::abs(point[axis] - plane) <= tolerance(space)) ++count;
    });
    return count;
}

std::vector<DrawnPoint> add_images(ParticleSpace& space, double walls_within) {
    std::vector<DrawnPoint> points;
    for (std::size_t k = 0; k < space.contact_points.size(); ++k) points.push_back({static_cast<int>(k), {}});
    // What is there on the axes before has images across both planes of an axis.
    int last_axis = -1;
    std::size_t pieces = 0;
    for_each_plane(space, [&](int axis, double plane, double) {
        if (std::exchange(last_axis, axis) != axis) pieces = space.contact_pieces.size();
        std::map<int, int> image_of;
        const auto image = [&](int point) {
            if (point == ContactPiece::none) return point;
            const auto at = static_cast<std::size_t>(point);
            if (std::abs(space.contact_points[at][axis] - plane) <= tolerance(space)) return point;
            const auto [found, is_new] = image_of.try_emplace(point, static_cast<int>(points.size()));
            if (is_new) {
                DrawnPoint reflected = points[at];
                reflected.reflection.add(axis, plane);
                Vec there = space.contact_points[at];
                there[axis] = 2 * plane - there[axis];
                points.push_back(reflected);
                space.contact_points.push_back(there);
            }
            return found->second;
        };
        for (std::size_t k = 0; k < pieces; ++k) {
            const ContactPiece piece = space.contact_pieces[k];
            const auto at = [&](int point) { return space.contact_points[static_cast<std::size_t>(point)][axis]; };
            if (space.parts[static_cast<std::size_t>(piece.part)].kind == PartKind::rigid &&
                !(std::min(std::abs(at(piece.a) - plane), std::abs(at(piece.b) - plane)) < walls_within))
                continue;
            // Turned round, so that the solid stays on its side.
            ContactPiece reflected = piece;
            reflected.a = image(piece.b);
            reflected.b = image(piece.a);
            reflected.c = image(piece.c);
            space.contact_pieces.push_back(reflected);
        }
    });
    return points;
}

}  // namespace dmp::solver
