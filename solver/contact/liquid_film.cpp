// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/liquid_film.hpp"

#include <algorithm>
#include <utility>

namespace dmp::solver {

namespace {

/// A film that is closed on all sides has no pressure of its own; it leaks as if it ended this far away [h_0].
constexpr double leaks_over = 100;
/// Where points of a piece are in no film the pressure falls to 0 within this [h_0].
constexpr double falls_within = 0.25;

}  // namespace

LiquidFilm::LiquidFilm(const LiquidFilmLaw& law, const ContactSurfaces& surfaces)
    : law_(law), surfaces_(surfaces), is_film_(surfaces.pieces().size(), false), unknown_(surfaces.controls(), none) {}

bool LiquidFilm::is_border(int control) const {
    const std::span<const int> around = surfaces_.pieces_at(control);
    return surfaces_.is_border(control) || std::ranges::any_of(around, [&](int piece) {
               return !surfaces_.is_image(piece) && !is_film_[static_cast<std::size_t>(piece)];
           });
}

void LiquidFilm::number_unknowns() {
    for (const int piece : pieces_) {
        is_film_[static_cast<std::size_t>(piece)] = false;
        for (const int control : surfaces_.pieces()[static_cast<std::size_t>(piece)].control)
            unknown_of(control) = none;
    }
    pieces_.clear();
    for (const Point& point : points_)
        if (pieces_.empty() || pieces_.back() != point.piece) pieces_.push_back(point.piece);
    for (const int piece : pieces_) is_film_[static_cast<std::size_t>(piece)] = true;
    unknowns_ = 0;
    for (const int number : pieces_) {
        const auto& piece = surfaces_.pieces()[static_cast<std::size_t>(number)];
        for (std::size_t c = 0; c < piece.now.controls(); ++c)
            if (int& unknown = unknown_of(piece.control[c]); unknown == none && !is_border(piece.control[c]))
                unknown = unknowns_++;
    }
}

LiquidFilm::Shapes LiquidFilm::shapes(int number, std::size_t point) const {
    const auto& piece = surfaces_.pieces()[static_cast<std::size_t>(number)];
    const PiecePlace& place = surfaces_.points()[point].place;
    Shapes shapes{{}, piece.now.shares(place), piece.now.share_slopes(place), piece.weight[point]};
    shapes.unknown.fill(none);
    for (std::size_t c = 0; c < piece.now.controls(); ++c)
        shapes.unknown[c] = unknown_[static_cast<std::size_t>(surfaces_.source_of(piece.control[c]))];
    return shapes;
}

void LiquidFilm::find(std::vector<Point> points) {
    points_ = std::move(points);
    number_unknowns();
    shapes_.clear();
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](const Shapes& of, double conductance, double leak) {
        for (std::size_t a = 0; a < of.unknown.size(); ++a)
            for (std::size_t b = 0; b < of.unknown.size(); ++b)
                if (of.unknown[b] != none && of.unknown[a] >= of.unknown[b])
                    entries.emplace_back(of.unknown[a], of.unknown[b],
                                         of.weight * (conductance * of.slopes[a].dot(of.slopes[b]) +
                                                      leak * of.shares[a] * of.shares[b]));
    };
    const double h0 = law_.thickest;
    auto next = points_.begin();
    for (const int piece : pieces_)
        for (std::size_t p = 0; p < surfaces_.points().size(); ++p) {
            const Shapes of = shapes(piece, p);
            if (next == points_.end() || next->piece != piece || next->number != p) {
                const double outside = law_.conductance(h0);
                add(of, outside, outside / (falls_within * falls_within * h0 * h0));
                continue;
            }
            const double conductance = law_.conductance(next->gap);
            add(of, conductance, conductance / (leaks_over * leaks_over * h0 * h0));
            shapes_.push_back(of);
            ++next;
        }
    conductance_.resize(unknowns_, unknowns_);
    conductance_.setFromTriplets(entries.begin(), entries.end());
    if (unknowns_ > 0) solver_.compute(conductance_);
}

std::vector<LiquidFilm::Traction> LiquidFilm::tractions(std::span<const Vec> past) const {
    Eigen::VectorXd pressure = Eigen::VectorXd::Zero(unknowns_);
    for (std::size_t k = 0; k < points_.size(); ++k)
        for_each_pressure(k, [&](int unknown, const Vec& force) { pressure[unknown] -= force.dot(past[k]); });
    if (unknowns_ > 0) pressure = solver_.solve(pressure).eval();
    std::vector<Traction> tractions(points_.size());
    for (std::size_t k = 0; k < points_.size(); ++k) {
        const auto& [piece, number, gap, normal] = points_[k];
        double p = 0;
        Vec slope = Vec::Zero();
        for (std::size_t a = 0; a < shapes_[k].unknown.size(); ++a)
            if (const int unknown = shapes_[k].unknown[a]; unknown != none) {
                p += shapes_[k].shares[a] * pressure[unknown];
                slope += pressure[unknown] * shapes_[k].slopes[a];
            }
        const Vec along = past[k] - past[k].dot(normal) * normal;
        tractions[k] = {p * normal, 0.5 * law_.thickness(gap) * slope - law_.drag(gap) * along};
    }
    return tractions;
}

}  // namespace dmp::solver
