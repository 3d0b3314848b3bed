// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "models/elastic/elastic_cell.hpp"
#include "models/elastic/elastic_laws.hpp"
#include "solver/elastic/body_parts.hpp"

namespace dmp::solver {

/// A cell of a solid between nodes of one body.
template <int D>
struct LocalCell {
    using Element = ElasticCell<D>;
    using Corners = typename Element::Corners;
    using Point = Vector<double, D>;
    using Vectors = std::vector<Point>;

    /// A cell pressed to this share of its volume has no place to go: its equations are no longer those of a solid [-].
    static constexpr double least_volume = 0.1;

    explicit LocalCell(const BodyParts::Cell& parts)
        : element(parts.size.head<D>(), parts.centroid.head<D>(), parts.volume, parts.moment.head<D>(),
                  parts.youngs_modulus, parts.poisson_ratio),
          law(parts.law),
          relaxation(parts.relaxation) {
        for (std::size_t k = 0; k < node.size(); ++k) {
            node[k] = parts.node[k];
            shift.col(static_cast<int>(k)) = parts.shift[k].head<D>();
        }
    }

    std::array<int, Element::corners> node{};
    Corners shift;  ///< of each corner from its node: whole periods [m]
    Element element;
    ElasticLaw law;
    double relaxation;  ///< of its damping [s]

    /// Positions of its corners, from those of the nodes.
    [[nodiscard]] Corners at(const Vectors& position) const { return of(position) + shift; }
    /// Values of its corners, such as velocities.
    [[nodiscard]] Corners of(const Vectors& values) const {
        Corners corners;
        for (int k = 0; k < Element::corners; ++k)
            for (int axis = 0; axis < D; ++axis) corners(axis, k) = values[node[k]][axis];
        return corners;
    }
    /// Where its centroid is.
    [[nodiscard]] Point centroid(const Vectors& position) const {
        const typename Element::Point centroid = at(position) * element.share;
        Point point;
        for (int axis = 0; axis < D; ++axis) point[axis] = centroid[axis];
        return point;
    }
    /// Volume over that at rest.
    [[nodiscard]] double volume_ratio(const Vectors& position) const {
        return element.gradient(at(position)).determinant();
    }

    [[nodiscard]] Corners forces(const Corners& x, const Corners& v) const {
        return with_law([&](const auto& of_solid) { return element.forces(of_solid, relaxation, x, v); });
    }
    [[nodiscard]] double energy(const Corners& x) const {
        return with_law([&](const auto& of_solid) { return element.energy(of_solid, x); });
    }
    [[nodiscard]] Matrix<3> stress(const Corners& x) const {
        return with_law([&](const auto& of_solid) { return element.stress(of_solid, x); });
    }
    [[nodiscard]] std::array<Matrix<3>, Element::corners> surface_stresses(const Corners& x) const {
        return with_law([&](const auto& of_solid) { return element.surface_stresses(of_solid, x); });
    }
    [[nodiscard]] typename Element::Square stiffness(const Corners& x, double elastic, double viscous) const {
        return with_law([&](const auto& of_solid) { return element.stiffness(of_solid, x, elastic, viscous); });
    }

  private:
    template <class Use>
    [[nodiscard]] auto with_law(const Use& use) const {
        return with_elastic_law(law, element.constants(), use);
    }
};

}  // namespace dmp::solver
