// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "models/elastic/elastic_law_list.hpp"
#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/state/archive.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// An elastic body as plain values, with nodes numbered from 0: springs between its nodes, or cells. SpringBody is made
/// from it, and bodies of springs are cut and joined in this form (BodyChange). Positions are never wrapped.
struct BodyParts {
    struct Node {
        int id = 0;            ///< of the particle
        bool fixed = false;    ///< position is held
        bool of_wall = false;  ///< a wall particle to which the body is bonded: fixed, not a particle of the body
        std::array<bool, 3> on_plane{};  ///< by axis: on a plane of symmetry across it, in which it stays
        int origin = 0;                  ///< source: number of an elastic solid or [[solidify]] (body_names)
        double mass = 0;                 ///< [kg]
        double drag = 0;                 ///< lab-frame drag [kg/s]
        Vec position = Vec::Zero(), velocity = Vec::Zero(), position_before = Vec::Zero(), rest_position = Vec::Zero();
        SolidSurface surface{};  ///< where the node is a particle
    };
    template <std::size_t K>
    static std::array<Vec, K> no_shift() {
        std::array<Vec, K> none;
        none.fill(Vec::Zero());
        return none;
    }
    /// A bond, hinge or dihedral; order of the nodes as in Bond, Hinge and Dihedral.
    template <int N>
    struct Spring {
        std::array<int, N> node{};
        double rest = 0;       ///< length [m] or angle [rad]
        double stiffness = 0;  ///< [N/m] or [J]
        double dashpot = 0;    ///< [N s/m] or [J s]
        int origin = 0;        ///< as for a node
        /// By arm of the spring's law (BondForce, HingeForce, DihedralForce): what is added to the vector between its
        /// nodes where the body goes on through a periodic side, whole periods [m].
        std::array<Vec, N - 1> shift = no_shift<N - 1>();
    };

    /// A cell of a solid between nodes that are no particles (Node::id -1); the cell is the particle.
    struct Cell {
        int id = 0;                  ///< of the particle
        std::array<int, 8> node{};   ///< corners, as in SolidCell
        std::array<Vec, 8> shift{};  ///< of each corner from its node: whole periods [m]
        Vec size = Vec::Zero();      ///< [m]
        Vec centroid = Vec::Zero();  ///< from the middle of the cell [m]
        Vec moment = Vec::Zero();    ///< [m^2]
        double volume = 0;           ///< of solid in it [m^3], in 2-D [m^2]
        double mass = 0;             ///< [kg]
        ElasticLaw law;
        double youngs_modulus = 0;  ///< [Pa]
        double poisson_ratio = 0;
        double relaxation = 0;  ///< of its damping: viscous over elastic moduli [s]
        double drag = 0;        ///< lab-frame drag, of which its nodes have their shares [kg/s]
        int origin = 0;         ///< as for a node
        SolidSurface surface{};
    };
    /// What a cell, the first, and the next one along an axis share: the solid between them has not broken.
    struct Face {
        std::array<int, 2> cell{};
        int axis = 0;
    };

    std::vector<Node> nodes;
    std::vector<Spring<2>> bonds;
    std::vector<Spring<3>> hinges;
    std::vector<Spring<4>> dihedrals;
    std::vector<Cell> cells;
    std::vector<Face> faces;
    /// Pairs of particles (nodes, or cells where there are any) whose distance the body controls: contact ignores them.
    /// Sorted, with the lower number first.
    std::vector<std::pair<int, int>> held_apart;
};

/// Possible origins of nodes and bonds, by number: the enabled elastic solids of the scene, its [[solidify]], and its
/// [[join]] of enabled parts.
std::vector<std::string> body_names(const Scene& scene);

/// Properties of the initial springs that the scene defines.
struct InitialSprings {
    struct Source {
        int origin = 0;           ///< as in body_names
        double damping = 0;       ///< dashpots, fraction of critical [-]
        double drag = 0;          ///< lab-frame drag of a node [kg/s]
        double mass_damping = 0;  ///< and of a node's mass [1/s]
        ElasticLaw law{};         ///< of cells
        double youngs_modulus = 0, poisson_ratio = 0;
        double relaxation = 0;  ///< of cells, where it is given in place of `damping` [s]
        Value<std::array<Expression, 3>> initial_velocity{};
        bool may_tear = false;  ///< a [[break]] is about it
        /// Of a node that starts here [m/s]. Throws InputError where a formula gives no number.
        [[nodiscard]] Vec velocity_at(const Vec& position, int dimension) const;
        [[nodiscard]] double drag_of(double mass) const { return drag + mass_damping * mass; }
    };
    std::vector<Source> of_part;    ///< by part number of the particle set
    std::vector<Source> of_join;    ///< by Bond::join
    std::vector<double> node_mass;  ///< by particle [kg]

    /// `liquid_density`: of the liquid in strips and shells (node_masses). Throws InputError for particles of an
    /// elastic solid that is not in the scene.
    InitialSprings(const ParticleSet& set, const Scene& scene, double liquid_density = 0);
    /// For a set whose springs all belong to one part.
    InitialSprings(const ParticleSet& set, const Part& part);
};

/// The initial body of this number, with the springs between its nodes and the wall particles bonded to it.
/// `contact_range` [m], 0: none. Throws InputError for a body with dihedrals in 2-D.
BodyParts initial_body(const ParticleSet& set, const InitialSprings& drawn, int body, double contact_range);

/// By number of a body: whether it consists of cells.
std::vector<bool> bodies_of_cells(const ParticleSet& set);
/// The same of a body that consists of cells, in the order in which the set has them.
BodyParts initial_cells(const ParticleSet& set, const InitialSprings& drawn, int body, double contact_range);

/// Saves bodies to a checkpoint or loads them from one.
void archive(Archive& file, const std::string& name, std::vector<BodyParts>& bodies);

/// The reduced mass of two masses [kg].
inline double reduced_mass(double a, double b) { return a * b / (a + b); }

}  // namespace dmp::solver
