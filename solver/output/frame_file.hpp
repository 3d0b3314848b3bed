// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/results/frame.hpp"
#include "solver/results/run_label.hpp"

namespace dmp::solver {

/// A frame as it lies in a file, with what the file says of its run.
struct StoredFrame {
    Frame frame;
    RunLabel label;
};

/// DIR/frames, which holds a run's frames by number: frame_000123.h5, or the folder frame_000123 with a piece of each
/// rank in it: piece_007.h5.
[[nodiscard]] std::filesystem::path frame_folder(const std::filesystem::path& folder);
[[nodiscard]] std::filesystem::path frame_path(const std::filesystem::path& folder, long number);
[[nodiscard]] std::filesystem::path piece_folder(const std::filesystem::path& folder, long number);
[[nodiscard]] std::string piece_name(int rank);
/// Removes those from `number` on, with what was never finished; returns how many files that were. Throws
/// ResourceError, and InputError when the folder cannot be looked into.
std::size_t remove_frames(const std::filesystem::path& folder, long number);

/// Writes one sealed HDF5 file, whole or not at all; docs/files.md names the datasets. Throws ResourceError, and
/// std::invalid_argument when arrays do not fit each other or a name cannot be one of a dataset.
void write_frame(const std::filesystem::path& file, const Frame& frame, const RunLabel& label);

/// The same frame back, bit for bit. Throws InputError, with the file's name, when it is missing, none of dmp's frames
/// or damaged.
[[nodiscard]] StoredFrame read_frame(const std::filesystem::path& file);
/// A frame of its pieces, its particles in the order of their ids; of one file, as it is. Throws InputError for each of
/// them like that, and when they are not pieces of one frame.
[[nodiscard]] StoredFrame read_frame(const std::vector<std::filesystem::path>& pieces);

}  // namespace dmp::solver
