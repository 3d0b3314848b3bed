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
    std::filesystem::path file;  ///< includes the folder
};

/// The entries of a .pvd in order; empty if there is no such file. Throws InputError if the file is not a ParaView
/// collection.
std::vector<SeriesEntry> read_series(const std::filesystem::path& pvd);

/// A frame file as one group named `group_name`, with the time, step, spacing and parts of its frame.
struct FrameFile {
    Frame frame;
    std::string title;  ///< of the scene
};

/// Throws InputError with the file name if it is missing or damaged.
FrameFile read_frame(const std::filesystem::path& vtp, const std::string& group_name);

}  // namespace dmp::postproc
