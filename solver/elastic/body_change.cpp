// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic/body_change.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>
#include <stdexcept>
#include <unordered_map>

#include "base/disjoint_sets.hpp"
#include "models/springs/spring.hpp"
#include "solver/elastic/cut_cells.hpp"

namespace dmp::solver {

namespace {

using Ends = std::pair<int, int>;
Ends in_order(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// All bodies as one list of nodes and springs, with their connections.
class Graph {
  public:
    Graph(const std::vector<BodyParts>& bodies, const ParticleSpace& space) : space_(space) {
        for (const BodyParts& body : bodies) append(body);
        for (const auto& bond : all_.bonds) bonded_.insert(in_order(bond.node[0], bond.node[1]));
    }

    void add(const BodyParts::Node& node) {
        BodyParts alone;
        alone.nodes.push_back(node);
        append(alone);
    }

    /// Returns true if the bond was made.
    bool bond(const BodyChange::Bond& bond) {
        const int a = number_.at(bond.a), b = number_.at(bond.b);
        if (bonded_.contains(in_order(a, b)) || !bring_together(a, b)) return false;
        const double distance = (all_.nodes[a].position - all_.nodes[b].position).norm();
        const Spring spring(bond.stiffness, bond.damping, reduced_mass(all_.nodes[a].mass, all_.nodes[b].mass));
        all_.bonds.push_back({{a, b},
                              bond.rest_length > 0 ? bond.rest_length : distance,
                              spring.stiffness,
                              spring.dashpot,
                              bond.origin});
        bonded_.insert(in_order(a, b));
        held_apart_.insert(in_order(a, b));
        return true;
    }

    /// Returns the origin of the bond, or -1 if there is none.
    int cut(const std::array<int, 2>& ids) {
        if (!number_.contains(ids[0]) || !number_.contains(ids[1])) return -1;  // of a solid of cells
        const Ends ends = in_order(number_.at(ids[0]), number_.at(ids[1]));
        auto& [nodes, bonds, hinges, dihedrals, cells, faces, held_apart] = all_;  // all: one more does not compile
        const auto found =
            std::ranges::find_if(bonds, [&](const auto& bond) { return in_order(bond.node[0], bond.node[1]) == ends; });
        if (found == bonds.end()) return -1;
        const int origin = found->origin;
        bonds.erase(found);
        std::erase_if(hinges, [&](const auto& hinge) {
            return in_order(hinge.node[0], hinge.node[1]) == ends || in_order(hinge.node[2], hinge.node[1]) == ends;
        });
        // a, b, c and b, c, d are triangles; a-d is not a side of either.
        std::erase_if(dihedrals, [&](const auto& dihedral) {
            for (int i = 0; i < 4; ++i)
                for (int j = 0; j < i; ++j)
                    if (i - j < 3 && in_order(dihedral.node[i], dihedral.node[j]) == ends) return true;
            return false;
        });
        held_apart_.erase(ends);
        return origin;
    }

    [[nodiscard]] std::vector<BodyParts> pieces() {
        const std::size_t count = all_.nodes.size();
        DisjointSets together(count);
        const auto join = [&](const auto& springs) {
            for (const auto& spring : springs)
                for (const int node : spring.node) together.join(node, spring.node[0]);
        };
        const auto& [nodes, bonds, hinges, dihedrals, cells, faces, held_apart] = all_;
        join(bonds);
        join(hinges);
        join(dihedrals);

        std::vector<int> by_id(count);
        std::iota(by_id.begin(), by_id.end(), 0);
        std::ranges::sort(by_id, {}, [&](int node) { return all_.nodes[node].id; });
        std::unordered_map<std::size_t, std::size_t> piece_of_root;
        std::vector<BodyParts> pieces;
        std::vector<std::pair<std::size_t, int>> position_of(count);  // piece, and number in it
        for (const int node : by_id) {
            const auto [known, is_new] = piece_of_root.try_emplace(together.find(node), pieces.size());
            if (is_new) pieces.emplace_back();
            BodyParts& piece = pieces[known->second];
            position_of[node] = {known->second, static_cast<int>(piece.nodes.size())};
            piece.nodes.push_back(all_.nodes[node]);
        }
        const auto hand_out = [&](const auto& springs, auto BodyParts::*member) {
            for (auto spring : springs) {
                auto& piece = pieces[position_of[spring.node[0]].first];
                for (int& node : spring.node) node = position_of[node].second;
                (piece.*member).push_back(spring);
            }
        };
        hand_out(bonds, &BodyParts::bonds);
        hand_out(hinges, &BodyParts::hinges);
        hand_out(dihedrals, &BodyParts::dihedrals);
        for (const auto& [a, b] : held_apart_)
            if (position_of[a].first == position_of[b].first)
                pieces[position_of[a].first].held_apart.push_back(
                    in_order(position_of[a].second, position_of[b].second));
        for (BodyParts& piece : pieces) std::ranges::sort(piece.held_apart);
        // A wall particle without bonds belongs to the wall alone.
        std::erase_if(pieces, [](const BodyParts& piece) {
            return std::ranges::all_of(piece.nodes, [](const auto& node) { return node.of_wall; });
        });
        return pieces;
    }

  private:
    void append(const BodyParts& body) {
        if (!body.cells.empty()) throw std::logic_error("bodies of cells are not joined");
        const int first = static_cast<int>(all_.nodes.size());
        const int own = static_cast<int>(members_.size());
        members_.emplace_back();
        for (const BodyParts::Node& node : body.nodes) {
            const int number = static_cast<int>(all_.nodes.size());
            number_[node.id] = number;
            all_.nodes.push_back(node);
            body_of_.push_back(own);
            members_.back().push_back(number);
        }
        const auto add = [first](auto& to, const auto& springs) {
            for (auto spring : springs) {
                for (int& node : spring.node) node += first;
                to.push_back(spring);
            }
        };
        const auto& [nodes, bonds, hinges, dihedrals, cells, faces, held_apart] = body;
        add(all_.bonds, bonds);
        add(all_.hinges, hinges);
        add(all_.dihedrals, dihedrals);
        for (const auto& [a, b] : held_apart) held_apart_.emplace(a + first, b + first);
    }

    /// Joins the bodies of two nodes, in the images in which the nodes are nearest. Returns false if the nodes are
    /// already in one body, but in other images.
    bool bring_together(int a, int b) {
        const Vec apart = all_.nodes[b].position - all_.nodes[a].position, nearest = nearest_image(apart, space_);
        Vec shift = Vec::Zero();
        for (int axis = 0; axis < space_.dimension; ++axis) {
            if (!space_.periodic[axis]) continue;
            const double period = space_.box.high[axis] - space_.box.low[axis];
            shift[axis] = period * std::round((nearest[axis] - apart[axis]) / period);
        }
        if (body_of_[a] == body_of_[b]) return shift.cwiseAbs().maxCoeff() == 0;
        std::vector<int>&of_a = members_[body_of_[a]], &of_b = members_[body_of_[b]];
        const bool moves_a = of_a.size() < of_b.size();
        for (const int node : moves_a ? of_a : of_b) {
            const Vec way = moves_a ? Vec(-shift) : shift;
            for (Vec BodyParts::Node::*position :
                 {&BodyParts::Node::position, &BodyParts::Node::position_before, &BodyParts::Node::rest_position})
                all_.nodes[node].*position += way;
        }
        std::vector<int> joined = std::move(of_b);
        of_b.clear();
        for (const int node : joined) body_of_[node] = body_of_[a];
        of_a.insert(of_a.end(), joined.begin(), joined.end());
        return true;
    }

    const ParticleSpace& space_;
    BodyParts all_;
    std::unordered_map<int, int> number_;    ///< by id
    std::vector<int> body_of_;               ///< by node
    std::vector<std::vector<int>> members_;  ///< by body
    std::set<Ends> bonded_, held_apart_;
};

}  // namespace

ChangedBodies change_bodies(const std::vector<BodyParts>& bodies, const BodyChange& change,
                            const ParticleSpace& space) {
    std::vector<BodyParts> of_springs;
    ChangedBodies changed;
    std::vector<BodyParts> pieces;
    for (const BodyParts& body : bodies) {
        if (body.cells.empty()) {
            of_springs.push_back(body);
            continue;
        }
        CutSolid cut = cut_faces(body, change.broken, space.dimension);
        std::ranges::move(cut.pieces, std::back_inserter(pieces));
        changed.broken.insert(changed.broken.end(), cut.broken.begin(), cut.broken.end());
    }
    Graph graph(of_springs, space);
    for (const BodyParts::Node& node : change.nodes) graph.add(node);
    for (const BodyChange::Bond& bond : change.bonds)
        if (graph.bond(bond)) changed.made.push_back(bond.origin);
    for (const auto& ends : change.broken)
        if (const int origin = graph.cut(ends); origin >= 0) changed.broken.push_back(origin);
    changed.bodies = graph.pieces();
    std::ranges::move(pieces, std::back_inserter(changed.bodies));
    return changed;
}

}  // namespace dmp::solver
