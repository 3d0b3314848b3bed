// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/periodic_images.hpp"

#include <cmath>

namespace dmp::particles {

std::vector<PeriodicImage> periodic_images(const Coordinates& points, std::size_t count, const Box& box,
                                           const std::array<bool, 3>& periodic, double reach) {
    std::vector<PeriodicImage> images;
    for (int axis = 0; axis < 3; ++axis) {
        if (!periodic[axis]) continue;
        const double low = box.low[axis], high = box.high[axis];
        const auto mirror = [&](int source, const std::array<double, 3>& shift) {
            const double x = points[axis][source] + shift[axis];
            for (const double period : {high - low, low - high})
                for (int periods = 1;; ++periods) {  // more than one where the reach exceeds the period
                    const double moved = x + periods * period;
                    if (!(moved >= low - reach && moved < high + reach)) break;
                    PeriodicImage image{source, shift};
                    image.shift[axis] += periods * period;
                    images.push_back(image);
                }
        };
        // Images made for earlier axes are mirrored too: these are the corners.
        const std::size_t earlier = images.size();
        for (std::size_t i = 0; i < count; ++i) mirror(static_cast<int>(i), {});
        for (std::size_t k = 0; k < earlier; ++k) mirror(images[k].source, std::array<double, 3>(images[k].shift));
    }
    return images;
}

double wrapped(double x, double low, double high) {
    if (x >= low && x < high) return x;
    const double period = high - low;
    double moved = x - period * std::floor((x - low) / period);
    if (moved < low) moved += period;  // the quotient was rounded up to a whole number
    if (moved >= high) moved -= period;
    if (moved < low || moved >= high) return low;  // x a rounding error away from a whole number of periods
    return moved;
}

}  // namespace dmp::particles
