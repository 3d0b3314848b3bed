// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Points of the material as an elastic body's unknowns carry them.
#include <Eigen/Dense>
#include <algorithm>
#include <limits>

#include "solver/elastic/cell_body.hpp"

namespace dmp::solver {

namespace {

/// Whole periods from the point to its image nearest to `to` [m].
Vec periods_towards(const Vec& to, const Vec& point, const ParticleSpace& space) {
    return nearest_image(point - to, space) - (point - to);
}

}  // namespace

/// By the shape functions of the cell whose box is nearest, of those between nodes that are not much lighter than whole
/// cells': a force on light ones would need a short step.
template <int D>
CarriedPoint CellBody<D>::carry(const Vec& at_rest, std::span<const int> near, const ParticleSpace& space) const {
    constexpr double lightest = 0.1;  // of the mass of a whole cell
    CarriedPoint carried;
    double nearest = std::numeric_limits<double>::infinity();
    bool is_light = true;
    for (const int particle : near) {
        const LocalCell<D>& of_cell = cell(static_cast<std::size_t>(particle));
        const BodyParts::Cell& made = cells_[static_cast<std::size_t>(particle)];
        const double whole = made.mass / made.volume * made.size.template head<D>().prod();
        const bool is_lighter = std::ranges::any_of(
            of_cell.node, [&](int node) { return network_.mass(static_cast<std::size_t>(node)) < lightest * whole; });
        if (is_lighter && !is_light) continue;
        const auto corners = of_cell.at(network_.positions_at_rest());
        Vec middle = Vec::Zero();
        middle.head<D>() = corners.rowwise().mean();
        const Vec shift = periods_towards(at_rest, middle, space);
        Eigen::Matrix<double, D, 1> place;  // 0 to 1 in the box
        double outside = 0;
        for (int axis = 0; axis < D; ++axis) {
            const double low = corners(axis, 0) + shift[axis];
            const double size = corners(axis, LocalCell<D>::Element::corners - 1) - corners(axis, 0);
            place[axis] = (at_rest[axis] - low) / size;
            const double beyond = size * std::max({0.0, -place[axis], place[axis] - 1});
            outside += beyond * beyond;
        }
        if (!(outside < nearest) && is_lighter == is_light) continue;
        nearest = outside;
        is_light = is_lighter;
        carried.shares.clear();
        carried.shift = shift;
        for (int k = 0; k < LocalCell<D>::Element::corners; ++k) {
            double share = 1;
            for (int axis = 0; axis < D; ++axis) share *= (k >> axis & 1) != 0 ? place[axis] : 1 - place[axis];
            carried.shares.push_back({of_cell.node[static_cast<std::size_t>(k)], share});
            carried.shift.template head<D>() += share * of_cell.shift.col(k);
        }
    }
    return carried;
}

/// By the shares that carry every uniform deformation of the nearest nodes exactly, of those the least by their
/// squares.
template <int D>
CarriedPoint SpringNetwork<D>::carry(const Vec& at_rest, std::span<const int> near, const ParticleSpace& space) const {
    constexpr std::size_t enough = D == 2 ? 4 : 8;
    std::vector<Vec> places, shifts;
    CarriedPoint carried;
    for (const int node : near) {
        shifts.push_back(periods_towards(at_rest, rest_position(static_cast<std::size_t>(node)), space));
        places.emplace_back(rest_position(static_cast<std::size_t>(node)) + shifts.back());
        carried.shares.push_back({node, 0});
        if (places.size() < enough) continue;
        Vec mean = Vec::Zero();
        for (const Vec& place : places) mean += place / static_cast<double>(places.size());
        Matrix<D> moments = Matrix<D>::Zero();
        for (const Vec& place : places) {
            const Eigen::Matrix<double, D, 1> arm = (place - mean).head<D>();
            moments += arm * arm.transpose();
        }
        const double size = moments.trace() / D;
        double cube = 1;
        for (int axis = 0; axis < D; ++axis) cube *= size;
        if (!(moments.determinant() > 1e-3 * cube)) continue;  // in a row: with one more
        const Eigen::Matrix<double, D, 1> towards = moments.inverse() * (at_rest - mean).head<D>();
        for (std::size_t k = 0; k < places.size(); ++k) {
            const double share = 1 / static_cast<double>(places.size()) + towards.dot((places[k] - mean).head<D>());
            carried.shares[k].share = share;
            carried.shift += share * shifts[k];
        }
        return carried;
    }
    // A thread: as its nearest node.
    carried.shares.resize(std::min<std::size_t>(1, carried.shares.size()));
    if (!carried.shares.empty()) {
        carried.shares[0].share = 1;
        carried.shift = at_rest - rest_position(static_cast<std::size_t>(near[0]));
    }
    return carried;
}

template <int D>
Vec SpringNetwork<D>::kick(std::span<const Vec> on_unknowns, double dt) {
    Vectors force(ids_.size());
    for (std::size_t n = 0; n < ids_.size(); ++n) force[n] = of_space(on_unknowns[n]);
    return in_space(kick_from_outside(force, dt));
}

template CarriedPoint CellBody<2>::carry(const Vec&, std::span<const int>, const ParticleSpace&) const;
template CarriedPoint CellBody<3>::carry(const Vec&, std::span<const int>, const ParticleSpace&) const;
template CarriedPoint SpringNetwork<2>::carry(const Vec&, std::span<const int>, const ParticleSpace&) const;
template CarriedPoint SpringNetwork<3>::carry(const Vec&, std::span<const int>, const ParticleSpace&) const;
template Vec SpringNetwork<2>::kick(std::span<const Vec>, double);
template Vec SpringNetwork<3>::kick(std::span<const Vec>, double);

}  // namespace dmp::solver
