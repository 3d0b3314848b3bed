// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "postproc/uses.hpp"
#include "solver/results/frame.hpp"

namespace dmp::postproc {

/// One entry of a .pvd.
struct SeriesEntry {
    double time = 0;             ///< [s]
    std::filesystem::path file;  ///< ready to open
};

/// The entries of a .pvd in its order; empty when there is no such file.
/// Throws InputError when the file is not a ParaView collection.
std::vector<SeriesEntry> read_series(const std::filesystem::path& pvd);

/// A frame file as one group called `group_name`, with its frame's time, step, spacing and parts.
struct FrameFile {
    Frame frame;
    std::string title;  ///< of the scene
};

/// Throws InputError naming the file when it is missing or broken.
FrameFile read_frame(const std::filesystem::path& vtp, const std::string& group_name);

}  // namespace dmp::postproc
