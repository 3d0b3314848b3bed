// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/cells_in_file.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace dmp::particles {

namespace {

static_assert(sizeof(Vec) == 3 * sizeof(double));

std::string problem_with_cell(const ParticleSet& set, const SolidCell& cell, std::vector<bool>& is_cell) {
    if (cell.particle < 0 || static_cast<std::size_t>(cell.particle) >= set.size()) return "its particle is not there";
    const auto particle = static_cast<std::size_t>(cell.particle);
    if (is_cell[particle]) return "its particle is another cell's";
    is_cell[particle] = true;
    if (set.kind(particle) != PartKind::elastic || set.body[particle] < 0) return "its particle is of no elastic solid";
    if (!(set.volume[particle] > 0) || !(set.mass[particle] > 0)) return "its volume or mass is not more than 0";
    for (int axis = 0; axis < set.dimension; ++axis) {
        const double half = 0.5 * cell.size[axis];
        if (!(half > 0) || !std::isfinite(half)) return "its size is not more than 0";
        if (!(std::abs(cell.centroid[axis]) < half)) return "its centroid is outside";
        if (!(cell.moment[axis] >= 0) || !std::isfinite(cell.moment[axis])) return "a moment is less than 0";
    }
    for (int axis = 0; axis < 3; ++axis)
        for (int k = 0; k < 8; ++k)
            if ((cell.periods & SolidCell::period_bit(k, axis)) != 0 &&
                (k >> set.dimension != 0 || axis >= set.dimension || !set.periodic[axis]))
                return "a corner is a period away along an axis that has none";
    const std::span corners = std::span(cell.node).first(std::size_t{1} << set.dimension);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        if (corners[k] < 0 || static_cast<std::size_t>(corners[k]) >= set.cell_nodes.size())
            return "a corner is at a node that is not there";
        if (std::ranges::count(corners, corners[k]) > 1) return "two corners are one node";
    }
    return "";
}

}  // namespace

std::string problem_with_cells(const ParticleSet& set) {
    for (std::size_t n = 0; n < set.cell_nodes.size(); ++n)
        if (!set.cell_nodes[n].position.allFinite()) return "node " + std::to_string(n) + " of cells is not finite";
    if (set.cells.empty()) return "";
    std::vector<bool> is_cell(set.size(), false);
    for (std::size_t n = 0; n < set.cells.size(); ++n)
        if (const std::string problem = problem_with_cell(set, set.cells[n], is_cell); !problem.empty())
            return "cell " + std::to_string(n) + ": " + problem;
    std::vector<bool> of_cells;  // by body
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (!is_cell[i]) continue;
        const auto body = static_cast<std::size_t>(set.body[i]);
        if (body >= of_cells.size()) of_cells.resize(body + 1, false);
        of_cells[body] = true;
    }
    for (std::size_t i = 0; i < set.size(); ++i) {
        const bool in_cells = set.body[i] >= 0 && static_cast<std::size_t>(set.body[i]) < of_cells.size() &&
                              of_cells[static_cast<std::size_t>(set.body[i])];
        if (in_cells && !is_cell[i]) return "particle " + std::to_string(i) + " is in a body of cells, and is none";
    }
    std::vector<int> body_of(set.cell_nodes.size(), -1);
    for (std::size_t n = 0; n < set.cells.size(); ++n)
        for (const int node : std::span(set.cells[n].node).first(std::size_t{1} << set.dimension)) {
            const int body = set.body[static_cast<std::size_t>(set.cells[n].particle)];
            int& first = body_of[static_cast<std::size_t>(node)];
            if (first >= 0 && first != body) return "cell " + std::to_string(n) + ": a node is another body's, too";
            first = body;
        }
    for (std::size_t n = 0; n < set.bonds.size(); ++n)
        for (const int end : {set.bonds[n].a, set.bonds[n].b})
            if (is_cell[static_cast<std::size_t>(end)])
                return "bond " + std::to_string(n) + " ends at a cell, which has no bonds";
    return "";
}

void write_cells(Hdf5Writer& to, const ParticleSet& set) {
    if (set.cells.empty()) return;
    std::vector<double> positions;
    std::vector<std::uint8_t> fixed, on_plane;
    for (const CellNode& node : set.cell_nodes) {
        positions.insert(positions.end(), node.position.begin(), node.position.end());
        fixed.push_back(node.fixed ? 1 : 0);
        for (const bool each : node.on_plane) on_plane.push_back(each ? 1 : 0);
    }
    to.write_array<double>("cell_nodes/position", positions);
    to.write_array<std::uint8_t>("cell_nodes/fixed", fixed);
    to.write_array<std::uint8_t>("cell_nodes/on_plane", on_plane);
    to.set_attribute("cell_nodes/position", "unit", "m");
    std::vector<std::int32_t> particles, nodes, periods;
    std::vector<double> sizes, centroids, moments;
    for (const SolidCell& cell : set.cells) {
        particles.push_back(cell.particle);
        periods.push_back(cell.periods);
        nodes.insert(nodes.end(), cell.node.begin(), cell.node.end());
        sizes.insert(sizes.end(), cell.size.begin(), cell.size.end());
        centroids.insert(centroids.end(), cell.centroid.begin(), cell.centroid.end());
        moments.insert(moments.end(), cell.moment.begin(), cell.moment.end());
    }
    to.write_array<std::int32_t>("cells/particle", particles);
    to.write_array<std::int32_t>("cells/nodes", nodes);
    to.write_array<std::int32_t>("cells/periods", periods);
    to.write_array<double>("cells/size", sizes);
    to.write_array<double>("cells/centroid", centroids);
    to.write_array<double>("cells/moment", moments);
    to.set_attribute("cells/size", "unit", "m");
    to.set_attribute("cells/centroid", "unit", "m");
    to.set_attribute("cells/moment", "unit", "m^2");
}

void read_cells(const Hdf5Reader& from, ParticleSet& set) {
    if (!from.has("cells/particle")) return;
    const auto read = [&]<class T>(const std::string& name, std::size_t items, std::size_t each) {
        std::vector<T> values = from.array<T>(name);
        if (values.size() != items * each)
            from.refuse(name + " has " + std::to_string(values.size()) + " elements, not " +
                        std::to_string(items * each));
        return values;
    };
    const auto fixed = from.array<std::uint8_t>("cell_nodes/fixed");
    const auto position = read.operator()<double>("cell_nodes/position", fixed.size(), 3);
    const auto on_plane = read.operator()<std::uint8_t>("cell_nodes/on_plane", fixed.size(), 3);
    for (const auto* flags : {&fixed, &on_plane})
        if (std::ranges::any_of(*flags, [](int flag) { return flag > 1; }))
            from.refuse("cell_nodes/fixed or cell_nodes/on_plane is not 0 or 1 for each");
    for (std::size_t n = 0; n < fixed.size(); ++n)
        set.cell_nodes.push_back({Vec(position[3 * n], position[3 * n + 1], position[3 * n + 2]),
                                  fixed[n] == 1,
                                  {on_plane[3 * n] == 1, on_plane[3 * n + 1] == 1, on_plane[3 * n + 2] == 1}});
    const auto particles = from.array<std::int32_t>("cells/particle");
    const std::size_t count = particles.size();
    const auto nodes = read.operator()<std::int32_t>("cells/nodes", count, 8);
    const auto periods = read.operator()<std::int32_t>("cells/periods", count, 1);
    const auto sizes = read.operator()<double>("cells/size", count, 3);
    const auto centroids = read.operator()<double>("cells/centroid", count, 3);
    const auto moments = read.operator()<double>("cells/moment", count, 3);
    for (std::size_t n = 0; n < count; ++n) {
        SolidCell cell;
        cell.particle = particles[n];
        cell.periods = periods[n];
        std::copy_n(nodes.begin() + static_cast<std::ptrdiff_t>(8 * n), 8, cell.node.begin());
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t at = 3 * n + static_cast<std::size_t>(axis);
            cell.size[axis] = sizes[at];
            cell.centroid[axis] = centroids[at];
            cell.moment[axis] = moments[at];
        }
        set.cells.push_back(cell);
    }
}

}  // namespace dmp::particles
