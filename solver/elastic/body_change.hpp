// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/elastic/body_parts.hpp"

namespace dmp::solver {

/// What happens to spring bodies at one moment, in this order. Particles are named by their ids.
struct BodyChange {
    struct Bond {
        int a = 0, b = 0;
        double rest_length = 0;  ///< [m]; 0: their distance now
        double stiffness = 0;    ///< k_b [N/m]
        double damping = 0;      ///< dashpot, fraction of critical [-]
        int origin = 0;          ///< body_names
    };
    std::vector<BodyParts::Node> nodes;      ///< that were in no body; each is one of its own until it is bonded
    std::vector<Bond> bonds;                 ///< to be made
    std::vector<std::array<int, 2>> broken;  ///< ends of bonds that break

    [[nodiscard]] bool empty() const { return nodes.empty() && bonds.empty() && broken.empty(); }
};

/// The vector from one point to the nearest periodic image of another [m].
Vec nearest_image(Vec apart, const ParticleSpace& space);

struct ChangedBodies {
    std::vector<BodyParts> bodies;
    std::vector<int> made, broken;  ///< origins of the bonds
};

/// The bodies after the change: what a new bond joins becomes one body, in one image along periodic axes (the smaller
/// piece moves by whole periods); what hangs together by no springs any more becomes several. A hinge or dihedral with
/// a broken bond among its sides goes too. A second bond of the same two nodes is not made, nor is one that would bind
/// a body to its own periodic image. Nodes, and bodies by their first node, are in the order of their ids. Mass and
/// momentum are those of before, node by node.
ChangedBodies change_bodies(const std::vector<BodyParts>& bodies, const BodyChange& change, const ParticleSpace& space);

}  // namespace dmp::solver
