// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace dmp::postproc {

struct PictureOptions {
    std::string field = "velocity";  ///< what colours the fluid; of vectors the magnitude
    int width = 1600;                ///< [pixels]
    int sheet_frames = 8;            ///< frames on cycle.png, evenly over the run
    /// By axis, low and high: whether the scene is mirrored on that side of its box; slices in 3-D lie there.
    std::array<std::array<bool, 2>, 3> mirrored{};
};

struct Pictures {
    std::vector<std::string> files;  ///< written, relative to the folder
    std::string warning;             ///< what could not be drawn and why, one a line; empty when all went well
};

/// Draws a finished run from what its folder holds (fluid.pvd, solid.pvd, walls.vtp, measures.csv):
///   last_frame.png  the last frame
///   cycle.png       several frames with one colour range; not for a single frame
///   measures.png    the measures over time; not without measures
/// Without a display and Xvfb only measures.png is drawn, and the warning says so.
/// Throws InputError when the folder holds no frames or broken ones, ResourceError when the disk does not take it.
Pictures write_pictures(const std::filesystem::path& folder, const PictureOptions& options);

}  // namespace dmp::postproc
