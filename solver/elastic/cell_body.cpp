// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic/cell_body.hpp"

#include <algorithm>
#include <cmath>

namespace dmp::solver {

namespace {

template <int D>
Vec in_space(const Vector<double, D>& point) {
    Vec in = Vec::Zero();
    for (int axis = 0; axis < D; ++axis) in[axis] = point[axis];
    return in;
}

template <int D>
Vector<double, D> of_space(const Vec& in) {
    Vector<double, D> point;
    for (int axis = 0; axis < D; ++axis) point[axis] = in[axis];
    return point;
}

}  // namespace

template <int D>
CellBody<D>::CellBody(const BodyParts& parts, const std::string& name, double spacing, const SpringContact& contact)
    : SpringBody(name), network_(parts, name, spacing, {}), cells_(parts.cells), faces_(parts.faces) {
    for (const BodyParts::Cell& cell : cells_) {
        ids_.push_back(cell.id);
        mass_.push_back(cell.mass);
        origin_.push_back(cell.origin);
    }
    for (const LocalCell<D>& cell : network_.cells())
        fixed_.push_back(std::ranges::all_of(cell.node, [&](int node) { return parts.nodes[node].fixed; }) ? 1 : 0);
    of_wall_.assign(ids_.size(), 0);
    drag_.assign(ids_.size(), 0);  // the nodes have it
    find_heavier_nodes();
    if (contact.of_itself()) self_contact_ = std::make_unique<SelfContact<D>>(contact, parts.held_apart);
}

template <int D>
void CellBody<D>::find_heavier_nodes() {
    constexpr double rounding = 1e-9;  // of the body's mass and extent
    for (std::size_t n = 0; n < network_.nodes(); ++n)
        if (network_.fixed(n)) return;
    std::vector<Vec> of_cells;
    double total = 0;
    for (const double mass : mass_) {
        of_cells.emplace_back(mass, 0, 0);
        total += mass;
    }
    const std::vector<Vec> by_shape = at_nodes(of_cells);
    double sum = 0, largest = 0;
    for (std::size_t n = 0; n < network_.nodes(); ++n) {
        heavier_.push_back((network_.mass(n) - by_shape[n][0]) / total);
        sum += heavier_.back();
        largest = std::max(largest, std::abs(heavier_.back()));
    }
    // A piece that has torn off does not have its cells' mass to rounding.
    if (std::abs(sum) > rounding || largest < rounding / static_cast<double>(network_.nodes())) heavier_.clear();
    for (int axis = 0; axis < D; ++axis)
        for (std::size_t n = 0; n < network_.nodes(); ++n)
            is_open_[axis] = is_open_[axis] && !network_.is_held(n, axis);
    find_offsets();
}

template <int D>
Vec CellBody<D>::of_heavier_nodes(const Vectors& values) const {
    Vec sum = Vec::Zero();
    for (std::size_t n = 0; n < heavier_.size(); ++n)
        for (int axis = 0; axis < D; ++axis)
            if (is_open_[axis]) sum[axis] += heavier_[n] * values[n][axis];
    return sum;
}

template <int D>
void CellBody<D>::find_offsets() {
    Vectors moved = network_.positions(), moved_before = network_.positions_before();
    for (std::size_t n = 0; n < moved.size(); ++n) {
        moved[n] -= network_.positions_at_rest()[n];
        moved_before[n] -= network_.positions_at_rest()[n];
    }
    offset_ = of_heavier_nodes(moved);
    offset_before_ = of_heavier_nodes(moved_before);
    offset_velocity_ = of_heavier_nodes(network_.velocities());
}

template <int D>
BodyParts CellBody<D>::parts() const {
    BodyParts parts = network_.parts();
    parts.cells = cells_;
    parts.faces = faces_;
    if (self_contact_) parts.held_apart = self_contact_->held_apart();
    return parts;
}

template <int D>
typename CellBody<D>::Vectors CellBody<D>::at_centroids(const Vectors& of_nodes) const {
    Vectors centroids;
    centroids.reserve(cells_.size());
    for (const LocalCell<D>& cell : network_.cells()) centroids.push_back(cell.centroid(of_nodes));
    return centroids;
}

template <int D>
SpringImpulses CellBody<D>::advance(std::span<const Vec> force, double dt, int substeps) {
    std::vector<Vec> on_particles(force.begin(), force.begin() + static_cast<std::ptrdiff_t>(cells_.size()));
    if (self_contact_) {
        Vectors of_contact(cells_.size());
        self_contact_->add_forces(at_centroids(network_.positions()), of_contact);
        for (std::size_t p = 0; p < cells_.size(); ++p) on_particles[p] += in_space<D>(of_contact[p]);
    }
    const SpringImpulses impulses = network_.advance(at_nodes(on_particles), dt, substeps);
    find_offsets();
    return impulses;
}

template <int D>
void CellBody<D>::archive(Archive& file, const std::string& name) {
    network_.archive(file, name);
    find_offsets();
}

template <int D>
std::vector<Vec> CellBody<D>::at_nodes(std::span<const Vec> of_particles) const {
    std::vector<Vec> at_nodes(network_.nodes(), Vec::Zero());
    for (std::size_t p = 0; p < cells_.size(); ++p)
        for (std::size_t k = 0; k < cell(p).node.size(); ++k)
            at_nodes[cell(p).node[k]] += cell(p).element.share[static_cast<int>(k)] * of_particles[p];
    if (heavier_.empty()) return at_nodes;
    Vec sum = Vec::Zero();
    for (std::size_t p = 0; p < cells_.size(); ++p) sum += of_particles[p];
    for (int axis = 0; axis < 3; ++axis)
        if (axis >= D || !is_open_[axis]) sum[axis] = 0;
    for (std::size_t n = 0; n < at_nodes.size(); ++n) at_nodes[n] += heavier_[n] * sum;
    return at_nodes;
}

template <int D>
std::vector<Vec> CellBody<D>::of_particles(std::span<const Vec> of_unknowns) const {
    std::vector<Vec> of_particles;
    of_particles.reserve(cells_.size());
    Vectors of_nodes;
    for (const Vec& value : of_unknowns) of_nodes.push_back(of_space<D>(value));
    const Vec offset = of_heavier_nodes(of_nodes);
    for (std::size_t p = 0; p < cells_.size(); ++p) {
        Vec sum = offset;
        for (std::size_t k = 0; k < cell(p).node.size(); ++k)
            sum += cell(p).element.share[static_cast<int>(k)] * of_unknowns[cell(p).node[k]];
        of_particles.push_back(sum);
    }
    return of_particles;
}

template <int D>
std::vector<Vec> CellBody<D>::on_unknowns(std::span<const Vec> on_particles) const {
    std::vector<Vec> on_nodes = at_nodes(on_particles);
    for (std::size_t n = 0; n < on_nodes.size(); ++n)
        for (int axis = 0; axis < D; ++axis)
            if (network_.is_held(n, axis)) on_nodes[n][axis] = 0;
    return on_nodes;
}

template <int D>
std::vector<Vec> CellBody<D>::unknown_velocities(std::span<const Vec> /*of_particles*/) const {
    std::vector<Vec> velocities;
    velocities.reserve(network_.nodes());
    for (const Point& velocity : network_.velocities()) velocities.push_back(in_space<D>(velocity));
    return velocities;
}

template <int D>
Vec CellBody<D>::position(std::size_t node) const {
    return in_space<D>(cell(node).centroid(network_.positions())) + offset_;
}
template <int D>
Vec CellBody<D>::position_before(std::size_t node) const {
    return in_space<D>(cell(node).centroid(network_.positions_before())) + offset_before_;
}
template <int D>
Vec CellBody<D>::rest_position(std::size_t node) const {
    return in_space<D>(cell(node).centroid(network_.positions_at_rest()));
}

template <int D>
Vec CellBody<D>::velocity(std::size_t node) const {
    const typename LocalCell<D>::Element::Point velocity =
        cell(node).of(network_.velocities()) * cell(node).element.share;
    Vec in = offset_velocity_;
    in.head<D>() += velocity;
    return in;
}

template <int D>
std::vector<std::array<double, 6>> CellBody<D>::surface_stresses(std::size_t node) const {
    std::vector<std::array<double, 6>> stresses;
    for (const Matrix<3>& s : cell(node).surface_stresses(cell(node).at(network_.positions())))
        stresses.push_back({s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2)});
    return stresses;
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
        const auto corners = cell(p).at(network_.positions());
        const double volume = cell(p).element.volume * cell(p).element.gradient(corners).determinant();
        const Matrix<3> stress = cell(p).stress(corners);
        virial.push_back({-volume * stress(0, 0), -volume * stress(1, 1), -volume * stress(2, 2),
                          -volume * stress(0, 1), -volume * stress(1, 2), -volume * stress(0, 2)});
    }
    return virial;
}

template <int D>
std::optional<std::array<double, 2>> CellBody<D>::strains(std::size_t node) const {
    return cell(node).element.principal_strains(cell(node).at(network_.positions()));
}

template <int D>
std::optional<std::array<int, 2>> CellBody<D>::overloaded_face(const SolidBreak& law, int origin) const {
    struct State {
        Matrix<D> stress, gradient;
    };
    std::vector<State> of_cell;
    of_cell.reserve(cells_.size());
    for (const LocalCell<D>& cell : network_.cells()) {
        const auto corners = cell.at(network_.positions());
        of_cell.push_back({cell.stress(corners).template topLeftCorner<D, D>(), cell.element.gradient(corners)});
    }
    std::optional<std::array<int, 2>> worst;
    double highest = 0;
    for (const BodyParts::Face& face : faces_) {
        if (origin_[face.cell[0]] != origin) continue;
        const State &low = of_cell[face.cell[0]], &high = of_cell[face.cell[1]];
        const FaceState<D> between{0.5 * (low.stress + high.stress), 0.5 * (low.gradient + high.gradient), face.axis};
        const SolidBreak::Load load = law.load(between);
        if (!(load.excess > 0) || load.rank < highest) continue;
        const auto [a, b] = std::minmax(ids_[face.cell[0]], ids_[face.cell[1]]);
        const std::array<int, 2> ids{a, b};
        if (!worst || load.rank > highest || ids < *worst) worst = ids;
        highest = load.rank;
    }
    return worst;
}

template <int D>
double CellBody<D>::step_limit() const {
    double relaxation = 0;
    for (const BodyParts::Cell& cell : cells_) relaxation = std::max(relaxation, cell.relaxation);
    const double limit = network_.step_limit(), damping = relaxation / limit;  // of critical, at the highest frequency
    return limit * (std::sqrt(1 + damping * damping) - damping);
}

template class CellBody<2>;
template class CellBody<3>;

}  // namespace dmp::solver
