// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/output/frame_index.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/results/frame.hpp"
#include "solver/results/run_label.hpp"

namespace dmp::solver {

/// Writes frames for machines that run without VTK; `dmp convert` makes ParaView's files of them.
///
///     frames/frame_000012.h5            one a frame, whole or not there (frame_file.hpp)
///     frames/frame_000012/piece_003.h5  of several ranks instead: what the fourth one holds of it
///     frames.json                       the frames that are whole, rewritten after each
///
/// Of several ranks each has one, for the same folder, and all call the same functions at the same time.
/// A folder holds one run: the first frame removes the frames an earlier run left there.
class Hdf5Sink : public FrameSeries {
  public:
    /// Makes the folder if need be. Throws InputError when it cannot be made or written to.
    Hdf5Sink(std::filesystem::path folder, RunLabel label, Ranks ranks = Ranks::alone());

    /// The run may have been written by another number of ranks.
    void go_on(long frames) override;

    [[nodiscard]] bool takes_pieces() const override { return ranks_.size() > 1; }
    /// Throws ResourceError when the disk does not take it; the frames before it stay, with their index.
    void write(const Frame& frame) override;

    [[nodiscard]] long frames() const { return frames_; }
    [[nodiscard]] std::vector<std::string> files() const override;

  private:
    void start();
    /// Comes back when all ranks are here.
    void wait_for_all() const;

    std::filesystem::path folder_;
    RunLabel label_;
    Ranks ranks_;
    std::vector<FrameEntry> entries_;  ///< the first rank's
    long frames_ = 0;
    bool started_ = false;
};

}  // namespace dmp::solver
