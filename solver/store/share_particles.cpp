// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/store/share_particles.hpp"

namespace dmp::solver {

namespace {

struct SmallFacts {
    int dimension;
    double spacing;
    std::array<double, 3> low, high;
    std::array<bool, 3> periodic;
    std::array<std::array<bool, 2>, 3> mirrored;
};

std::array<double, 3> three(const Vec& v) { return {v[0], v[1], v[2]}; }
Vec vec(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

void share(std::vector<Vec>& vectors, const Ranks& ranks) {
    std::vector<std::array<double, 3>> plain;
    plain.reserve(vectors.size());
    for (const Vec& v : vectors) plain.push_back(three(v));
    ranks.broadcast(plain);
    vectors.clear();
    for (const auto& v : plain) vectors.push_back(vec(v));
}

void share_walls(ParticleSpace& space, const Ranks& ranks) {
    std::vector<int> of_part;
    std::vector<Vec> points, normals;
    for (const WallPlane& plane : space.wall_planes) {
        of_part.push_back(plane.part);
        points.push_back(plane.point);
        normals.push_back(plane.normal);
    }
    ranks.broadcast(of_part);
    share(points, ranks);
    share(normals, ranks);
    space.wall_planes.clear();
    for (std::size_t n = 0; n < of_part.size(); ++n) space.wall_planes.push_back({of_part[n], points[n], normals[n]});
    share(space.wall_corners, ranks);
    ranks.broadcast(space.wall_triangles);
    share(space.contact_points, ranks);
    ranks.broadcast(space.contact_pieces);
}

void share_space(ParticleSpace& space, const Ranks& ranks) {
    std::vector<SmallFacts> facts{
        {space.dimension, space.spacing, three(space.box.low), three(space.box.high), space.periodic, space.mirrored}};
    ranks.broadcast(facts);
    space.dimension = facts[0].dimension;
    space.spacing = facts[0].spacing;
    space.box = {vec(facts[0].low), vec(facts[0].high)};
    space.periodic = facts[0].periodic;
    space.mirrored = facts[0].mirrored;

    std::vector<PartKind> kinds;
    for (const auto& part : space.parts) kinds.push_back(part.kind);
    ranks.broadcast(kinds);
    space.parts.resize(kinds.size());
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        space.parts[k].kind = kinds[k];
        ranks.broadcast(space.parts[k].name);
    }
    share_walls(space, ranks);
}

void share_cells(ParticleSet& set, const Ranks& ranks) {
    struct PlainNode {
        std::array<double, 3> position;
        bool fixed;
        std::array<bool, 3> on_plane;
    };
    std::vector<PlainNode> nodes;
    for (const CellNode& node : set.cell_nodes) nodes.push_back({three(node.position), node.fixed, node.on_plane});
    ranks.broadcast(nodes);
    set.cell_nodes.clear();
    for (const PlainNode& node : nodes) set.cell_nodes.push_back({vec(node.position), node.fixed, node.on_plane});

    struct Plain {
        int particle;
        std::array<int, 8> node;
        std::array<double, 3> size, centroid, moment;
        int periods;
    };
    std::vector<Plain> cells;
    for (const SolidCell& cell : set.cells)
        cells.push_back(
            {cell.particle, cell.node, three(cell.size), three(cell.centroid), three(cell.moment), cell.periods});
    ranks.broadcast(cells);
    set.cells.clear();
    for (const Plain& cell : cells)
        set.cells.push_back(
            {cell.particle, cell.node, vec(cell.size), vec(cell.centroid), vec(cell.moment), cell.periods});
}

}  // namespace

void share_particles(ParticleSet& particles, const Ranks& ranks) {
    if (ranks.size() == 1) return;
    share_space(particles, ranks);
    share(particles.position, ranks);
    share(particles.wall_normal, ranks);
    ranks.broadcast(particles.volume);
    ranks.broadcast(particles.mass);
    ranks.broadcast(particles.part);
    ranks.broadcast(particles.body);
    ranks.broadcast(particles.fixed);
    ranks.broadcast(particles.seated);
    ranks.broadcast(particles.wall_distance);
    ranks.broadcast(particles.opposite_distance);
    ranks.broadcast(particles.radius);
    share(particles.velocity, ranks);
    share(particles.angular_velocity, ranks);
    ranks.broadcast(particles.bonds);
    ranks.broadcast(particles.hinges);
    ranks.broadcast(particles.dihedrals);
    share_cells(particles, ranks);
}

}  // namespace dmp::solver
