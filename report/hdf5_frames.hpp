// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "report/uses.hpp"
#include "solver/output/frame_index.hpp"
#include "solver/results/frame_source.hpp"

namespace dmp::report {

/// The frames that frames.json of a run's folder names, in HDF5.
class Hdf5Frames : public FrameSource {
  public:
    /// Throws InputError where the index is damaged.
    explicit Hdf5Frames(std::filesystem::path folder);

    [[nodiscard]] const std::vector<double>& times() const override { return times_; }
    [[nodiscard]] Frame read(std::size_t frame) const override;
    [[nodiscard]] std::optional<FrameGroup> walls() const override;

  private:
    std::filesystem::path folder_;
    std::vector<FrameEntry> entries_;
    std::vector<double> times_;
};

}  // namespace dmp::report
