// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/frame.hpp"
#include "solver/run_label.hpp"

namespace dmp {

inline constexpr const char* frame_index_name = "frames.json";

/// Writes frames for machines that run without VTK; `dmp convert` makes ParaView's files of them.
///
///     frames/frame_000012.h5    one a frame, whole or not there (frame_file.hpp)
///     frames.json               the frames' files, times and steps, rewritten after each frame
///
/// A folder holds one run: the first frame removes the frames an earlier run left there.
class Hdf5Sink : public FrameSeries {
  public:
    /// Makes the folder if need be. Throws InputError when it cannot be made or written to.
    Hdf5Sink(std::filesystem::path folder, RunLabel label);

    void go_on(long frames) override;

    /// Throws ResourceError when the disk does not take it; the frames before it stay, with their index.
    void write(const Frame& frame) override;

    [[nodiscard]] long frames() const { return static_cast<long>(entries_.size()); }
    [[nodiscard]] std::vector<std::string> files() const override;

  private:
    struct Entry {
        std::string file;  ///< relative to the folder
        double time;       ///< [s]
        long step;
    };

    void write_index() const;

    std::filesystem::path folder_;
    RunLabel label_;
    std::vector<Entry> entries_;
    bool started_ = false;
};

}  // namespace dmp
