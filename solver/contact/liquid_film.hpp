// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <array>
#include <span>
#include <vector>

#include "models/contact/liquid_film.hpp"
#include "solver/contact/contact_surfaces.hpp"

namespace dmp::solver {

/// The films of liquid between surfaces that are nearer than particles resolve (models::LiquidFilmLaw). Its pressure is
/// quadratic on each piece of a surface, with the shares of the piece's control points, and solves Reynolds' equation
/// at the points of the piece by Galerkin's method: with w the weights of the points and K the conductance,
///   SUM w K grad N_a . grad N_b p_b = -SUM w (N_a n + h/2 grad N_a) . v     (v: past the other surface)
/// The tractions p n + h/2 grad p on the points are given by the same terms, so that films only take energy, and the
/// drag of all of them is a symmetric matrix. p = 0 along the border of the pieces that have points in a film.
class LiquidFilm {
  public:
    LiquidFilm(const LiquidFilmLaw& law, const ContactSurfaces& surfaces);

    /// A point of a piece in front of another surface, with its normal.
    struct Point {
        int piece = 0;
        std::size_t number = 0;  ///< of the point on its piece
        double gap = 0;          ///< [m]
        Vec normal = Vec::Zero();
    };
    /// The films are between these points, in the order of their pieces, and what they are in front of.
    void find(std::vector<Point> points);

    /// On the points, whose velocities past the other surface are `past`.
    struct Traction {
        Vec normal, tangential;  ///< [Pa]
    };
    [[nodiscard]] std::vector<Traction> tractions(std::span<const Vec> past) const;

    /// The matrix K of Reynolds' equation, its lower triangle [m^3/(Pa s), m^4/(Pa s)].
    [[nodiscard]] const Eigen::SparseMatrix<double>& conductance() const { return conductance_; }
    /// Calls visit(number, force) for each share in the pressure at a point, with its force on all that the point
    /// stands for, per pressure [m, m^2]: of the velocity v, K p = -force . v.
    template <class Visit>
    void for_each_pressure(std::size_t point, const Visit& visit) const {
        const Shapes& of = shapes_[point];
        const double half = 0.5 * law_.thickness(points_[point].gap);
        for (std::size_t a = 0; a < of.unknown.size(); ++a)
            if (of.unknown[a] != none)
                visit(of.unknown[a], Vec(of.weight * (of.shares[a] * points_[point].normal + half * of.slopes[a])));
    }

    [[nodiscard]] const LiquidFilmLaw& law() const { return law_; }

  private:
    static constexpr int none = -1;
    struct Shapes {
        std::array<int, SurfacePiece::most_controls> unknown{};  ///< none: p = 0 there
        std::array<double, SurfacePiece::most_controls> shares{};
        std::array<Vec, SurfacePiece::most_controls> slopes{};  ///< [1/m]
        double weight = 0;                                      ///< [m, m^2]
    };

    void number_unknowns();
    [[nodiscard]] int& unknown_of(int control) {
        return unknown_[static_cast<std::size_t>(surfaces_.source_of(control))];
    }
    [[nodiscard]] bool is_border(int control) const;
    [[nodiscard]] Shapes shapes(int piece, std::size_t number) const;

    LiquidFilmLaw law_;
    const ContactSurfaces& surfaces_;
    std::vector<Point> points_;
    std::vector<Shapes> shapes_;  ///< by point
    std::vector<bool> is_film_;   ///< by piece: whether it has points in a film
    std::vector<int> unknown_;    ///< by control point: the number of its share in p
    std::vector<int> pieces_;     ///< that have points in a film
    int unknowns_ = 0;
    Eigen::SparseMatrix<double> conductance_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace dmp::solver
