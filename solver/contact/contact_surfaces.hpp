// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/contact/curve_piece.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/forcing/wall_motion.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The drawn surfaces of elastic bodies and walls as the bodies carry them, in pieces that follow each other. Between
/// corners (30 degrees) that are not straight, the curve is a quadratic B-spline through the drawn points, so that its
/// normal has no steps; straight lines stay lines, piece by piece. Unknowns of all bodies are numbered one body after
/// another.
class ContactSurfaces {
  public:
    static constexpr std::size_t points_of_piece = gauss_points.size();

    struct Piece {
        int part = 0;
        int solid = 0;  ///< the body that it was drawn of; of walls -2 - part
        bool is_wall = false;
        bool is_there = true;                          ///< false where what carries it has torn apart
        int previous = -1, next = -1;                  ///< on the surface; -1: an end
        double thickness = 0;                          ///< of the solid behind it [m]
        std::array<double, points_of_piece> weight{};  ///< of its points, length at rest [m]
        CurvePiece at_rest, now;
        std::array<bool, 2> is_sharp{};  ///< whether it starts, ends at a corner that sticks out
        int wall_particle = -1;          ///< id of the wall's particle nearest to it, which takes its forces
    };

    /// As drawn. Throws InputError where a part's surface has none of its particles near.
    ContactSurfaces(const ParticleSet& set, const SpringBodies& bodies);

    /// Numbers the unknowns anew, after bodies have changed.
    void find_bodies(const SpringBodies& bodies);
    /// Moves the pieces with the bodies, whose unknowns are at these positions, and the walls.
    void place(std::span<const Vec> position, const WallMotion* walls, int threads);

    /// What a place on a surface has of the contact there, relative to the place that it meets, and its slope by the
    /// length of the curve: less towards corners that stick out, so that what slides over them is not held by them.
    struct Weight {
        double value, slope;  ///< [-], [1/m]
    };
    [[nodiscard]] static Weight weight(const Piece& piece, double t);

    [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
    [[nodiscard]] std::size_t unknowns() const { return first_unknown_.back(); }
    /// Of a body's first unknown, by body; then the number of all.
    [[nodiscard]] const std::vector<std::size_t>& first_unknown() const { return first_unknown_; }

    struct Share {
        int unknown;
        double share;
    };
    /// Calls visit(unknown, share) for the unknowns that carry the point at t of a piece; none of a wall.
    template <class Visit>
    void for_each_share(int piece, double t, const Visit& visit) const {
        const auto of_control = bernstein(t);
        for_each_control(piece, [&](const Carrier& carrier) {
            double share = 0;
            for (std::size_t k = 0; k < 3; ++k) share += of_control[k] * carrier.share[k];
            visit(carrier.unknown, share);
        });
    }
    /// Calls visit(unknown, share at the end of the piece - share at its start).
    template <class Visit>
    void for_each_share_of_chord(int piece, const Visit& visit) const {
        for_each_control(piece,
                         [&](const Carrier& carrier) { visit(carrier.unknown, carrier.share[2] - carrier.share[0]); });
    }

  private:
    /// What an unknown has of a piece's control points.
    struct Carrier {
        int unknown;
        std::array<double, 3> share;
    };
    /// A control point as shares of drawn points.
    using OfPoints = std::vector<std::pair<int, double>>;
    struct Drawn {
        std::array<OfPoints, 3> control;
    };

    template <class Visit>
    void for_each_control(int piece, const Visit& visit) const {
        const auto at = static_cast<std::size_t>(piece);
        for (std::size_t k = first_carrier_[at]; k < first_carrier_[at + 1]; ++k) visit(carriers_[k]);
    }
    void make_pieces(const ParticleSet& set);
    void add_piece(const ParticleSet& set, int part, double thickness, const std::array<OfPoints, 3>& control);
    void find_particles(const ParticleSet& set);

    ParticleSpace space_;
    std::vector<Piece> pieces_;
    std::vector<Drawn> drawn_;                      ///< of each piece
    std::vector<Vec> points_;                       ///< drawn
    std::vector<std::vector<int>> particles_near_;  ///< of each point: ids of particles of its part, nearest first
    std::vector<std::size_t> first_unknown_;
    std::vector<std::size_t> first_carrier_;  ///< of each piece; then the number of all
    std::vector<Carrier> carriers_;
    std::vector<std::array<Vec, 3>> shift_;  ///< of each piece's control points, beside what the unknowns carry [m]
};

}  // namespace dmp::solver
