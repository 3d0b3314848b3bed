// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "postproc/pictures.hpp"

namespace dmp::postproc {

/// Particles before they move, and what is known of each.
struct MeshView {
    enum class Kind : std::uint8_t { fluid, wall, solid };

    std::string title;
    int dimension = 2;
    double spacing = 0;                   ///< [m]
    std::vector<Vec> position;            ///< [m]
    std::vector<Kind> kind;               ///< one a particle, as the next three
    std::vector<float> kernel_sum;        ///< [-]
    std::vector<float> surface_error;     ///< of those next to a surface [spacings]; NaN: others
    std::vector<int> valence;             ///< bonds of each
    std::vector<std::int32_t> bond_ends;  ///< two particles a bond; none across a period
};

/// Draws what a mesh is like:
///   slices.png         the fluid's kernel sums among walls and solids; in 3-D three slices through the middle of the
///                      fluid, a spacing thick
///   surface_error.png  the particles next to a drawn surface by how far they are from where they should be; in 3-D
///                      seen aslant
///   valence.png        nodes by their number of bonds, in 3-D seen aslant; not without bonds
/// Without a display and Xvfb nothing is drawn, and the warning says so. Throws ResourceError when the disk does not
/// take them.
Pictures write_mesh_pictures(const std::filesystem::path& folder, const MeshView& mesh, int width = 1600);

}  // namespace dmp::postproc
