// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "postproc/frame_scene.hpp"
#include "postproc/viewpoint.hpp"

namespace dmp::postproc {

/// One view of a run's frames: its content and its viewpoint.
struct View {
    enum class Shows : std::uint8_t {
        everything,  ///< all particles, in 2-D; spheres in 3-D
        slice,       ///< a slab of 1.5 spacings around the cut
        opened,      ///< fluid and walls behind the cut, and all of the objects in the fluid
    };
    Shows shows = Shows::everything;
    Viewpoint cut;   ///< its plane z = 0 is the cut
    Viewpoint from;  ///< viewpoint
    Box area;        ///< area drawn, in view coordinates [m]
    std::string caption;
    std::vector<std::int32_t> bodies{};  ///< rigid parts that are objects in the fluid
    int axis = 0;                        ///< opened: fluid and walls are shown from low to high along this axis [m]
    double low = 0, high = 0;
};

/// The views of a run's frames. In 2-D and for spheres one view of everything. For a fluid in 3-D, where the objects
/// in the fluid are elastic bodies, and rigid parts that do not extend out of the fluid's box:
///   - a slice along the longest axis, in the larger of the two planes; if they are equally large, in the one that cuts
///     the objects in the fluid into more pieces
///   - a slice perpendicular to that axis, where it cuts most of the objects, or in the middle
///   - if there are objects, an oblique view of them, without the walls and the fluid in front of the first slice
/// Elastic bodies in 3-D without a fluid are shown in an oblique view. For each axis, low and high, `mirrored` gives
/// the planes of symmetry: the first slice lies there instead of in the middle.
std::vector<View> cameras(const RunFolder& run, const std::array<std::array<bool, 2>, 3>& mirrored = {});

/// The part of a frame that a view shows, in view coordinates: x to the right, y up and z towards the viewer; slices
/// are around z = 0.
struct Seen {
    RunFrame frame;                   ///< without groups that are not visible
    std::optional<FrameGroup> walls;  ///< at rest
};
Seen seen(const View& view, const RunFrame& frame, const std::optional<FrameGroup>& walls);

/// layers_of() for a view; if opened, all particles are spheres.
std::vector<ParticleLayer> layers_of(const View& view, const Seen& seen, const std::string& field,
                                     const ColourScale& scale);

}  // namespace dmp::postproc
