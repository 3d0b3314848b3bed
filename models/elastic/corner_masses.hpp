// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "models/uses.hpp"

namespace dmp::models {

/// What a cell of a solid (ElasticCell) has of its mass.
struct CellMass {
    std::array<int, 8> node{};   ///< at its corners
    Vec size = Vec::Zero();      ///< of its box [m]
    Vec centroid = Vec::Zero();  ///< of the solid in it, from the middle of the box, along its axes [m]
    Vec moment = Vec::Zero();    ///< mean of (X_i - centroid_i)^2 in the solid, by axis [m^2]
    double mass = 0;             ///< [kg]
};

/// What shape functions at the centroids give the nodes of the cells' masses, m_k = SUM N_k m_p; their number: `nodes`.
std::vector<double> shares_at_corners(int dimension, std::span<const CellMass> cells, std::size_t nodes);

/// Masses of the nodes of a solid of cells.
struct CornerMasses {
    std::vector<double> mass;      ///< by node [kg]
    std::vector<double> by_shape;  ///< shares_at_corners [kg]
    /// Moment of inertia of `mass` over the solid's, about the axis of the lattice through its centroid about which it
    /// is largest, in 2-D across the plane; 1 where the solid goes on through a periodic side.
    double inertia = 1;
};

/// The least that a node keeps of its mass by shape functions [-].
constexpr double least_kept_mass = 0.25;

/// By shape functions a cell gives its corners its mass and centroid, but a second moment of (a_i / 2)^2 - c_i^2 along
/// axis i in place of the solid's S_i: a block of n cells across has 1 + 2/n^2 of its second moment, and turns as one
/// with so much more inertia. So these masses are changed to
///
///   m'_k = m_k exp(a + b . x_k + x_k . C x_k)
///
/// with a, b and C such that mass, centroid and the second moments about the axes are the solid's: of all masses with
/// these moments those with the least relative entropy SUM m' ln(m'/m) (Kullback 1959), which are positive. Of a block
/// they are the products of the weights of its axes: with two and three cells across those of Simpson's rules.
/// What cannot be had, as of a solid one cell across, or only with less than least_kept_mass at a node, is left.
/// Products of inertia are those of the shape functions. `cells`: of one solid; `nodes`: their places at rest [m].
CornerMasses corner_masses(int dimension, std::span<const CellMass> cells, std::span<const Vec> nodes);

}  // namespace dmp::models
