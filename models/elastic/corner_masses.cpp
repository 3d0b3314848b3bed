// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "models/elastic/corner_masses.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "models/elastic/elastic_cell.hpp"

namespace dmp::models {

namespace {

template <int D>
Eigen::VectorXd shares_of(const CellMass& cell) {
    return ElasticCell<D>(cell.size.head<D>(), cell.centroid.head<D>(), 1, cell.moment.head<D>(), 1, 0).share;
}

/// The axes of the lattice, as far as the solid does not go on along them through a periodic side.
std::vector<std::pair<int, Vec>> open_axes(int dimension, std::span<const CellMass> cells, std::span<const Vec> nodes) {
    std::vector<std::pair<int, Vec>> axes;
    for (int axis = 0; axis < dimension; ++axis) {
        const auto along = [&](const CellMass& cell) -> Vec {
            const auto node = [&](std::size_t corner) { return nodes[static_cast<std::size_t>(cell.node[corner])]; };
            return node(std::size_t{1} << axis) - node(0);
        };
        const Vec step = along(cells.front());
        const double length = cells.front().size[axis];
        const auto is_within = [&](const CellMass& cell) { return (along(cell) - step).norm() < 0.01 * length; };
        if (std::abs(step.norm() - length) < 0.01 * length && std::ranges::all_of(cells, is_within))
            axes.emplace_back(axis, step.normalized());
    }
    return axes;
}

/// Moments of masses at points: of 1, and of the coordinates and their products.
class Moments {
  public:
    /// `places`: by node, its coordinates, with a mean square of 1; all masses together are 1.
    Moments(std::span<const double> mass, const std::vector<Eigen::VectorXd>& places) : mass_(mass) {
        const auto axes = places.front().size();
        for (Eigen::Index i = 0; i < axes; ++i) {
            double variance = 0;
            for (std::size_t k = 0; k < places.size(); ++k)
                variance += mass[k] * std::pow(places[k][i] * places[k][i] - 1, 2);
            has_square_.push_back(variance > 1e-6);
        }
        for (const Eigen::VectorXd& x : places) {
            std::vector<double> of{1};
            of.insert(of.end(), x.begin(), x.end());
            for (Eigen::Index i = 0; i < axes; ++i)
                for (Eigen::Index j = i; j < axes; ++j)
                    if (i != j || has_square_[static_cast<std::size_t>(i)]) of.push_back(x[i] * x[j]);
            of_node_.emplace_back(Eigen::Map<Eigen::VectorXd>(of.data(), static_cast<Eigen::Index>(of.size())));
        }
    }
    /// The number of the moment of the square of a coordinate; none where that is the same at all nodes, as in a solid
    /// one cell across.
    [[nodiscard]] std::optional<Eigen::Index> square(std::size_t axis) const {
        if (!has_square_[axis]) return {};
        const std::size_t axes = has_square_.size();
        std::size_t number = 1 + axes;
        for (std::size_t i = 0; i < axis; ++i) number += axes - i - (has_square_[i] ? 0 : 1);
        return static_cast<Eigen::Index>(number);
    }
    [[nodiscard]] Eigen::VectorXd of(std::span<const double> mass) const {
        Eigen::VectorXd sum = Eigen::VectorXd::Zero(of_node_.front().size());
        for (std::size_t k = 0; k < mass.size(); ++k) sum += mass[k] * of_node_[k];
        return sum;
    }
    /// The masses with these moments and least relative entropy, by Newton's method for the exponents' factors, which
    /// minimise SUM m' - factors . moments; none if there are none, or if one is less than least_kept_mass.
    [[nodiscard]] std::optional<std::vector<double>> with(const Eigen::VectorXd& moments) const {
        constexpr int most_steps = 60, most_halvings = 30;
        constexpr double dependent = 1e-9, converged = 1e-13;
        Eigen::VectorXd factors = Eigen::VectorXd::Zero(moments.size());
        std::vector<double> mass(mass_.begin(), mass_.end());
        double goal = value(mass, factors, moments);
        for (int step = 0; step < most_steps; ++step) {
            Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(moments.size(), moments.size());
            for (std::size_t k = 0; k < mass.size(); ++k) slope += mass[k] * of_node_[k] * of_node_[k].transpose();
            const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(slope);
            const Eigen::VectorXd left = parts.eigenvectors().transpose() * (moments - of(mass));
            Eigen::VectorXd change = Eigen::VectorXd::Zero(moments.size());
            double largest = 0;
            for (Eigen::Index k = 0; k < left.size(); ++k) {
                // Moments that depend on others at these nodes stay as they are.
                if (parts.eigenvalues()[k] < dependent * parts.eigenvalues().tail(1)[0]) continue;
                change += left[k] / parts.eigenvalues()[k] * parts.eigenvectors().col(k);
                largest = std::max(largest, std::abs(left[k]));
            }
            if (largest < converged) return all_kept(mass) ? std::optional(mass) : std::nullopt;
            int halvings = 0;
            for (; halvings < most_halvings; ++halvings, change /= 2) {
                const std::vector<double> next = masses(factors + change);
                const double reached = value(next, factors + change, moments);
                if (!(reached <= goal + converged)) continue;
                factors += change;
                mass = next;
                goal = reached;
                break;
            }
            if (halvings == most_halvings) return {};
        }
        return {};
    }

  private:
    [[nodiscard]] std::vector<double> masses(const Eigen::VectorXd& factors) const {
        std::vector<double> mass;
        mass.reserve(mass_.size());
        for (std::size_t k = 0; k < mass_.size(); ++k) mass.push_back(mass_[k] * std::exp(factors.dot(of_node_[k])));
        return mass;
    }
    [[nodiscard]] static double value(const std::vector<double>& mass, const Eigen::VectorXd& factors,
                                      const Eigen::VectorXd& moments) {
        return std::accumulate(mass.begin(), mass.end(), 0.0) - factors.dot(moments);
    }
    [[nodiscard]] bool all_kept(const std::vector<double>& mass) const {
        for (std::size_t k = 0; k < mass.size(); ++k)
            if (mass[k] < least_kept_mass * mass_[k]) return false;
        return true;
    }

    std::span<const double> mass_;
    std::vector<bool> has_square_;  ///< by axis
    std::vector<Eigen::VectorXd> of_node_;
};

}  // namespace

std::vector<double> shares_at_corners(int dimension, std::span<const CellMass> cells, std::size_t nodes) {
    std::vector<double> sum(nodes, 0);
    for (const CellMass& cell : cells) {
        const Eigen::VectorXd share = dimension == 3 ? shares_of<3>(cell) : shares_of<2>(cell);
        for (int k = 0; k < 1 << dimension; ++k) sum[cell.node[k]] += share[k] * cell.mass;
    }
    return sum;
}

CornerMasses corner_masses(int dimension, std::span<const CellMass> cells, std::span<const Vec> nodes) {
    CornerMasses result;
    result.mass = result.by_shape = shares_at_corners(dimension, cells, nodes.size());
    double total = 0;
    Vec excess = Vec::Zero();  // of the second moments by shape functions [kg m^2]
    for (const CellMass& cell : cells) {
        total += cell.mass;
        excess += cell.mass * Vec((cell.size / 2).cwiseAbs2() - cell.centroid.cwiseAbs2() - cell.moment);
    }
    const auto axes = open_axes(dimension, cells, nodes);
    const auto count = static_cast<Eigen::Index>(axes.size());
    if (axes.empty() || !(total > 0)) return result;

    Vec centroid = Vec::Zero();
    for (std::size_t k = 0; k < nodes.size(); ++k) centroid += result.mass[k] / total * nodes[k];
    const auto along = [&](Eigen::Index n, std::size_t node) {
        return axes[static_cast<std::size_t>(n)].second.dot(nodes[node] - centroid);
    };
    Eigen::VectorXd by_shape = Eigen::VectorXd::Zero(count), too_much(count);  // second moments [m^2]
    for (Eigen::Index n = 0; n < count; ++n) {
        for (std::size_t k = 0; k < nodes.size(); ++k)
            by_shape[n] += result.mass[k] / total * along(n, k) * along(n, k);
        too_much[n] = excess[axes[static_cast<std::size_t>(n)].first] / total;
    }
    std::vector<double> share;
    std::vector<Eigen::VectorXd> places;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        share.push_back(result.mass[k] / total);
        Eigen::VectorXd& place = places.emplace_back(count);
        for (Eigen::Index n = 0; n < count; ++n) place[n] = along(n, k) / std::sqrt(by_shape[n]);
    }
    const Moments moments(share, places);
    const Eigen::VectorXd before = moments.of(share);
    // With this part of what is too much taken away.
    const auto without = [&](double part) {
        Eigen::VectorXd wanted = before;
        for (Eigen::Index n = 0; n < count; ++n)
            if (const auto square = moments.square(static_cast<std::size_t>(n)))
                wanted[*square] -= part * too_much[n] / by_shape[n];
        return moments.with(wanted);
    };
    std::optional<std::vector<double>> found = without(1);
    if (!found) {
        constexpr int halvings = 8;  // to the largest part that can be taken away
        double low = 0, high = 1;
        for (int n = 0; n < halvings; ++n) {
            const double middle = (low + high) / 2;
            auto next = without(middle);
            (next ? low : high) = middle;
            if (next) found = std::move(next);
        }
    }
    if (!found) found = share;
    for (std::size_t k = 0; k < nodes.size(); ++k) result.mass[k] = total * (*found)[k];
    if (count < dimension) return result;
    Eigen::VectorXd second = Eigen::VectorXd::Zero(count);
    for (Eigen::Index n = 0; n < count; ++n)
        for (std::size_t k = 0; k < nodes.size(); ++k) second[n] += (*found)[k] * along(n, k) * along(n, k);
    const Eigen::VectorXd of_solid = by_shape - too_much;
    result.inertia = second.sum() / of_solid.sum();
    for (Eigen::Index n = 0; n < count && dimension == 3; ++n)
        result.inertia =
            std::max(n == 0 ? 0 : result.inertia, (second.sum() - second[n]) / (of_solid.sum() - of_solid[n]));
    return result;
}

}  // namespace dmp::models
