// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>

#include "solver/frame.hpp"
#include "solver/run_label.hpp"

namespace dmp {

/// A frame as it lies in a file, with what the file says of its run.
struct StoredFrame {
    Frame frame;
    RunLabel label;
};

/// DIR/frames, which holds a run's frames by number: frame_000123.h5.
[[nodiscard]] std::filesystem::path frame_folder(const std::filesystem::path& folder);
[[nodiscard]] std::filesystem::path frame_path(const std::filesystem::path& folder, long number);
/// The frames that DIR/frames holds; none where there is no such folder. Throws InputError when it cannot be looked
/// into.
[[nodiscard]] std::map<long, std::filesystem::path> frame_files(const std::filesystem::path& folder);
/// Removes those from `number` on, and those that were never finished. Throws ResourceError.
void remove_frames(const std::filesystem::path& folder, long number);

/// Writes one sealed HDF5 file, whole or not at all; docs/files.md names the datasets. Throws ResourceError, and
/// std::invalid_argument when arrays do not fit each other or a name cannot be one of a dataset.
void write_frame(const std::filesystem::path& file, const Frame& frame, const RunLabel& label);

/// The same frame back, bit for bit. Throws InputError, with the file's name, when it is missing, none of dmp's frames
/// or damaged.
[[nodiscard]] StoredFrame read_frame(const std::filesystem::path& file);

}  // namespace dmp
