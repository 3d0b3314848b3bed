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

/// One drawing of a run's frames: what it shows, and from where.
struct View {
    enum class Shows : std::uint8_t {
        everything,  ///< as it lies in 2-D; spheres in 3-D
        slice,       ///< a slab of 1.5 spacings about the cut
        opened,      ///< fluid and walls behind the cut, what stands in the fluid whole
    };
    Shows shows = Shows::everything;
    Viewpoint cut;   ///< the cut is its plane z = 0
    Viewpoint from;  ///< seen from
    Box area;        ///< drawn, as seen [m]
    std::string caption;
    std::vector<std::int32_t> bodies{};  ///< rigid parts that stand in the fluid
    int axis = 0;                        ///< opened: shows fluid and walls from low to high along this axis [m]
    double low = 0, high = 0;
};

/// How a run's frames are drawn: all at once in 2-D and of spheres. Of a fluid in 3-D
///   - a slice along its longest axis, in the larger of the two planes, or of two alike in the one that cuts what
///     stands in the fluid into more pieces (spring bodies, and rigid parts that do not reach out of the fluid's box)
///   - a slice across that axis, where most of it stands, or half-way
///   - where there is such a thing, a view of it aslant, the walls and the fluid in front of the first slice taken away
/// Spring bodies in 3-D without a fluid are seen aslant.
/// By axis, low and high, `mirrored` names the planes of symmetry: there, and not half-way, lies the first slice.
std::vector<View> cameras(const RunFolder& run, const std::array<std::array<bool, 2>, 3>& mirrored = {});

/// What of a frame a look shows, turned so that x runs to the right, y up and z towards the eye; slices about z = 0.
struct Seen {
    RunFrame frame;                   ///< groups of which nothing is seen are left out
    std::optional<FrameGroup> walls;  ///< at rest
};
Seen seen(const View& view, const RunFrame& frame, const std::optional<FrameGroup>& walls);

/// layers_of() what is seen; opened, all particles as spheres.
std::vector<ParticleLayer> layers_of(const View& view, const Seen& seen, const std::string& field,
                                     const ColourScale& scale);

}  // namespace dmp::postproc
