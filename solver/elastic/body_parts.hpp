// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/state/archive.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// A spring body as plain values, its nodes numbered from 0: what a SpringBody is made from, and what is cut and joined
/// where bodies change (BodyChange). All positions never wrap.
struct BodyParts {
    struct Node {
        int id = 0;            ///< of its particle
        bool fixed = false;    ///< held where it is
        bool of_wall = false;  ///< a wall's particle that the body is bonded to: fixed, and no particle of its own
        int origin = 0;        ///< what it came from: number of an elastic solid or [[solidify]] (body_names)
        double mass = 0;       ///< [kg]
        double drag = 0;       ///< lab-frame drag [kg/s]
        Vec position = Vec::Zero(), velocity = Vec::Zero(), position_before = Vec::Zero(), rest_position = Vec::Zero();
    };
    /// A bond, hinge or dihedral: nodes as in Bond, Hinge and Dihedral.
    template <int N>
    struct Spring {
        std::array<int, N> node{};
        double rest = 0;       ///< length [m] or angle [rad]
        double stiffness = 0;  ///< [N/m] or [J]
        double dashpot = 0;    ///< [N s/m] or [J s]
        int origin = 0;        ///< as of a node
    };

    std::vector<Node> nodes;
    std::vector<Spring<2>> bonds;
    std::vector<Spring<3>> hinges;
    std::vector<Spring<4>> dihedrals;
    /// Pairs of nodes whose distance is their springs' business: contact leaves them alone. The lower number first,
    /// in order.
    std::vector<std::pair<int, int>> held_apart;
};

/// What nodes and bonds may come from, by number: the enabled elastic solids of the scene, its [[solidify]], and its
/// [[join]] of enabled parts.
std::vector<std::string> body_names(const Scene& scene);

/// What a scene says of the springs that were drawn for it.
struct InitialSprings {
    struct Source {
        int origin = 0;      ///< body_names
        double damping = 0;  ///< dashpots, fraction of critical [-]
        double drag = 0;     ///< lab-frame drag of a node [kg/s]
    };
    std::vector<Source> of_part;  ///< by part of the particle set
    std::vector<Source> of_join;  ///< by Bond::join

    /// Throws InputError for particles of an elastic solid that the scene does not have.
    InitialSprings(const ParticleSet& set, const Scene& scene);
    /// Of a set whose springs are all of one part.
    InitialSprings(const ParticleSet& set, const Part& part);
};

/// The body of this number as it was drawn, with the springs among its nodes and those of walls that bonds join it to.
/// `contact_range` [m], 0: none. Throws InputError for one in 2-D that has dihedrals.
BodyParts initial_body(const ParticleSet& set, const InitialSprings& drawn, int body, double contact_range);

/// Bodies on their way into a checkpoint or out of one.
void archive(Archive& file, const std::string& name, std::vector<BodyParts>& bodies);

/// The reduced mass of two [kg].
inline double reduced_mass(double a, double b) { return a * b / (a + b); }

}  // namespace dmp::solver
