// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/contact/drawn_surfaces.hpp"
#include "solver/contact/reflection.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/forcing/wall_motion.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The drawn surfaces of elastic bodies and walls (DrawnSurfaces) as the bodies carry them. Their control points move
/// with the unknowns of the bodies, which are numbered one body after another. Beyond planes of symmetry they go on as
/// their images, which are met like all others, but whose own points meet nothing: their contact is that of what they
/// are images of.
class ContactSurfaces {
  public:
    static constexpr int no_body = -1;
    /// Neighbours on one surface do not touch, nor what is so near to where it is held the wall there [spacings].
    static constexpr double neighbourhood = 3;

    struct Piece {
        int part = 0;
        int solid = 0;  ///< the body that it was drawn of; of walls -2 - part
        bool is_wall = false;
        Reflection reflection{};  ///< of images: of what
        bool is_there = true;     ///< false where what carries it has torn apart
        bool is_held = false;     ///< whether it is a wall's, or all that carries it is held
        bool is_root = false;     ///< whether it is near where its body is held
        double thickness = 0;     ///< of the solid behind it [m]
        std::array<int, SurfacePiece::most_controls> control{};  ///< numbers of its control points
        /// Of its points: length, area at rest, as far as it is no image [m, m^2].
        std::array<double, 4> weight{};
        SurfacePiece at_rest, now;
        Vec low, high;                              ///< of a box that holds the piece [m]
        std::array<double, 3> of_corners{1, 1, 1};  ///< 0 at those that stick out, or lie on an edge that does
        int wall_particle = -1;                     ///< id of the wall's particle nearest to it, which takes its forces
    };

    /// As drawn. Throws InputError where a part's surface has none of its particles near.
    ContactSurfaces(const ParticleSet& set, const SpringBodies& bodies);

    /// Numbers the unknowns anew, after bodies have changed.
    void find_bodies(const SpringBodies& bodies);
    /// Moves the pieces with the bodies, whose unknowns are at these positions, and the walls.
    void place(std::span<const Vec> position, const WallMotion* walls, int threads);

    /// What a place on a surface has of the contact there, relative to the place that it meets, and its gradient along
    /// the surface: less towards corners that stick out, so that what slides over them is not held by them.
    struct Weight {
        double value;  ///< [-]
        Vec slope;     ///< [1/m]
    };
    [[nodiscard]] static Weight weight(const Piece& piece, const PiecePlace& place);

    [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
    [[nodiscard]] bool is_image(int piece) const {
        return !pieces_[static_cast<std::size_t>(piece)].reflection.is_none();
    }
    /// The control point that one is the image of, or itself.
    [[nodiscard]] int source_of(int control) const { return source_[static_cast<std::size_t>(control)]; }
    /// Of a piece.
    [[nodiscard]] std::span<const QuadraturePoint> points() const { return quadrature(corners_); }
    [[nodiscard]] bool walls_move() const { return walls_move_; }
    [[nodiscard]] std::size_t controls() const { return controls_.size(); }
    [[nodiscard]] std::size_t unknowns() const { return first_unknown_.back(); }
    /// Of a body's first unknown, by body; then the number of all.
    [[nodiscard]] const std::vector<std::size_t>& first_unknown() const { return first_unknown_; }

    /// The sum of the normals of all pieces that share a place on a piece's border.
    [[nodiscard]] Vec normal_at_border(int piece, const PiecePlace& place) const;
    /// Whether there is nothing beyond this place on a piece's border: it sticks out, or the surface ends there.
    [[nodiscard]] bool is_end(int piece, const PiecePlace& place) const;

    /// Pieces that have a control point as a corner, or an edge.
    [[nodiscard]] std::span<const int> pieces_at(int control) const {
        const auto at = static_cast<std::size_t>(control);
        return std::span(pieces_at_).subspan(first_piece_at_[at], first_piece_at_[at + 1] - first_piece_at_[at]);
    }
    /// Whether the surface ends at a control point.
    [[nodiscard]] bool is_border(int control) const { return is_border_[static_cast<std::size_t>(control)]; }

    /// The body that carries a control point; no_body: none, it is a wall's.
    [[nodiscard]] int body_of(int control) const { return body_[static_cast<std::size_t>(control)]; }
    struct Share {
        int unknown;
        std::uint8_t reflected;  ///< Reflection::axes
        double share;

        /// What it has of a velocity of the unknown, and the unknown of a force on the control point.
        [[nodiscard]] Vec of(const Vec& vector) const { return share * Reflection::of_vector(reflected, vector); }
    };
    /// What carries a control point; none of a wall's.
    [[nodiscard]] std::span<const Share> carriers(int control) const {
        const auto at = static_cast<std::size_t>(control);
        return std::span(carriers_).subspan(first_carrier_[at], first_carrier_[at + 1] - first_carrier_[at]);
    }
    /// Of values of the unknowns, as velocities, that of a control point.
    [[nodiscard]] Vec carried(int control, std::span<const Vec> of_unknown) const {
        Vec sum = Vec::Zero();
        for (const Share& share : carriers(control))
            sum += share.of(of_unknown[static_cast<std::size_t>(share.unknown)]);
        return sum;
    }

  private:
    /// The control point on whose corner or edge a place on the border lies; -1: it is inside.
    [[nodiscard]] int control_at(const Piece& piece, const PiecePlace& place) const;
    void find_particles(const ParticleSet& set);
    void find_pieces_at_controls();
    void find_sources();
    void find_images_of_other_bodies();
    void find_roots(const SpringBodies& bodies);
    [[nodiscard]] bool is_fixed(const SpringBodies& bodies, int body, int unknown) const;

    ParticleSpace space_;
    std::size_t corners_;
    bool walls_move_ = false;
    std::vector<DrawnPoint> drawn_points_;  ///< by point of the space
    std::vector<DrawnSurfaces::OfPoints> controls_;
    std::vector<int> source_;           ///< by control point
    std::vector<bool> is_end_;          ///< by control point
    std::vector<bool> is_border_;       ///< by control point
    std::vector<Vec> control_at_rest_;  ///< by control point
    std::vector<Piece> pieces_;
    std::vector<std::vector<int>> particles_near_;  ///< of each drawn point: ids of its part's particles, nearest first
    std::vector<std::size_t> first_piece_at_;       ///< by control point; then the number of all
    std::vector<int> pieces_at_;                    ///< that have it as a corner, or an edge

    std::vector<std::size_t> first_unknown_;
    std::vector<std::size_t> first_carrier_;  ///< by control point; then the number of all
    std::vector<Share> carriers_;
    std::vector<int> body_;              ///< by control point
    std::vector<Vec> shift_;             ///< by control point, beside what the unknowns carry [m]
    std::vector<Vec> control_position_;  ///< by control point
};

}  // namespace dmp::solver
