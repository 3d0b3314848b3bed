// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "models/elastic/elastic_cell.hpp"
#include "solver/elastic/body_parts.hpp"
#include "solver/elastic/cut_cells.hpp"
#include "solver/elastic/self_contact.hpp"

namespace dmp::solver {

namespace {

template <int D>
Eigen::VectorXd shares_of(const SolidCell& cell) {
    return ElasticCell<D>(cell.size.head<D>(), cell.centroid.head<D>(), 1, cell.moment.head<D>(), 1, 0).share;
}

/// Of Kelvin and Voigt's damping that is this fraction of critical at the highest frequency of the lattice, 2 c / a
/// [s].
double relaxation_of(double damping, double size, double density, const InitialSprings::Source& material) {
    const LameConstants constants = LameConstants::of(material.youngs_modulus, material.poisson_ratio);
    return damping * size * std::sqrt(density / (constants.lambda + 2 * constants.mu));
}

}  // namespace

std::vector<bool> bodies_of_cells(const ParticleSet& set) {
    std::vector<bool> of_cells;
    for (const int body : set.body)
        if (body >= static_cast<int>(of_cells.size())) of_cells.resize(static_cast<std::size_t>(body) + 1, false);
    for (const SolidCell& cell : set.cells) of_cells[static_cast<std::size_t>(set.body[cell.particle])] = true;
    return of_cells;
}

BodyParts initial_cells(const ParticleSet& set, const InitialSprings& drawn, int body, double contact_range) {
    BodyParts parts;
    std::unordered_map<int, int> local;  // by number of the node in the set
    std::vector<Vec> positions;
    for (const SolidCell& from : set.cells) {
        if (set.body[from.particle] != body) continue;
        const auto particle = static_cast<std::size_t>(from.particle);
        const InitialSprings::Source& source = drawn.of_part[set.part[particle]];
        const int corners = 1 << set.dimension;
        const Eigen::VectorXd share = set.dimension == 3 ? shares_of<3>(from) : shares_of<2>(from);
        BodyParts::Cell cell;
        cell.id = from.particle;
        cell.size = from.size;
        cell.centroid = from.centroid;
        cell.moment = from.moment;
        cell.volume = set.volume[particle];
        cell.mass = set.mass[particle];
        cell.law = source.law;
        cell.youngs_modulus = source.youngs_modulus;
        cell.poisson_ratio = source.poisson_ratio;
        cell.relaxation = source.relaxation > 0
                              ? source.relaxation
                              : relaxation_of(source.damping, from.size.head(set.dimension).minCoeff(),
                                              cell.mass / cell.volume, source);
        cell.drag = source.drag_of(cell.mass);
        cell.origin = source.origin;
        cell.surface = set.surface(particle);
        for (int k = 0; k < corners; ++k) {
            const int number = from.node[static_cast<std::size_t>(k)];
            const auto [known, is_new] = local.try_emplace(number, static_cast<int>(parts.nodes.size()));
            if (is_new) {
                BodyParts::Node node;
                node.id = -1;
                node.fixed = set.cell_nodes[number].fixed;
                node.on_plane = set.cell_nodes[number].on_plane;
                node.origin = source.origin;
                node.position = node.position_before = node.rest_position = set.cell_nodes[number].position;
                if (!node.fixed) node.velocity = source.velocity_at(node.position, set.dimension);
                for (int axis = 0; axis < 3; ++axis)
                    if (node.on_plane[static_cast<std::size_t>(axis)]) node.velocity[axis] = 0;
                parts.nodes.push_back(node);
            }
            cell.node[static_cast<std::size_t>(k)] = known->second;
            cell.shift[static_cast<std::size_t>(k)] = from.shift(k, set.box);
            BodyParts::Node& node = parts.nodes[static_cast<std::size_t>(known->second)];
            node.mass += share[k] * cell.mass;
            node.drag += share[k] * cell.drag;
        }
        parts.cells.push_back(cell);
        positions.push_back(set.position[particle]);
    }
    parts.faces = faces_between(parts.cells, 1 << set.dimension);
    if (contact_range > 0)
        parts.held_apart = pairs_within(positions, set.dimension,
                                        neighbourhood_of_contact(contact_range, std::sqrt(2.0) * set.spacing));
    return parts;
}

}  // namespace dmp::solver
