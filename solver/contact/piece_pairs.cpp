// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/piece_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "particles/cell_grid.hpp"

namespace dmp::solver {

namespace {

/// Normals of pieces that face each other have a cosine below this; surfaces turn little within the skin.
constexpr double may_face = 0.5;

Vec middle(const SurfacePiece& piece) { return piece.at(piece.middle()); }

double radius(const SurfacePiece& piece) {
    const Vec from = middle(piece);
    double square = 0;
    for (std::size_t c = 0; c < piece.controls(); ++c)
        square = std::max(square, (piece.control[c] - from).squaredNorm());
    return std::sqrt(square);
}

}  // namespace

bool PiecePairs::moved_far(const ContactSurfaces& surfaces) const {
    const auto& pieces = surfaces.pieces();
    if (placed_.size() != pieces.size()) return true;
    const double most = 0.25 * skin * skin * space_.spacing * space_.spacing;
    for (std::size_t k = 0; k < pieces.size(); ++k)
        for (std::size_t c = 0; c < placed_[k].controls() && !(pieces[k].is_wall && !surfaces.walls_move()); ++c)
            if (!((pieces[k].now.control[c] - placed_[k].control[c]).squaredNorm() < most))
                return true;  // also for NaN
    return false;
}

double PiecePairs::nearest(const ContactSurfaces& surfaces) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const int k : active_) {
        const auto& own = surfaces.pieces()[static_cast<std::size_t>(k)];
        for (const Other& other : others(k)) {
            const auto& met = surfaces.pieces()[static_cast<std::size_t>(other.piece)];
            const Vec apart = (own.low - met.high - other.shift).cwiseMax(met.low + other.shift - own.high).cwiseMax(0);
            nearest = std::min(nearest, apart.norm());
        }
    }
    return nearest;
}

bool PiecePairs::update(const ContactSurfaces& surfaces) {
    if (!moved_far(surfaces)) return false;
    const auto& pieces = surfaces.pieces();
    placed_.clear();
    for (const auto& piece : pieces) placed_.push_back(piece.now);
    others_.clear();
    active_.clear();
    first_.assign(1, 0);

    // Middles moved into the box, and their images beyond periodic sides.
    double largest = 0;
    Coordinates places;
    std::vector<Vec> inside, middles, normals, at_rest;
    std::vector<double> radii;
    for (const auto& piece : pieces) {
        middles.push_back(middle(piece.now));
        normals.push_back(piece.now.normal(piece.now.middle()));
        at_rest.push_back(middle(piece.at_rest));
        radii.push_back(radius(piece.now));
        largest = std::max(largest, radii.back());
        inside.push_back(middles.back());
        for (int axis = 0; axis < space_.dimension; ++axis) {
            double& x = inside.back()[axis];
            if (!std::isfinite(x)) {  // the next step says so
                first_.assign(pieces.size() + 1, 0);
                return true;
            }
            if (space_.periodic[static_cast<std::size_t>(axis)])
                x = wrapped(x, space_.box.low[axis], space_.box.high[axis]);
            places[static_cast<std::size_t>(axis)].push_back(x);
        }
    }
    const double reach = 2 * largest + deepest_ + skin * space_.spacing;
    std::vector<PeriodicImage> images = periodic_images(places, pieces.size(), space_.box, space_.periodic, reach);
    for (const PeriodicImage& image : images)
        for (int axis = 0; axis < space_.dimension; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            places[a].push_back(places[a][static_cast<std::size_t>(image.source)] + image.shift[a]);
        }
    const CellGrid grid(places, pieces.size() + images.size(), space_.dimension, reach);

    // Held pieces, as those of a vessel, meet only what is free.
    std::vector<bool> is_seen(pieces.size(), false);
    for (std::size_t k = 0; k < pieces.size(); ++k)
        if (pieces[k].is_there && !pieces[k].is_held)
            grid.for_each_near({inside[k][0], inside[k][1], inside[k][2]}, reach, [&](int point) {
                const auto p = static_cast<std::size_t>(point);
                is_seen[p < pieces.size() ? p : static_cast<std::size_t>(images[p - pieces.size()].source)] = true;
            });
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const auto& own = pieces[k];
        if (own.is_there && own.reflection.is_none() && (!own.is_held || is_seen[k]))
            grid.for_each_near({inside[k][0], inside[k][1], inside[k][2]}, reach, [&](int point) {
                const auto p = static_cast<std::size_t>(point);
                const std::size_t j =
                    p < pieces.size() ? p : static_cast<std::size_t>(images[p - pieces.size()].source);
                const auto& other = pieces[j];
                if (!other.is_there || (own.is_held && other.is_held)) return;
                Vec place = inside[j];
                if (p >= pieces.size())
                    for (int axis = 0; axis < space_.dimension; ++axis)
                        place[axis] += images[p - pieces.size()].shift[static_cast<std::size_t>(axis)];
                const double far = radii[k] + radii[j] + deepest_ + skin * space_.spacing;
                if (!((place - inside[k]).squaredNorm() < far * far)) return;
                if (normals[k].dot(normals[j]) > may_face) return;
                if (own.solid == other.solid || (own.is_wall && other.is_root) || (other.is_wall && own.is_root)) {
                    const Vec apart = nearest_image(at_rest[k] - at_rest[j], space_);
                    if (apart.norm() < ContactSurfaces::neighbourhood * space_.spacing) return;
                }
                // From the image beside this piece to where the other is, and from this piece to where it is.
                Vec shift = (middles[k] - inside[k]) - (middles[j] - place);
                for (int axis = 0; axis < space_.dimension; ++axis)  // whole periods, whenever it looks
                    shift[axis] = space_.periodic[static_cast<std::size_t>(axis)]
                                      ? std::round(shift[axis] / space_.box.extent()[axis]) * space_.box.extent()[axis]
                                      : 0;
                others_.push_back({static_cast<int>(j), shift});
            });
        const auto begin = others_.begin() + static_cast<std::ptrdiff_t>(first_.back());
        std::sort(begin, others_.end(), [](const Other& a, const Other& b) {
            return std::tuple(a.piece, a.shift[0], a.shift[1], a.shift[2]) <
                   std::tuple(b.piece, b.shift[0], b.shift[1], b.shift[2]);
        });
        if (others_.size() > first_.back()) active_.push_back(static_cast<int>(k));
        first_.push_back(others_.size());
    }
    return true;
}

}  // namespace dmp::solver
