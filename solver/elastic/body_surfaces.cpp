// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces of elastic bodies as they are carried along.
#include <algorithm>

#include "models/elastic/carried_surface.hpp"
#include "solver/elastic/cell_body.hpp"

namespace dmp::solver {

namespace {

template <int D>
auto column(const Vector<double, D>& of) {
    Eigen::Matrix<double, D, 1> column;
    for (int axis = 0; axis < D; ++axis) column[axis] = of[axis];
    return column;
}

/// Whether fluid may see a particle with this surface.
bool within(double reach, const SolidSurface& surface) { return std::min(surface.depth, surface.opposite) < reach; }

template <int D>
PresentSurface carried(const SolidSurface& at_rest, const Matrix<D>& to_rest, const Matrix<D>& velocity_gradient) {
    PresentSurface present{at_rest};
    const auto surface = CarriedSurface<D>::of(at_rest.normal.head<D>(), to_rest);
    present.surface.normal.head<D>() = surface.normal;
    present.surface.depth *= surface.stretch;
    present.surface.opposite *= surface.stretch;
    present.velocity_gradient.template topLeftCorner<D, D>() = velocity_gradient;
    return present;
}

}  // namespace

template <int D>
std::vector<PresentSurface> SpringNetwork<D>::surfaces(double dt, double reach) const {
    std::vector<MotionAround<D>> around(ids_.size());
    Vectors velocity = velocity_;
    if (dt > 0)
        for (std::size_t node = 0; node < velocity.size(); ++node) velocity[node] = mean_velocity(node, dt);
    for (const auto& bond : bonds_) {
        const auto [a, b] = bond.node;
        if (!within(reach, surface_[a]) && !within(reach, surface_[b])) continue;
        const auto at_rest = column(bond.arms_at(position_at_rest_)[0]), now = column(bond.arms_at(position_)[0]);
        const auto past = column(bond.arms(velocity)[0]);
        around[a].add(at_rest, now, past);
        around[b].add(at_rest, now, past);
    }
    std::vector<PresentSurface> surfaces(ids_.size());
    for (std::size_t node = 0; node < ids_.size(); ++node) {
        surfaces[node].surface = surface_[node];
        if (within(reach, surface_[node]) && around[node].spans_space())
            surfaces[node] = carried<D>(surface_[node], around[node].to_rest(), around[node].velocity_gradient());
    }
    return surfaces;
}

template <int D>
std::vector<PresentSurface> CellBody<D>::surfaces(double dt, double reach) const {
    Vectors velocity = network_.velocities();
    if (dt > 0)
        for (std::size_t node = 0; node < velocity.size(); ++node) velocity[node] = network_.mean_velocity(node, dt);
    std::vector<PresentSurface> surfaces(cells_.size());
    for (std::size_t p = 0; p < cells_.size(); ++p) {
        surfaces[p].surface = cells_[p].surface;
        if (!within(reach, cells_[p].surface)) continue;
        const Matrix<D> to_rest = cell(p).element.gradient(cell(p).at(network_.positions())).inverse();
        surfaces[p] = carried<D>(cells_[p].surface, to_rest, cell(p).element.gradient(cell(p).of(velocity)) * to_rest);
    }
    return surfaces;
}

template std::vector<PresentSurface> SpringNetwork<2>::surfaces(double, double) const;
template std::vector<PresentSurface> SpringNetwork<3>::surfaces(double, double) const;
template std::vector<PresentSurface> CellBody<2>::surfaces(double, double) const;
template std::vector<PresentSurface> CellBody<3>::surfaces(double, double) const;

}  // namespace dmp::solver
