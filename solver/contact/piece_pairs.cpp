// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/piece_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "particles/cell_grid.hpp"

namespace dmp::solver {

namespace {

/// Pieces may move by half of it before they are looked for anew; neighbours on one surface do not touch [spacings].
constexpr double skin = 0.4, neighbourhood = 3;
/// Normals of pieces that face each other have a cosine below this; surfaces turn little within the skin.
constexpr double may_face = 0.5;

Vec middle(const SurfacePiece& piece) { return piece.at(piece.middle()); }

Vec normal_of(const SurfacePiece& piece) { return piece.normal(piece.middle()); }

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
        for (std::size_t c = 0; c < placed_[k].controls(); ++c)
            if (!((pieces[k].now.control[c] - placed_[k].control[c]).squaredNorm() < most))
                return true;  // also for NaN
    return false;
}

double PiecePairs::nearest(const ContactSurfaces& surfaces) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const int k : active_) {
        const auto [low, high] = surfaces.pieces()[static_cast<std::size_t>(k)].now.box();
        for (const Other& other : others(k)) {
            const auto [other_low, other_high] = surfaces.pieces()[static_cast<std::size_t>(other.piece)].now.box();
            const Vec apart = (low - other_high - other.shift).cwiseMax(other_low + other.shift - high).cwiseMax(0);
            nearest = std::min(nearest, apart.norm());
        }
    }
    return nearest;
}

void PiecePairs::update(const ContactSurfaces& surfaces) {
    if (!moved_far(surfaces)) return;
    const auto& pieces = surfaces.pieces();
    placed_.clear();
    for (const auto& piece : pieces) placed_.push_back(piece.now);
    others_.clear();
    active_.clear();
    first_.assign(1, 0);

    // Middles moved into the box, and their images beyond periodic sides.
    double largest = 0;
    Coordinates places;
    std::vector<Vec> inside;
    for (const auto& piece : pieces) {
        largest = std::max(largest, radius(piece.now));
        inside.push_back(middle(piece.now));
        for (int axis = 0; axis < space_.dimension; ++axis) {
            double& x = inside.back()[axis];
            if (!std::isfinite(x)) {  // the next step says so
                first_.assign(pieces.size() + 1, 0);
                return;
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

    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const auto& own = pieces[k];
        const Vec normal = normal_of(own.now);
        if (own.is_there)
            grid.for_each_near({inside[k][0], inside[k][1], inside[k][2]}, reach, [&](int point) {
                const auto p = static_cast<std::size_t>(point);
                const std::size_t j =
                    p < pieces.size() ? p : static_cast<std::size_t>(images[p - pieces.size()].source);
                const auto& other = pieces[j];
                if (!other.is_there || (own.is_wall && other.is_wall)) return;
                Vec place = inside[j];
                if (p >= pieces.size())
                    for (int axis = 0; axis < space_.dimension; ++axis)
                        place[axis] += images[p - pieces.size()].shift[static_cast<std::size_t>(axis)];
                if (!((place - inside[k]).norm() <
                      radius(own.now) + radius(other.now) + deepest_ + skin * space_.spacing))
                    return;
                if (normal.dot(normal_of(other.now)) > may_face) return;
                if (own.solid == other.solid) {
                    const Vec apart = nearest_image(middle(own.at_rest) - middle(other.at_rest), space_);
                    if (apart.norm() < neighbourhood * space_.spacing) return;
                }
                // From the image beside this piece to where the other is, and from this piece to where it is.
                Vec shift = (middle(own.now) - inside[k]) - (middle(other.now) - place);
                for (int axis = 0; axis < space_.dimension; ++axis)  // whole periods, whenever it looks
                    shift[axis] = space_.periodic[static_cast<std::size_t>(axis)]
                                      ? std::round(shift[axis] / space_.box.extent()[axis]) * space_.box.extent()[axis]
                                      : 0;
                others_.push_back({static_cast<int>(j), shift});
            });
        const auto begin = others_.begin() + static_cast<std::ptrdiff_t>(first_.back());
        std::sort(begin, others_.end(), [](const Other& a, const Other& b) { return a.piece < b.piece; });
        if (others_.size() > first_.back()) active_.push_back(static_cast<int>(k));
        first_.push_back(others_.size());
    }
}

}  // namespace dmp::solver
