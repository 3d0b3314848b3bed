// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Elastic bodies of cells, and where they rest under loads on their nodes.
#pragma once

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include "mesher/region_on_boxes.hpp"
#include "solver/elastic/cell_body.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/statics.hpp"

namespace dmp::tests::cell_bodies {

struct Material {
    double youngs_modulus = 1, poisson_ratio = 0.25, density = 1;
    ElasticLaw law{};

    [[nodiscard]] LameConstants constants() const { return LameConstants::of(youngs_modulus, poisson_ratio); }
    /// E' of plane strain [Pa].
    [[nodiscard]] double held_modulus() const { return youngs_modulus / (1 - poisson_ratio * poisson_ratio); }
    /// Of waves of compression [m/s].
    [[nodiscard]] double sound_speed() const { return std::sqrt((constants().lambda + 2 * constants().mu) / density); }
    [[nodiscard]] Part part() const {
        Part part = part_with(0);
        part.model = ElasticModel::cells;
        part.youngs_modulus = youngs_modulus;
        part.poisson_ratio = poisson_ratio;
        part.density = density;
        part.elastic_law = law;
        return part;
    }
};

using Pick = std::function<bool(const Vec& at)>;
inline bool nowhere(const Vec& /*at*/) { return false; }

inline BoxLattice lattice(int dimension, double spacing, const Vec& origin = Vec::Zero()) {
    Vec step = Vec::Constant(spacing);
    if (dimension == 2) step[2] = 0;
    return {dimension, origin, step};
}

/// Full cells side by side from the lattice's origin on.
inline SolidCells block(const BoxLattice& boxes, const std::array<int, 3>& count) {
    const auto full = [&](const std::array<int, 3>& box) {
        return Filling{boxes.volume(), boxes.middle(box), boxes.step.cwiseAbs2() / 12};
    };
    return solid_cells(boxes, {0, 0, 0}, count, {full, [](const auto& /*box*/, int /*axis*/) { return true; }});
}

/// A set whose bodies are the pieces of this solid, with those of its nodes clamped that are picked.
inline ParticleSet set_of(const SolidCells& solid, int dimension, const Material& material, const Pick& clamped) {
    std::vector<Vec> centroids;
    std::vector<double> masses;
    for (const Filling& filling : solid.fillings) {
        centroids.push_back(filling.centroid);
        masses.push_back(filling.volume * material.density);
    }
    ParticleSet set = set_of_nodes(dimension, centroids, masses);
    set.spacing = solid.cells.front().size[0];
    set.body = solid.piece;
    set.cells = solid.cells;
    set.cell_nodes = solid.nodes;
    for (std::size_t n = 0; n < set.size(); ++n) set.volume[n] = solid.fillings[n].volume;
    for (CellNode& node : set.cell_nodes) node.fixed = clamped(node.position);
    return set;
}

template <int D>
using Vectors = typename CellBody<D>::Vectors;

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

/// The parts of a solid of one piece.
template <int D>
BodyParts parts_of(const SolidCells& solid, const Material& material, const Pick& clamped = nowhere) {
    EXPECT_EQ(solid.pieces, 1);
    EXPECT_EQ(solid.lost, 0U);
    const ParticleSet set = set_of(solid, D, material, clamped);
    return initial_cells(set, InitialSprings(set, material.part()), 0, 0);
}

template <int D>
CellBody<D> body_of(const BodyParts& parts) {
    return CellBody<D>(parts, "beam", parts.cells.front().size[0], {});
}
template <int D>
CellBody<D> body_of(const SolidCells& solid, const Material& material, const Pick& clamped = nowhere) {
    return body_of<D>(parts_of<D>(solid, material, clamped));
}

/// A beam along x, 1 m thick, clamped at x = 0.
inline CellBody<2> cantilever(int across, int length, const Material& material) {
    const double a = 1.0 / across;
    return body_of<2>(block(lattice(2, a), {length * across, across, 1}), material,
                      [=](const Vec& at) { return at[0] < 1e-6 * a; });
}

/// How far the node that was here has moved.
inline Vec at_node(const CellBody<2>& body, const Vec& place) {
    const auto& network = body.network();
    for (std::size_t n = 0; n < network.nodes(); ++n)
        if ((network.rest_position(n) - place).norm() < 1e-9) return network.displacement(n);
    throw std::logic_error("no node there");
}

/// How far the middle of the end x = length of a beam along x, 1 m thick, has moved.
inline Vec tip(const CellBody<2>& body, double length) { return at_node(body, Vec(length, 0.5, 0)); }

/// By node, with a force for each place at rest and mass [N].
template <int D>
Vectors<D> on_nodes(const CellBody<D>& body, const std::function<Vec(const Vec& at, double mass)>& force) {
    const auto& network = body.network();
    Vectors<D> load(network.nodes());
    for (std::size_t n = 0; n < load.size(); ++n)
        load[n] = of_space<D>(force(network.rest_position(n), network.mass(n)));
    return load;
}
/// The same from forces on particles, for each centroid and volume of solid.
template <int D>
Vectors<D> on_particles(const CellBody<D>& body, const std::function<Vec(const Vec& at, double volume)>& force) {
    Vectors<D> load(body.network().nodes(), Vector<double, D>{});
    for (std::size_t p = 0; p < body.nodes(); ++p) {
        const LocalCell<D>& cell = body.network().cells()[p];
        const auto at_particle = of_space<D>(force(body.rest_position(p), cell.element.volume));
        for (std::size_t k = 0; k < cell.node.size(); ++k)
            load[cell.node[k]] += cell.element.share[static_cast<int>(k)] * at_particle;
    }
    return load;
}

/// A force [N] on those nodes of a face x = const of a block that spans 0 to `thickness` in the other axes, which are a
/// spacing apart: each has its share of the face.
template <int D>
Vectors<D> on_end(const CellBody<D>& body, double x, double thickness, double spacing,
                  const std::function<Vec(const Vec& at)>& stress) {
    return on_nodes<D>(body, [&](const Vec& at, double /*mass*/) -> Vec {
        if (std::abs(at[0] - x) > 1e-6 * spacing) return Vec::Zero();
        double share = 1;
        for (int axis = 1; axis < D; ++axis)
            share *= std::min(at[axis], thickness - at[axis]) < 1e-6 * spacing ? spacing / 2 : spacing;
        return share * stress(at);
    });
}

/// The unknowns of a body: the components of its free nodes. Its stiffness is exact, from differences of the forces of
/// each cell.
template <int D>
class Unknowns {
  public:
    explicit Unknowns(const CellBody<D>& body) : network_(body.network()) {
        for (std::size_t n = 0; n < network_.nodes(); ++n) first_.push_back(network_.fixed(n) ? -1 : D * free_++);
    }

    [[nodiscard]] Eigen::SparseMatrix<double> stiffness(const Vectors<D>& position) const {
        using Corners = typename LocalCell<D>::Corners;
        std::vector<Eigen::Triplet<double>> entries;
        for (const LocalCell<D>& cell : network_.cells()) {
            const double d = 1e-5 * std::pow(cell.element.volume, 1.0 / D);
            const Corners corners = cell.of(position);
            for (int column = 0; column < LocalCell<D>::Element::unknowns; ++column) {
                const int to = first_[cell.node[column / D]];
                if (to < 0) continue;
                Corners ahead = corners, behind = corners;
                ahead(column % D, column / D) += d;
                behind(column % D, column / D) -= d;
                const Corners rate =
                    (cell.forces(behind, Corners::Zero()) - cell.forces(ahead, Corners::Zero())) / (2 * d);
                for (int row = 0; row < LocalCell<D>::Element::unknowns; ++row)
                    if (const int from = first_[cell.node[row / D]]; from >= 0)
                        entries.emplace_back(from + row % D, to + column % D, rate(row % D, row / D));
            }
        }
        Eigen::SparseMatrix<double> matrix(D * free_, D * free_);
        matrix.setFromTriplets(entries.begin(), entries.end());
        return matrix;
    }

    [[nodiscard]] Eigen::VectorXd row(const Vectors<D>& value) const {
        Eigen::VectorXd flat(D * free_);
        for (std::size_t n = 0; n < value.size(); ++n)
            for (int axis = 0; axis < D && first_[n] >= 0; ++axis) flat[first_[n] + axis] = value[n][axis];
        return flat;
    }
    void add(const Eigen::VectorXd& flat, Vectors<D>& value) const {
        for (std::size_t n = 0; n < value.size(); ++n)
            for (int axis = 0; axis < D && first_[n] >= 0; ++axis) value[n][axis] += flat[first_[n] + axis];
    }
    [[nodiscard]] bool all_free() const { return static_cast<std::size_t>(free_) == network_.nodes(); }

  private:
    const SpringNetwork<D>& network_;
    std::vector<int> first_;
    int free_ = 0;
};

/// Moves the nodes by what these loads [N] cause at first order. Loads on a body without clamped nodes have to be in
/// balance; how it moves as a whole is left open.
template <int D>
void respond(CellBody<D>& body, const Vectors<D>& load) {
    const Unknowns<D> unknowns(body);
    Eigen::SparseMatrix<double> matrix = unknowns.stiffness(body.network().positions_at_rest()), held = matrix;
    if (unknowns.all_free())
        for (int k = 0; k < held.rows(); ++k) held.coeffRef(k, k) *= 1 + 1e-7;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(held);
    const Eigen::VectorXd full = unknowns.row(load);
    Eigen::VectorXd moved = solver.solve(full);
    double change = 1;
    for (int iteration = 0; change > 1e-8; ++iteration) {
        ASSERT_LT(iteration, 40) << "no solution, last change " << change;
        const Eigen::VectorXd correction = solver.solve(full - matrix * moved);
        moved += correction;
        change = std::abs(full.dot(correction) / full.dot(moved));  // which does not know motions as a whole
    }
    body.network().positions() = body.network().positions_at_rest();
    unknowns.add(moved, body.network().positions());
}

/// Moves the nodes of a clamped body to where it rests under these loads [N], which grow in steps, by Newton's method.
template <int D>
void settle(CellBody<D>& body, const Vectors<D>& load, int steps) {
    const Unknowns<D> unknowns(body);
    const Vectors<D> resting(load.size(), Vector<double, D>{});
    Vectors<D>& position = body.network().positions();
    const double spacing = std::pow(body.network().cells().front().element.volume, 1.0 / D);
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
    const Eigen::VectorXd full = unknowns.row(load);
    for (int step = 1; step <= steps; ++step) {
        double change = 1;  // spacings
        for (int iteration = 0; change > 1e-8; ++iteration) {
            ASSERT_LT(iteration, 40) << "no rest at step " << step << ", last change " << change << " spacings";
            if (change > 1e-4) solver.compute(unknowns.stiffness(position));
            const Eigen::VectorXd left = full * step / steps + unknowns.row(body.network().forces(position, resting));
            const Eigen::VectorXd correction = solver.solve(left);
            unknowns.add(correction, position);
            change = correction.cwiseAbs().maxCoeff() / spacing;
        }
    }
}

}  // namespace dmp::tests::cell_bodies
