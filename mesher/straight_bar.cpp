// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/straight_bar.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace dmp::mesher {

namespace {

constexpr double least_aspect = 3, straight_within = 0.02;

/// Adds up simplices, each with a corner at the same place.
class SumOfSimplices {
  public:
    explicit SumOfSimplices(const Vec& apex) : apex_(apex) {}
    /// `others`: the other corners, two in 2-D and three in 3-D; the volume has a sign.
    void add(double volume, std::span<const Vec> others) {
        // Integrals of x and x x^T over a simplex of d dimensions with a corner at 0: V S / (d + 1) and
        // V (S S^T + SUM x x^T) / ((d + 1) (d + 2)), S the sum of the corners.
        const auto d = static_cast<double>(others.size());
        Vec sum = Vec::Zero();
        Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
        for (const Vec& corner : others) {
            const Vec x = corner - apex_;
            sum += x;
            squares += x * x.transpose();
        }
        volume_ += volume;
        first_ += volume / (d + 1) * sum;
        second_ += volume / ((d + 1) * (d + 2)) * (sum * sum.transpose() + squares);
    }
    [[nodiscard]] Moments moments() const {
        const Vec mean = first_ / volume_;
        return {std::abs(volume_), apex_ + mean,
                (volume_ < 0 ? -1 : 1) * (second_ - volume_ * mean * mean.transpose())};
    }

  private:
    Vec apex_;
    double volume_ = 0;
    Vec first_ = Vec::Zero();
    Eigen::Matrix3d second_ = Eigen::Matrix3d::Zero();
};

std::optional<MeshReport::SpringLine::Bar> bar_of(const Part& part, const Moments& drawn, const SolidCells& cells,
                                                  std::span<const Vec> corners, int dimension) {
    if (std::ranges::any_of(cells.cells, [](const SolidCell& cell) { return cell.periods != 0; })) return {};
    // Ascending eigenvalues; in 2-D the first is that of z, 0.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(drawn.second);
    const Vec moments = principal.eigenvalues(), axis = principal.eigenvectors().col(2);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec& corner : corners) {
        low = std::min(low, axis.dot(corner));
        high = std::max(high, axis.dot(corner));
    }
    const double length = high - low, nu = part.poisson_ratio;
    if (moments[2] < least_aspect * least_aspect * moments[1] ||
        std::abs(std::sqrt(12 * moments[2] / drawn.volume) / length - 1) > straight_within)
        return {};
    const Moments made = moments_of(cells);
    const double modulus = dimension == 2 ? part.youngs_modulus / (1 - nu * nu) : *part.youngs_modulus;
    MeshReport::SpringLine::Bar bar{length, {modulus * made.volume / length, made.volume / drawn.volume}, {}};
    for (int across = 3 - dimension; across < 2; ++across) {
        const Vec direction = principal.eigenvectors().col(across);
        const double second = direction.dot(made.second * direction);
        bar.bending.push_back({modulus * second / length, second / moments[across]});
    }
    return bar;
}

}  // namespace

namespace {

/// The axes of a cell, which its lattice may have turned; in 2-D without the third.
Eigen::Matrix3d axes_of(const SolidCells& solid, const SolidCell& cell) {
    const auto corner = [&](std::size_t k) -> const Vec& {
        return solid.nodes[static_cast<std::size_t>(cell.node.at(k))].position;
    };
    Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
    for (int axis = 0; axis < 3; ++axis)
        if (cell.size[axis] > 0) axes.col(axis) = (corner(std::size_t{1} << axis) - corner(0)).normalized();
    return axes;
}

}  // namespace

Moments moments_of(const Polyline& outline) {
    const auto& points = outline.points;
    SumOfSimplices sum(points.front());
    for (std::size_t n = 1; n + 1 < points.size(); ++n) {
        const Vec a = points[n] - points[0], b = points[n + 1] - points[0];
        sum.add(0.5 * (a[0] * b[1] - a[1] * b[0]), std::array{points[n], points[n + 1]});
    }
    return sum.moments();
}

Moments moments_of(const TriangleSurface& surface) {
    const Vec apex = surface.corners.front();
    SumOfSimplices sum(apex);
    for (const auto& triangle : surface.triangles) {
        std::array<Vec, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners.at(k) = surface.corners[static_cast<std::size_t>(triangle.at(k))];
        sum.add((corners[0] - apex).dot((corners[1] - apex).cross(corners[2] - apex)) / 6, corners);
    }
    return sum.moments();
}

Moments moments_of(const SolidCells& cells) {
    Moments sum;
    for (const Filling& filling : cells.fillings) {
        sum.volume += filling.volume;
        sum.centroid += filling.volume * filling.centroid;
    }
    sum.centroid /= sum.volume;
    for (std::size_t n = 0; n < cells.fillings.size(); ++n) {
        const Filling& filling = cells.fillings[n];
        const Vec off = filling.centroid - sum.centroid;
        const Eigen::Matrix3d axes = axes_of(cells, cells.cells[n]);
        sum.second += filling.volume * (off * off.transpose());
        sum.second += filling.volume * (axes * filling.moment.asDiagonal() * axes.transpose());
    }
    return sum;
}

std::optional<MeshReport::SpringLine::Bar> bar_of(const Part& part, const Region& drawn, const SolidCells& cells) {
    if (drawn.loops.size() != 1) return {};
    return bar_of(part, moments_of(drawn.loops[0]), cells, drawn.loops[0].points, 2);
}

std::optional<MeshReport::SpringLine::Bar> bar_of(const Part& part, const TriangleSurface& drawn,
                                                  const SolidCells& cells) {
    if (drawn.has_holes) return {};
    return bar_of(part, moments_of(drawn), cells, drawn.corners, 3);
}

}  // namespace dmp::mesher
