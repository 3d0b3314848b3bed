// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <queue>
#include <unordered_map>
#include <vector>

#include "mesher/solid_cells.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

/// The box of a lattice that a point lies in.
std::array<int, 3> box_at(const BoxLattice& boxes, const Vec& point);

/// How much room there is at places for a particle more: the distance to the nearest particle in the boxes around.
class PlacesWithRoom {
  public:
    /// `boxes` are not smaller than the room that is asked about.
    PlacesWithRoom(const ParticleSpace& space, const BoxLattice& boxes, std::vector<Vec> places);

    /// A particle stands at a point: places nearer to it than `least` [m] have no room.
    void take(const Vec& point, double least = 0);
    /// The place with most room, of several the first; nothing where none has any.
    [[nodiscard]] std::optional<Vec> widest();

  private:
    /// A place with the room that it had.
    struct Entry {
        double room;  ///< [m]
        std::size_t place;
        bool operator<(const Entry& other) const {
            return room != other.room ? room < other.room : place > other.place;
        }
    };

    struct HashOfBox {
        std::size_t operator()(const std::array<int, 3>& box) const {
            constexpr std::size_t prime = 1000003;
            return (static_cast<std::size_t>(box[0]) * prime + static_cast<std::size_t>(box[1])) * prime +
                   static_cast<std::size_t>(box[2]);
        }
    };

    const ParticleSpace& space_;
    const BoxLattice& boxes_;
    std::vector<Vec> places_;
    std::vector<double> room_;  ///< [m]
    std::unordered_map<std::array<int, 3>, std::vector<std::size_t>, HashOfBox> in_box_;
    std::priority_queue<Entry> by_room_;  ///< of each place, with no less room than it has now
};

}  // namespace dmp::mesher
