// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/geometry.hpp"

namespace dmp::geometry {

/// Two solids that share room, or one whose surface goes through itself.
struct SolidMeeting {
    std::string one;
    std::string other;           ///< empty: `one` meets itself
    std::size_t crossings = 0;   ///< pairs of triangles of one surface; edges of one that go through the other
    double volume = 0;           ///< that both solids hold, estimated from 8000 places [m^3]
    Vec position = Vec::Zero();  ///< the first [m]

    /// In words, with lengths in a unit of so many metres: "'a' and 'b' share 2.5 mm^3, around (1, 2, 3) mm".
    [[nodiscard]] std::string text(double metres, const std::string& unit) const;
};

/// Solids with these names whose surfaces meet themselves. A second for 10^6 triangles, about.
std::vector<SolidMeeting> solids_that_meet_themselves(const Geometry& geometry, const std::vector<std::string>& names);

/// Pairs of solids with these names that share room deeper than `tolerance` [m]. Solids that only touch do not; the
/// tolerance is to be larger than what their triangles may be off the surfaces they were drawn as. Solids whose boxes
/// are apart cost nothing.
std::vector<SolidMeeting> solids_that_overlap(const Geometry& geometry, const std::vector<std::string>& names,
                                              double tolerance);

}  // namespace dmp::geometry
