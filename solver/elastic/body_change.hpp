// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/elastic/body_parts.hpp"

namespace dmp::solver {

/// Changes of elastic bodies at one moment, in the order of the members. Particles are identified by their ids.
struct BodyChange {
    struct Bond {
        int a = 0, b = 0;
        double rest_length = 0;  ///< [m]; 0: their current distance
        double stiffness = 0;    ///< k_b [N/m]
        double damping = 0;      ///< dashpot, fraction of critical [-]
        int origin = 0;          ///< as in body_names
    };
    std::vector<BodyParts::Node> nodes;      ///< so far in no body; each is a body until it is bonded
    std::vector<Bond> bonds;                 ///< to be added
    std::vector<std::array<int, 2>> broken;  ///< ends of the bonds to be removed; cells of faces

    [[nodiscard]] bool empty() const { return nodes.empty() && bonds.empty() && broken.empty(); }
};

struct ChangedBodies {
    std::vector<BodyParts> bodies;
    std::vector<int> made, broken;  ///< origins of the bonds
};

/// Returns the bodies after the change. Bodies joined by a new bond become one, in one image along periodic axes (the
/// smaller one is moved by whole periods); parts no longer connected by springs become separate bodies. Hinges and
/// dihedrals with a broken bond among their sides are removed. A bond is not made if the two nodes are already
/// bonded, or if it would bind a body to its own periodic image. Solids of cells are cut (cut_faces), not joined. Nodes
/// are sorted by id, and bodies by the id of
/// their first node. Mass and momentum of each node stay the same.
ChangedBodies change_bodies(const std::vector<BodyParts>& bodies, const BodyChange& change, const ParticleSpace& space);

}  // namespace dmp::solver
