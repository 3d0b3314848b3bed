// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/free_flight.hpp"

#include <cmath>
#include <numeric>

#include "solver/parallel/shares.hpp"
#include "solver/spheres/quad.hpp"

namespace dmp::solver {

void FreeFlight::end(std::size_t owned) {
    busy_.resize(owned);
    std::iota(busy_.begin(), busy_.end(), 0);
    flying_.clear();
    steps_ = 0;
}

void FreeFlight::begin(std::span<const std::uint8_t> acted_on) {
    busy_.clear();
    flying_.clear();
    for (std::size_t row = 0; row < acted_on.size(); ++row)
        (acted_on[row] != 0 ? busy_ : flying_).push_back(static_cast<std::int32_t>(row));
    steps_ = 0;
}

void FreeFlight::pass(double dt, const PositionQuantum& quantum, std::span<SphereMotion> motion) {
    if (flying_.empty()) return;
    if (dt != dt_ || quantum.magic() != magic_) land(motion);
    dt_ = dt;
    magic_ = quantum.magic();
    ++steps_;
}

void FreeFlight::land(std::span<SphereMotion> motion) {
    if (steps_ == 0) return;
    const double steps = static_cast<double>(steps_), exact_within = magic_ * 4 / 3;  // 2^53 quanta
    in_shares(flying_.size(), threads_, [&](std::size_t first, std::size_t end) {
        for (const std::int32_t row : std::span(flying_).subspan(first, end - first)) {
            SphereMotion& sphere = motion[static_cast<std::size_t>(row)];
            const Quad way = way_of(read(sphere.velocity), dt_, magic_), all = steps * way;
            Quad position = read(sphere.position);
            bool exact = true;
            for (int axis = 0; axis < 3; ++axis) exact &= std::abs(position[axis]) + std::abs(all[axis]) < exact_within;
            if (exact) [[likely]] {
                position += all;
            } else {  // so far out that places are rounded: as if each step had looked at it
                for (long step = 0; step < steps_; ++step) position += way;
            }
            write(sphere.position, position);
        }
    });
    steps_ = 0;
}

}  // namespace dmp::solver
