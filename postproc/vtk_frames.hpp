// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "postproc/read_frames.hpp"
#include "postproc/uses.hpp"
#include "solver/results/frame_source.hpp"

namespace dmp::postproc {

/// The frames in the ParaView files of a run's folder.
class VtkFrames : public FrameSource {
  public:
    /// Reads the lists of frames; no frames where there are no lists. Throws InputError where one is damaged.
    explicit VtkFrames(std::filesystem::path folder);

    [[nodiscard]] const std::vector<double>& times() const override { return times_; }
    /// With the groups fluid, solid, spheres and moving_walls, where they have a file of this time.
    [[nodiscard]] Frame read(std::size_t frame) const override;
    [[nodiscard]] std::optional<FrameGroup> walls() const override;

    [[nodiscard]] bool of_spheres() const;
    /// Of the scene, as the last frame has it. There must be a frame. Throws InputError where that is damaged.
    [[nodiscard]] std::string title() const;

  private:
    struct Series {
        const char* group;
        std::vector<SeriesEntry> entries;
    };
    std::filesystem::path folder_;
    std::array<Series, 4> series_;
    std::vector<double> times_;
};

}  // namespace dmp::postproc
