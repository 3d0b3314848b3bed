// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace dmp::postproc {

inline constexpr const char* film_file_name = "film.png";

struct PictureOptions {
    std::string field = "velocity";  ///< colours the fluid; for vectors the magnitude
    int width = 1600;                ///< [pixels]
    int sheet_frames = 8;            ///< frames on cycle.png, evenly spaced over the run
    bool film = false;               ///< also film.png
    int film_width = 800;            ///< [pixels]
    int film_frames = 250;           ///< in the film at most, evenly spaced over the run
    /// For each axis, low and high: whether that side of the box is a plane of symmetry; in 3-D, slices are placed
    /// there.
    std::array<std::array<bool, 2>, 3> mirrored{};
};

struct Pictures {
    std::vector<std::string> files;  ///< written, relative to the folder
    std::string warning;             ///< pictures that could not be drawn and why, one per line; empty on success
};

/// Writes pictures of a finished run from the files in its folder (fluid.pvd, solid.pvd, walls.vtp, measures.csv):
///   last_frame.png  the last frame
///   cycle.png       several frames with one colour range; only if there are several
///   measures.png    the measures over time; only if there are measures
///   film.png        where asked for: the frames with one colour range, as an animated PNG; only if there are several
/// Without a display and Xvfb only measures.png is written, and the warning says so. Throws InputError if the folder
/// has no frames or damaged ones, ResourceError if a file cannot be written.
Pictures write_pictures(const std::filesystem::path& folder, const PictureOptions& options);

}  // namespace dmp::postproc
