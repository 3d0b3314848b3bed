// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/vtk_frames.hpp"

#include <algorithm>

namespace dmp::postproc {

namespace fs = std::filesystem;

VtkFrames::VtkFrames(fs::path folder)
    : folder_(std::move(folder)), series_{{{"fluid", {}}, {"solid", {}}, {"spheres", {}}, {"moving_walls", {}}}} {
    for (Series& series : series_) {
        series.entries = read_series(folder_ / (std::string(series.group) + ".pvd"));
        if (std::string_view(series.group) == "moving_walls") continue;  // they move with what they are around
        for (const SeriesEntry& entry : series.entries) times_.push_back(entry.time);
    }
    std::ranges::sort(times_);
    times_.erase(std::ranges::unique(times_).begin(), times_.end());
}

Frame VtkFrames::read(std::size_t frame) const {
    Frame result;
    result.time = times_.at(frame);
    for (const Series& series : series_) {
        const auto entry = std::ranges::find(series.entries, result.time, &SeriesEntry::time);
        if (entry == series.entries.end()) continue;
        Frame of_group = read_frame(entry->file, series.group).frame;
        result.step = of_group.step;
        result.spacing = of_group.spacing;
        result.parts = std::move(of_group.parts);
        result.groups.push_back(std::move(of_group.groups[0]));
    }
    return result;
}

std::optional<FrameGroup> VtkFrames::walls() const {
    if (!fs::exists(folder_ / "walls.vtp")) return std::nullopt;
    return std::move(read_frame(folder_ / "walls.vtp", "walls").frame.groups[0]);
}

bool VtkFrames::of_spheres() const {
    return std::ranges::any_of(series_, [](const Series& series) {
        return std::string_view(series.group) == "spheres" && !series.entries.empty();
    });
}

std::string VtkFrames::title() const {
    const auto used = std::ranges::find_if(series_, [](const Series& series) { return !series.entries.empty(); });
    return read_frame(used->entries.back().file, used->group).title;
}

}  // namespace dmp::postproc
