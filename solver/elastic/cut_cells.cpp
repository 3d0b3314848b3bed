// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic/cut_cells.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "base/disjoint_sets.hpp"
#include "models/elastic/elastic_cell.hpp"

namespace dmp::solver {

namespace {

/// The corners of a cell's face across an axis, on its high or its low side.
std::vector<std::size_t> corners_of_face(int axis, bool high, int corners) {
    std::vector<std::size_t> of_face;
    for (int k = 0; k < corners; ++k)
        if ((k >> axis & 1) == (high ? 1 : 0)) of_face.push_back(static_cast<std::size_t>(k));
    return of_face;
}

std::array<int, 4> nodes_of_face(const BodyParts::Cell& cell, int axis, bool high, int corners) {
    std::array<int, 4> nodes{-1, -1, -1, -1};
    std::size_t next = 0;
    for (const std::size_t k : corners_of_face(axis, high, corners)) nodes.at(next++) = cell.node[k];
    return nodes;
}

/// Cells around each node, with the corner that it is of them.
struct Corner {
    int cell;
    std::size_t corner;
};
std::vector<std::vector<Corner>> around_nodes(const BodyParts& body, int corners) {
    std::vector<std::vector<Corner>> around(body.nodes.size());
    for (std::size_t c = 0; c < body.cells.size(); ++c)
        for (std::size_t k = 0; k < static_cast<std::size_t>(corners); ++k)
            around[static_cast<std::size_t>(body.cells[c].node[k])].push_back({static_cast<int>(c), k});
    return around;
}

/// What a node has of a cell's mass and drag.
double share_of(const BodyParts::Cell& cell, std::size_t corner, int dimension) {
    const auto share = [&]<int D>() {
        return ElasticCell<D>(cell.size.head<D>(), cell.centroid.head<D>(), 1, cell.moment.head<D>(), 1, 0)
            .share[static_cast<int>(corner)];
    };
    return dimension == 3 ? share.operator()<3>() : share.operator()<2>();
}

/// Gives those around a node that do not hang together there nodes of their own.
void split(BodyParts& body, int node, const std::vector<Corner>& around, int dimension) {
    std::unordered_map<int, std::size_t> number;
    for (const Corner& corner : around) number.try_emplace(corner.cell, number.size());
    DisjointSets together(number.size());
    const int corners = 1 << dimension;
    for (const BodyParts::Face& face : body.faces) {
        const auto low = number.find(face.cell[0]), high = number.find(face.cell[1]);
        if (low == number.end() || high == number.end()) continue;
        const auto nodes = nodes_of_face(body.cells[static_cast<std::size_t>(face.cell[0])], face.axis, true, corners);
        if (std::ranges::find(nodes, node) != nodes.end()) together.join(low->second, high->second);
    }
    std::map<std::size_t, int> node_of_group;  // the first group keeps it
    const BodyParts::Node before = body.nodes[static_cast<std::size_t>(node)];
    double all_mass = 0, all_drag = 0;
    for (const Corner& corner : around) {
        const BodyParts::Cell& cell = body.cells[static_cast<std::size_t>(corner.cell)];
        all_mass += share_of(cell, corner.corner, dimension) * cell.mass;
        all_drag += share_of(cell, corner.corner, dimension) * cell.drag;
    }
    for (const Corner& corner : around) {
        const std::size_t group = together.find(number.at(corner.cell));
        const auto [known, is_new] =
            node_of_group.try_emplace(group, node_of_group.empty() ? node : static_cast<int>(body.nodes.size()));
        if (is_new) {
            if (known->second != node) body.nodes.push_back(before);
            auto& own = body.nodes[static_cast<std::size_t>(known->second)];
            own.mass = own.drag = 0;
        }
        BodyParts::Cell& cell = body.cells[static_cast<std::size_t>(corner.cell)];
        const double share = share_of(cell, corner.corner, dimension);
        auto& own = body.nodes[static_cast<std::size_t>(known->second)];
        own.mass += before.mass * (share * cell.mass / all_mass);
        if (all_drag > 0) own.drag += before.drag * (share * cell.drag / all_drag);
        cell.node[corner.corner] = known->second;
    }
    if (node_of_group.size() > 1) return;
    body.nodes[static_cast<std::size_t>(node)] = before;  // to the bit
}

std::vector<BodyParts> pieces_of(const BodyParts& body, int corners) {
    DisjointSets together(body.cells.size());
    for (const BodyParts::Face& face : body.faces)
        together.join(static_cast<std::size_t>(face.cell[0]), static_cast<std::size_t>(face.cell[1]));
    std::vector<BodyParts> pieces;
    std::unordered_map<std::size_t, std::size_t> piece_of_root;
    std::vector<std::pair<std::size_t, int>> cell_in(body.cells.size());
    std::vector<std::unordered_map<int, int>> node_in;
    for (std::size_t c = 0; c < body.cells.size(); ++c) {
        const auto [known, is_new] = piece_of_root.try_emplace(together.find(c), pieces.size());
        if (is_new) {
            pieces.emplace_back();
            node_in.emplace_back();
        }
        BodyParts& piece = pieces[known->second];
        cell_in[c] = {known->second, static_cast<int>(piece.cells.size())};
        BodyParts::Cell cell = body.cells[c];
        for (std::size_t k = 0; k < static_cast<std::size_t>(corners); ++k) {
            const auto [number, first] =
                node_in[known->second].try_emplace(cell.node[k], static_cast<int>(piece.nodes.size()));
            if (first) piece.nodes.push_back(body.nodes[static_cast<std::size_t>(cell.node[k])]);
            cell.node[k] = number->second;
        }
        piece.cells.push_back(cell);
    }
    for (BodyParts::Face face : body.faces) {
        BodyParts& piece = pieces[cell_in[static_cast<std::size_t>(face.cell[0])].first];
        for (int& cell : face.cell) cell = cell_in[static_cast<std::size_t>(cell)].second;
        piece.faces.push_back(face);
    }
    for (const auto& [a, b] : body.held_apart) {
        const auto [piece, first] = cell_in[static_cast<std::size_t>(a)];
        const auto [other, second] = cell_in[static_cast<std::size_t>(b)];
        if (piece == other) pieces[piece].held_apart.emplace_back(std::minmax(first, second));
    }
    for (BodyParts& piece : pieces) std::ranges::sort(piece.held_apart);
    return pieces;
}

}  // namespace

std::vector<BodyParts::Face> faces_between(std::span<const BodyParts::Cell> cells, int corners) {
    const int axes = corners == 8 ? 3 : 2;
    std::vector<BodyParts::Face> faces;
    for (int axis = 0; axis < axes; ++axis) {
        std::map<std::array<int, 4>, int> above;
        for (std::size_t c = 0; c < cells.size(); ++c)
            above[nodes_of_face(cells[c], axis, false, corners)] = static_cast<int>(c);
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const auto found = above.find(nodes_of_face(cells[c], axis, true, corners));
            if (found != above.end() && found->second != static_cast<int>(c))
                faces.push_back({{static_cast<int>(c), found->second}, axis});
        }
    }
    return faces;
}

CutSolid cut_faces(const BodyParts& body, std::span<const std::array<int, 2>> between, int dimension) {
    const int corners = 1 << dimension;
    CutSolid cut;
    BodyParts whole = body;
    std::vector<int> nodes;  // of the faces that break
    for (const auto& ids : between)
        std::erase_if(whole.faces, [&](const BodyParts::Face& face) {
            const BodyParts::Cell& low = whole.cells[static_cast<std::size_t>(face.cell[0])];
            const BodyParts::Cell& high = whole.cells[static_cast<std::size_t>(face.cell[1])];
            if (std::minmax(low.id, high.id) != std::minmax(ids[0], ids[1])) return false;
            for (const int node : nodes_of_face(low, face.axis, true, corners))
                if (node >= 0) nodes.push_back(node);
            cut.broken.push_back(low.origin);
            std::erase(whole.held_apart, std::pair<int, int>(std::minmax(face.cell[0], face.cell[1])));
            return true;
        });
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const auto around = around_nodes(whole, corners);
    for (const int node : nodes) split(whole, node, around[static_cast<std::size_t>(node)], dimension);
    cut.pieces = pieces_of(whole, corners);
    return cut;
}

}  // namespace dmp::solver
