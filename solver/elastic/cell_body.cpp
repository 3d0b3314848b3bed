// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic/cell_body.hpp"

#include <algorithm>
#include <stdexcept>

namespace dmp::solver {

namespace {

template <int D>
Vec in_space(const Vector<double, D>& point) {
    Vec in = Vec::Zero();
    for (int axis = 0; axis < D; ++axis) in[axis] = point[axis];
    return in;
}

[[noreturn]] void not_in_implicit_viscosity() {
    throw std::logic_error("a body of cells in a scene with implicit viscosity");
}

}  // namespace

template <int D>
CellBody<D>::CellBody(const BodyParts& parts, const std::string& name, double spacing, const SpringContact& contact)
    : SpringBody(name), network_(parts, name, spacing, {}), cells_(parts.cells) {
    for (const BodyParts::Cell& cell : cells_) {
        ids_.push_back(cell.id);
        mass_.push_back(cell.mass);
        origin_.push_back(cell.origin);
    }
    for (const LocalCell<D>& cell : network_.cells())
        fixed_.push_back(std::ranges::all_of(cell.node, [&](int node) { return parts.nodes[node].fixed; }) ? 1 : 0);
    of_wall_.assign(ids_.size(), 0);
    drag_.assign(ids_.size(), 0);  // the nodes have it
    if (contact.on()) self_contact_ = std::make_unique<SelfContact<D>>(contact, parts.held_apart);
}

template <int D>
BodyParts CellBody<D>::parts() const {
    BodyParts parts = network_.parts();
    parts.cells = cells_;
    if (self_contact_) parts.held_apart = self_contact_->held_apart();
    return parts;
}

template <int D>
typename CellBody<D>::Vectors CellBody<D>::at_centroids(const Vectors& of_nodes) const {
    Vectors centroids;
    centroids.reserve(cells_.size());
    for (const LocalCell<D>& cell : network_.cells()) centroids.push_back(cell.at_centroid(of_nodes));
    return centroids;
}

template <int D>
SpringImpulses CellBody<D>::advance(std::span<const Vec> force, double dt, int substeps) {
    Vectors on_particles(cells_.size());
    for (std::size_t p = 0; p < cells_.size(); ++p)
        for (int axis = 0; axis < D; ++axis) on_particles[p][axis] = force[p][axis];
    if (self_contact_) self_contact_->add_forces(at_centroids(network_.positions()), on_particles);
    std::vector<Vec> on_nodes(network_.nodes(), Vec::Zero());
    for (std::size_t p = 0; p < cells_.size(); ++p)
        for (std::size_t k = 0; k < cell(p).node.size(); ++k)
            on_nodes[cell(p).node[k]] += cell(p).element.share[static_cast<int>(k)] * in_space<D>(on_particles[p]);
    return network_.advance(on_nodes, dt, substeps);
}

template <int D>
std::vector<Vec> CellBody<D>::balance(std::span<const Vec> /*w*/, double /*dt*/) const {
    not_in_implicit_viscosity();
}
template <int D>
void CellBody<D>::prepare_in_fluid(std::span<const Vec> /*w*/, std::span<const Vec> /*drag*/, double /*dt*/) {
    not_in_implicit_viscosity();
}
template <int D>
void CellBody<D>::multiply_in_fluid(std::span<Vec> /*values*/) const {
    not_in_implicit_viscosity();
}
template <int D>
void CellBody<D>::solve_in_fluid(std::span<Vec> /*values*/) const {
    not_in_implicit_viscosity();
}
template <int D>
void CellBody<D>::expect(std::span<const Vec> /*w*/) {
    not_in_implicit_viscosity();
}

template <int D>
Vec CellBody<D>::position(std::size_t node) const {
    return in_space<D>(cell(node).at_centroid(network_.positions()));
}
template <int D>
Vec CellBody<D>::position_before(std::size_t node) const {
    return in_space<D>(cell(node).at_centroid(network_.positions_before()));
}
template <int D>
Vec CellBody<D>::rest_position(std::size_t node) const {
    return in_space<D>(cell(node).at_centroid(network_.positions_at_rest()));
}

template <int D>
double CellBody<D>::self_contact_rate() const {
    if (!self_contact_) return 0;
    std::vector<double> inverse_mass;
    inverse_mass.reserve(cells_.size());
    for (std::size_t p = 0; p < cells_.size(); ++p) inverse_mass.push_back(fixed_[p] ? 0 : 1 / mass_[p]);
    return self_contact_->rate(at_centroids(network_.positions()), inverse_mass);
}

template <int D>
double CellBody<D>::volume_ratio(std::size_t node) const {
    return cell(node).volume_ratio(network_.positions());
}

template <int D>
std::vector<std::array<double, 6>> CellBody<D>::virial() const {
    std::vector<std::array<double, 6>> virial;
    virial.reserve(cells_.size());
    for (std::size_t p = 0; p < cells_.size(); ++p) {
        const auto corners = cell(p).of(network_.positions());
        const double volume = cell(p).element.volume * cell(p).element.gradient(corners).determinant();
        Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();
        stress.topLeftCorner<D, D>() = cell(p).stress(corners);
        virial.push_back({-volume * stress(0, 0), -volume * stress(1, 1), -volume * stress(2, 2),
                          -volume * stress(0, 1), -volume * stress(1, 2), -volume * stress(0, 2)});
    }
    return virial;
}

template class CellBody<2>;
template class CellBody<3>;

}  // namespace dmp::solver
