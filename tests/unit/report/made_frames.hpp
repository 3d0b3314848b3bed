// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "solver/results/frame_source.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

/// Frames that a test has made, some of them damaged.
struct MadeFrames : FrameSource {
    std::vector<Frame> frames;
    std::optional<FrameGroup> at_rest;
    std::set<std::size_t> damaged;
    bool walls_damaged = false;

    explicit MadeFrames(std::vector<Frame> made) : frames(std::move(made)) {
        for (const Frame& frame : frames) times_.push_back(frame.time);
    }
    [[nodiscard]] const std::vector<double>& times() const override { return times_; }
    [[nodiscard]] Frame read(std::size_t frame) const override {
        if (damaged.contains(frame)) throw InputError(SourceLocation{"frame_7.vtp", 0, 0}, "cannot be <read>", "");
        return frames.at(frame);
    }
    [[nodiscard]] std::optional<FrameGroup> walls() const override {
        if (walls_damaged) throw InputError(SourceLocation{"walls.vtp", 0, 0}, "cannot be read", "");
        return at_rest;
    }

  private:
    std::vector<double> times_;
};

/// A group of particles with ids from 0 on.
inline FrameGroup made_group(const std::string& name, std::vector<float> position,
                             std::vector<FrameField> fields = {}) {
    FrameGroup group;
    group.name = name;
    group.position = std::move(position);
    for (std::size_t i = 0; i < group.position.size() / 3; ++i) {
        group.id.push_back(static_cast<std::int64_t>(i));
        group.part.push_back(0);
    }
    group.fields = std::move(fields);
    return group;
}

inline Frame made_frame(double time, std::vector<FrameGroup> groups) {
    Frame frame;
    frame.time = time;
    frame.spacing = 0.5;
    frame.groups = std::move(groups);
    return frame;
}

/// Two frames of a fluid of three particles, the corners of a square but one.
inline MadeFrames two_frames() {
    const auto fluid = [](float speed) {
        return made_group("fluid", {0, 0, 0, 1, 0, 0, 0, 1, 0},
                          {{"velocity", "m/s", 3, {0, 0, 0, speed, 0, 0, 0, 3, 4}}});
    };
    return MadeFrames({made_frame(0, {fluid(1)}), made_frame(0.5, {fluid(2)})});
}

}  // namespace dmp::tests
