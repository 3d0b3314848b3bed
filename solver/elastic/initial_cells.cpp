// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "models/elastic/corner_masses.hpp"
#include "models/elastic/elastic_cell.hpp"
#include "solver/elastic/body_parts.hpp"
#include "solver/elastic/cut_cells.hpp"
#include "solver/elastic/self_contact.hpp"

namespace dmp::solver {

namespace {

/// Gives the nodes of one solid their masses, and as much of its cells' drag.
void share_masses(BodyParts& parts, int dimension, bool may_tear) {
    std::vector<CellMass> cells;
    for (const BodyParts::Cell& cell : parts.cells)
        cells.push_back({cell.node, cell.size, cell.centroid, cell.moment, cell.mass});
    std::vector<Vec> places;
    for (const BodyParts::Node& node : parts.nodes) places.push_back(node.rest_position);
    const CornerMasses masses = corner_masses(dimension, cells, places);
    // What is clamped does not turn as a whole, and keeps its weight where its cells are.
    const bool as_cells = may_tear || std::ranges::any_of(parts.nodes, &BodyParts::Node::fixed);
    for (std::size_t c = 0; c < cells.size(); ++c) cells[c].mass = parts.cells[c].drag;
    const std::vector<double> drag = shares_at_corners(dimension, cells, places.size());
    for (std::size_t n = 0; n < parts.nodes.size(); ++n) {
        BodyParts::Node& node = parts.nodes[n];
        node.mass = as_cells ? masses.by_shape[n] : masses.mass[n];
        node.drag = drag[n] * node.mass / masses.by_shape[n];
    }
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
    bool may_tear = false;
    for (const SolidCell& from : set.cells) {
        if (set.body[from.particle] != body) continue;
        const auto particle = static_cast<std::size_t>(from.particle);
        const InitialSprings::Source& source = drawn.of_part[set.part[particle]];
        const int corners = 1 << set.dimension;
        may_tear = may_tear || source.may_tear;
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
        }
        parts.cells.push_back(cell);
        positions.push_back(set.position[particle]);
    }
    share_masses(parts, set.dimension, may_tear);
    parts.faces = faces_between(parts.cells, 1 << set.dimension);
    if (contact_range > 0)
        parts.held_apart = pairs_within(positions, set.dimension,
                                        neighbourhood_of_contact(contact_range, std::sqrt(2.0) * set.spacing));
    return parts;
}

}  // namespace dmp::solver
