// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/hdf5_frames.hpp"

#include <algorithm>

#include "solver/output/frame_file.hpp"

namespace dmp::report {

Hdf5Frames::Hdf5Frames(std::filesystem::path folder) : folder_(std::move(folder)), entries_(read_frame_index(folder_)) {
    for (const FrameEntry& entry : entries_) times_.push_back(entry.time);
}

Frame Hdf5Frames::read(std::size_t frame) const {
    Frame found = read_frame(entries_.at(frame).files(folder_)).frame;
    std::erase_if(found.groups, [](const FrameGroup& group) { return group.name == "walls"; });
    return found;
}

std::optional<FrameGroup> Hdf5Frames::walls() const {
    if (entries_.empty()) return std::nullopt;
    Frame first = read_frame(entries_.front().files(folder_)).frame;
    const auto found = std::ranges::find(first.groups, "walls", &FrameGroup::name);
    if (found == first.groups.end()) return std::nullopt;
    return std::move(*found);
}

}  // namespace dmp::report
