// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "postproc/pictures.hpp"

namespace dmp::postproc {

/// The initial particles and their properties.
struct MeshView {
    enum class Kind : std::uint8_t { fluid, wall, solid };

    std::string title;
    int dimension = 2;
    double spacing = 0;                   ///< [m]
    std::vector<Vec> position;            ///< [m]
    std::vector<Kind> kind;               ///< one per particle, as are the next three
    std::vector<float> kernel_sum;        ///< [-]
    std::vector<float> surface_error;     ///< for particles next to a surface [spacings]; NaN for others
    std::vector<int> valence;             ///< number of bonds
    std::vector<std::int32_t> bond_ends;  ///< two particles per bond; no bonds across a period
};

/// Writes pictures of a mesh:
///   slices.png         kernel sums of the fluid, with walls and solids; in 3-D three slices through the middle of the
///                      fluid, one spacing thick
///   surface_error.png  particles next to a CAD surface, coloured by their distance from the ideal position; in 3-D an
///                      oblique view
///   valence.png        nodes coloured by their number of bonds, in 3-D an oblique view; only if there are bonds
/// Without a display and Xvfb nothing is drawn, and the warning says so. Throws ResourceError if a file cannot be
/// written.
Pictures write_mesh_pictures(const std::filesystem::path& folder, const MeshView& mesh, int width = 1600);

}  // namespace dmp::postproc
