// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/results/run_label.hpp"

namespace dmp::solver {

inline constexpr const char* frame_index_name = "frames.json";

/// One frame of a run: a file, or a folder with a piece of each rank in it.
struct FrameEntry {
    std::string path;  ///< relative to the run's folder
    int pieces = 0;    ///< 0: one file
    double time = 0;   ///< [s]
    long step = 0;

    /// Of the frame or its pieces, below the run's folder.
    [[nodiscard]] std::vector<std::filesystem::path> files(const std::filesystem::path& folder) const;
    /// All of them are there.
    [[nodiscard]] bool is_there(const std::filesystem::path& folder) const;
};

/// folder/frames.json: the frames of a run that are whole. Throws ResourceError.
void write_frame_index(const std::filesystem::path& folder, const RunLabel& label,
                       const std::vector<FrameEntry>& frames);

/// The frames back. Throws InputError when there is no such file or it is no index.
[[nodiscard]] std::vector<FrameEntry> read_frame_index(const std::filesystem::path& folder);

}  // namespace dmp::solver
