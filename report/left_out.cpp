// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/left_out.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

namespace dmp::report {

namespace {

struct Reach {
    double low = 0, high = 0;
    [[nodiscard]] bool has(double x) const { return x >= low && x <= high; }  // NaN: no
};

/// Along one axis.
Reach reach_of(const ShownParticles& particles, std::size_t axis) {
    std::vector<float> places;
    for (const ShownGroup& group : particles.groups)
        for (const GroupAtTime& at : group.at)
            for (std::size_t i = 0; i < at.size(); ++i)
                if (const float x = at.position[3 * i + axis]; std::isfinite(x)) places.push_back(x);
    if (places.empty()) return {};
    const std::size_t outermost = places.size() / 1000;
    const auto nth = [&](std::size_t n) {
        std::ranges::nth_element(places, places.begin() + static_cast<std::ptrdiff_t>(n));
        return static_cast<double>(places[n]);
    };
    const double low = nth(outermost), high = nth(places.size() - 1 - outermost);
    const double more = std::max(high - low, particles.spacing);
    return {low - more, high + more};
}

}  // namespace

void leave_out_far(ShownParticles& particles) {
    const std::array<Reach, 3> reach{reach_of(particles, 0), reach_of(particles, 1), reach_of(particles, 2)};
    std::size_t left_out = 0, in_frames = 0;
    for (ShownGroup& group : particles.groups) {
        if (!group.triangles.empty()) continue;
        for (GroupAtTime& at : group.at) {
            std::size_t kept = 0;
            const std::size_t all = at.size();
            for (std::size_t i = 0; i < all; ++i) {
                if (!reach[0].has(at.position[3 * i]) || !reach[1].has(at.position[3 * i + 1]) ||
                    !reach[2].has(at.position[3 * i + 2]))
                    continue;
                for (std::size_t axis = 0; axis < 3; ++axis) at.position[3 * kept + axis] = at.position[3 * i + axis];
                if (!at.radius.empty()) at.radius[kept] = at.radius[i];
                for (auto& values : at.values) values[kept] = values[i];
                ++kept;
            }
            if (kept == all) continue;
            left_out += all - kept;
            ++in_frames;
            at.position.resize(3 * kept);
            if (!at.radius.empty()) at.radius.resize(kept);
            for (auto& values : at.values) values.resize(kept);
        }
    }
    if (left_out > 0)
        particles.notes.push_back(
            fmt::format("{} of the particles shown, counted in each of {} frames, have no place or one far from all "
                        "others and are left out there",
                        left_out, in_frames));
}

}  // namespace dmp::report
