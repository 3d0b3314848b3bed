// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/colour_map.hpp"

#include <algorithm>
#include <cmath>

namespace dmp::postproc {

ColourMap::ColourMap(double low, double high, std::vector<Colour> anchors)
    : low_(low), high_(high), anchors_(std::move(anchors)) {}

ColourMap ColourMap::sequential(double low, double high) {
    return {low,
            high,
            {{68, 1, 84},
             {72, 26, 108},
             {71, 47, 125},
             {65, 68, 135},
             {57, 86, 140},
             {49, 104, 142},
             {42, 120, 142},
             {35, 136, 142},
             {31, 152, 139},
             {34, 168, 132},
             {53, 183, 121},
             {84, 197, 104},
             {122, 209, 81},
             {165, 219, 54},
             {210, 226, 27},
             {253, 231, 37}}};
}

ColourMap ColourMap::diverging(double middle, double span) {
    return {middle - span,
            middle + span,
            {{59, 76, 192},
             {98, 130, 234},
             {141, 176, 254},
             {184, 208, 249},
             {221, 221, 221},
             {245, 196, 173},
             {244, 154, 123},
             {222, 96, 77},
             {180, 4, 38}}};
}

Colour ColourMap::operator()(double value) const {
    if (std::isnan(value)) return colours::not_a_number;
    const auto last = static_cast<double>(anchors_.size() - 1);
    const double position = std::clamp((value - low_) / (high_ - low_), 0.0, 1.0) * last;
    const auto below = static_cast<std::size_t>(std::min(std::floor(position), last - 1));
    const double share = position - static_cast<double>(below);
    const auto mix = [share](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround((1 - share) * a + share * b));
    };
    const Colour& a = anchors_[below];
    const Colour& b = anchors_[below + 1];
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

}  // namespace dmp::postproc
