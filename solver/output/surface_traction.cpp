// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/surface_traction.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>

#include "particles/periodic_images.hpp"
#include "solver/output/fluid_fields.hpp"
#include "solver/output/linear_fit.hpp"

namespace dmp::solver {

namespace {

constexpr double fluid_reach = 4;  ///< R, in spacings

/// Points in a box that may be periodic, sorted into cells.
class PointGrid {
  public:
    PointGrid(const ParticleSpace& space, double reach, std::vector<Vec> points)
        : space_(space), reach_(reach), points_(std::move(points)) {
        for (int axis = 0; axis < 3; ++axis)
            if (space.periodic[axis]) {
                const double length = space.box.high[axis] - space.box.low[axis];
                cells_[axis] = std::max(1, static_cast<int>(length / reach));
                size_[axis] = length / cells_[axis];
            } else {
                size_[axis] = reach;
            }
        for (std::size_t k = 0; k < points_.size(); ++k) in_cell_[cell_of(points_[k])].push_back(k);
    }

    /// Calls visit(k, vector from `place` to the nearest image of point k) for the points within reach, in ascending
    /// order of k.
    template <class Visit>
    void for_each_near(const Vec& place, const Visit& visit) const {
        std::vector<std::size_t> near;
        for (const Cell& cell : around(cell_of(place)))
            if (const auto found = in_cell_.find(cell); found != in_cell_.end())
                near.insert(near.end(), found->second.begin(), found->second.end());
        std::ranges::sort(near);
        for (const std::size_t k : near) {
            const Vec apart = nearest_image(points_[k] - place, space_);
            if (apart.norm() < reach_) visit(k, apart);
        }
    }

    [[nodiscard]] bool any_near(const Vec& place) const {
        return std::ranges::any_of(around(cell_of(place)), [&](const Cell& cell) {
            const auto found = in_cell_.find(cell);
            return found != in_cell_.end() && std::ranges::any_of(found->second, [&](std::size_t k) {
                       return nearest_image(points_[k] - place, space_).norm() < reach_;
                   });
        });
    }

  private:
    using Cell = std::array<int, 3>;

    [[nodiscard]] Cell cell_of(const Vec& point) const {
        Cell cell{};
        for (int axis = 0; axis < space_.dimension; ++axis)
            cell[axis] = at(axis, static_cast<int>(std::floor((point[axis] - space_.box.low[axis]) / size_[axis])));
        return cell;
    }
    [[nodiscard]] int at(int axis, int index) const {
        const int cells = cells_[axis];
        return cells == 0 ? index : (index % cells + cells) % cells;
    }
    /// The cell and those beside it, each once.
    [[nodiscard]] std::vector<Cell> around(const Cell& cell) const {
        std::vector<Cell> cells;
        const int deep = space_.dimension == 3 ? 1 : 0;
        for (int z = -deep; z <= deep; ++z)
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x)
                    cells.push_back({at(0, cell[0] + x), at(1, cell[1] + y), at(2, cell[2] + z)});
        std::ranges::sort(cells);
        cells.erase(std::ranges::unique(cells).begin(), cells.end());
        return cells;
    }

    const ParticleSpace& space_;
    double reach_;
    std::array<double, 3> size_{};
    std::array<int, 3> cells_{};  ///< in a period; 0: not periodic
    std::vector<Vec> points_;
    std::map<Cell, std::vector<std::size_t>> in_cell_;
};

/// Two directions across a normal; in 2-D one, and z.
std::array<Vec, 2> across(const Vec& normal, int dimension) {
    if (dimension == 2) return {Vec(-normal[1], normal[0], 0), Vec::UnitZ()};
    Eigen::Index least = 0;
    normal.cwiseAbs().minCoeff(&least);
    const Vec first = normal.cross(Vec::Unit(least)).normalized();
    return {first, normal.cross(first)};
}

}  // namespace

std::vector<Vec> surface_normals(const SpringBody& body, const ParticleSpace& space) {
    constexpr double reach = 1.6;     // spacings: more than the diagonal of a square, less than two
    constexpr double shortest = 0.5;  // of the sum that shows a surface: 2.4 at a flat face of a square lattice
    std::vector<Vec> at_rest(body.nodes());
    for (std::size_t node = 0; node < body.nodes(); ++node) at_rest[node] = body.rest_position(node);
    const PointGrid grid(space, reach * space.spacing, at_rest);
    std::vector<Vec> normals(body.nodes(), Vec::Zero());
    for (std::size_t node = 0; node < body.nodes(); ++node) {
        Vec inwards = Vec::Zero();
        grid.for_each_near(at_rest[node], [&](std::size_t other, const Vec&) {
            const Vec apart = nearest_image(body.position(other) - body.position(node), space);
            if (other != node && apart.norm() > 0) inwards += apart.normalized();
        });
        if (inwards.norm() > shortest) normals[node] = -inwards.normalized();
    }
    return normals;
}

SurfaceTraction::SurfaceTraction(const ParticleStore& particles, const SpringBodies& springs, const Ranks& ranks)
    : space_(particles.space()) {
    std::vector<Vec> nodes;
    for (const auto& body : springs.bodies())
        for (std::size_t node = 0; node < body->nodes(); ++node) nodes.push_back(body->position(node));
    // A particle's surface is half a spacing outside of it.
    const PointGrid grid(space_, (fluid_reach + 0.5) * space_.spacing, std::move(nodes));
    const ParticleGroup& fluid = particles.fluid();
    std::vector<Sample> own;
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        Sample sample{};
        for (int axis = 0; axis < space_.dimension; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            sample.position[a] = space_.mirrored_back(fluid.data(Field::position, axis)[i], axis);
            const double velocity = fluid.data(Field::velocity, axis)[i];
            sample.velocity[a] = is_shown_mirrored(fluid, space_, axis, i) ? -velocity : velocity;
        }
        if (!grid.any_near(Vec(sample.position.data()))) continue;
        sample.id = fluid.tags()[i].id;
        sample.volume = fluid.data(Field::volume)[i];
        sample.pressure = fluid.data(Field::pressure)[i];
        sample.viscosity = fluid.data(Field::viscosity)[i];
        own.push_back(sample);
    }
    samples_ = ranks.gather_to_first(own);
    std::ranges::sort(samples_, {}, &Sample::id);
}

std::vector<std::vector<Vec>> SurfaceTraction::on(const SpringBodies& springs) const {
    std::vector<Vec> places;
    for (const Sample& sample : samples_) places.emplace_back(sample.position.data());
    const double reach = fluid_reach * space_.spacing;
    const PointGrid grid(space_, reach, std::move(places));
    std::vector<std::vector<Vec>> tractions;
    for (const auto& body : springs.bodies()) {
        const std::vector<Vec> normals = surface_normals(*body, space_);
        auto& of_body = tractions.emplace_back(body->nodes(), Vec::Zero());
        for (std::size_t node = 0; node < body->nodes(); ++node) {
            const Vec& normal = normals[node];
            if (normal.isZero(0) || body->of_wall(node)) continue;
            std::vector<Near> near;
            const Vec half = space_.spacing / 2 * normal;
            grid.for_each_near(body->position(node) + half, [&](std::size_t k, const Vec& x) {
                if ((x + half).dot(normal) <= 0) return;
                near.push_back({&samples_[k], x, samples_[k].volume * std::pow(1 - x.norm() / reach, 2)});
            });
            if (!near.empty()) of_body[node] = traction(near, normal);
        }
    }
    return tractions;
}

Vec SurfaceTraction::traction(const std::vector<Near>& near, const Vec& normal) const {
    LinearFit fit;
    for (const auto& [sample, x, weight] : near) fit.add(x, weight);
    fit.finish(Ranks::alone(), space_.spacing);
    double pressure = 0, viscosity = 0, weights = 0;
    for (const auto& [sample, x, weight] : near) {
        pressure += fit.share(x, weight) * sample->pressure;
        viscosity += weight * sample->viscosity;
        weights += weight;
    }
    viscosity /= weights;
    const Eigen::Matrix3d gradient = velocity_gradient(near, normal);
    return viscosity * (gradient + gradient.transpose()) * normal - pressure * normal;
}

Eigen::Matrix3d SurfaceTraction::velocity_gradient(const std::vector<Near>& near, const Vec& normal) const {
    // In reaches: v = a + c s + b_1 t_1 (+ b_2 t_2) + d s^2, s along the normal and t across it.
    const double reach = fluid_reach * space_.spacing;
    const auto [first, second] = across(normal, space_.dimension);
    const auto rows = static_cast<Eigen::Index>(near.size());
    const Eigen::Index last = space_.dimension + 1;
    Eigen::MatrixXd basis(rows, last + 1), velocity(rows, 3);
    for (Eigen::Index row = 0; row < rows; ++row) {
        const auto& [sample, x, weight] = near[static_cast<std::size_t>(row)];
        const double s = x.dot(normal) / reach, root = std::sqrt(weight / near.front().weight);
        basis(row, 0) = root;
        basis(row, 1) = root * s;
        basis(row, 2) = root * x.dot(first) / reach;
        if (space_.dimension == 3) basis(row, 3) = root * x.dot(second) / reach;
        basis(row, last) = root * s * s;
        velocity.row(row) = root * Eigen::Map<const Eigen::RowVector3d>(sample->velocity.data());
    }
    constexpr double undetermined = 0.01;  // of the largest pivot; s^2 of two rows of fluid is below it
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(undetermined);
    solver.compute(basis);
    if (solver.rank() <= last) solver.compute(basis.leftCols(last));
    const Eigen::MatrixXd fitted = solver.solve(velocity) / reach;
    const double no_slip = -0.5 / fluid_reach;  // s at the particle
    const Eigen::RowVector3d curved =
        solver.cols() > last ? Eigen::RowVector3d(2 * no_slip * fitted.row(last)) : Eigen::RowVector3d::Zero();
    Eigen::Matrix3d gradient = (fitted.row(1) + curved).transpose() * normal.transpose();
    gradient += fitted.row(2).transpose() * first.transpose();
    if (space_.dimension == 3) gradient += fitted.row(3).transpose() * second.transpose();
    return gradient;
}

}  // namespace dmp::solver
