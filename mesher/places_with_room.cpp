// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/places_with_room.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dmp::mesher {

std::array<int, 3> box_at(const BoxLattice& boxes, const Vec& point) {
    std::array<int, 3> box{};
    for (int axis = 0; axis < boxes.dimension; ++axis)
        box[axis] = static_cast<int>(std::floor((point[axis] - boxes.origin[axis]) / boxes.step[axis]));
    return box;
}

PlacesWithRoom::PlacesWithRoom(const ParticleSpace& space, const BoxLattice& boxes, std::vector<Vec> places)
    : space_(space),
      boxes_(boxes),
      places_(std::move(places)),
      room_(places_.size(), std::numeric_limits<double>::infinity()) {
    for (std::size_t k = 0; k < places_.size(); ++k) {
        in_box_[boxes_.in_period(box_at(boxes_, places_[k]))].push_back(k);
        by_room_.push({room_[k], k});
    }
}

void PlacesWithRoom::take(const Vec& point, double least) {
    const std::array<int, 3> at = box_at(boxes_, point);
    const int around = boxes_.dimension == 3 ? 27 : 9;
    for (int n = 0; n < around; ++n) {
        const int across = boxes_.dimension == 3 ? n / 9 - 1 : 0;
        const auto found = in_box_.find(boxes_.in_period({at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + across}));
        if (found == in_box_.end()) continue;
        for (const std::size_t k : found->second) {
            const double distance = nearest_image(point - places_[k], space_).norm();
            room_[k] = std::min(room_[k], distance < least ? 0 : distance);
        }
    }
}

std::optional<Vec> PlacesWithRoom::widest() {
    while (!by_room_.empty()) {
        const Entry best = by_room_.top();
        if (room_[best.place] == best.room) break;
        by_room_.pop();
        by_room_.push({room_[best.place], best.place});
    }
    if (by_room_.empty() || !(by_room_.top().room > 0)) return std::nullopt;
    return places_[by_room_.top().place];
}

}  // namespace dmp::mesher
