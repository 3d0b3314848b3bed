// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "postproc/uses.hpp"
#include "solver/results/frame.hpp"
#include "solver/results/run_label.hpp"

namespace dmp::postproc {

/// Writes frames for ParaView into one folder:
///
///     fluid.pvd, solid.pvd, spheres.pvd   the series, rewritten after each frame
///     moving_walls.pvd                    the same for walls that move
///     frames/fluid_000012.vtp             particles as vertex cells
///     frames/solid_000012.vtp             particles as vertex cells, bonds as line cells
///     frames/spheres_000012.vtp           spheres as vertex cells, with their radius
///     walls.vtp                           walls at rest, written once; walls for spheres as triangles
///     open_in_paraview.py                 opens all of them with suitable settings
///
/// A folder contains one run: the first frame removes frames of an earlier run in that folder. A .pvd lists only
/// complete files, so a run that was killed can be opened up to its last frame.
class VtkSink : public FrameSeries {
  public:
    /// Creates the folder if necessary. Throws InputError if it cannot be created or written to.
    VtkSink(std::filesystem::path folder, RunLabel label);

    void go_on(long frames) override;

    /// Throws ResourceError if a file cannot be written. Empty groups are skipped.
    void write(const Frame& frame) override;

    [[nodiscard]] long frames() const { return frames_; }
    /// The files to open, relative to the folder: .pvd, walls.vtp, open_in_paraview.py.
    [[nodiscard]] std::vector<std::string> files() const override;

  private:
    struct Entry {
        double time;
        std::string file;  ///< relative to the folder
    };

    void start(const Frame& frame);
    void write_series(const std::string& name) const;

    std::filesystem::path folder_;
    RunLabel label_;
    std::map<std::string, std::vector<Entry>> series_;  ///< by group name
    long frames_ = 0;
    bool walls_written_ = false;
};

}  // namespace dmp::postproc
