// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/even_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace dmp::report {

namespace {

constexpr unsigned bits = 21;  // of each axis

/// The lower 21 bits, two zeros between each and the next.
std::uint64_t spread(std::uint64_t value) {
    value &= 0x1fffff;
    value = (value | value << 32U) & 0x1f00000000ffff;
    value = (value | value << 16U) & 0x1f0000ff0000ff;
    value = (value | value << 8U) & 0x100f00f00f00f00f;
    value = (value | value << 4U) & 0x10c30c30c30c30c3;
    return (value | value << 2U) & 0x1249249249249249;
}

/// Places along a Morton curve through the box of the particles, the same scale for all axes; 0 without a finite place.
std::vector<std::uint64_t> places(const FrameGroup& group, const std::vector<std::size_t>& particles) {
    std::array<float, 3> low{}, high{};
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    const auto is_finite = [&](std::size_t i) {
        return std::isfinite(group.position[3 * i]) && std::isfinite(group.position[3 * i + 1]) &&
               std::isfinite(group.position[3 * i + 2]);
    };
    for (const std::size_t i : particles)
        for (std::size_t axis = 0; axis < 3 && is_finite(i); ++axis) {
            low[axis] = std::min(low[axis], group.position[3 * i + axis]);
            high[axis] = std::max(high[axis], group.position[3 * i + axis]);
        }
    double widest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        widest = std::max(widest, static_cast<double>(high[axis]) - static_cast<double>(low[axis]));
    const double scale = widest > 0 ? ((1U << bits) - 1) / widest : 0;
    std::vector<std::uint64_t> keys;
    keys.reserve(particles.size());
    for (const std::size_t i : particles) {
        std::uint64_t key = 0;
        for (std::size_t axis = 0; axis < 3 && is_finite(i); ++axis)
            key |= spread(static_cast<std::uint64_t>(
                       scale * (static_cast<double>(group.position[3 * i + axis]) - static_cast<double>(low[axis]))))
                   << axis;
        keys.push_back(key);
    }
    return keys;
}

void add_sorted(std::vector<std::int64_t>& ids, std::vector<std::int64_t> more) {
    std::ranges::sort(more);
    const auto middle = static_cast<std::ptrdiff_t>(ids.size());
    ids.insert(ids.end(), more.begin(), more.end());
    std::inplace_merge(ids.begin(), ids.begin() + middle, ids.end());
}

}  // namespace

EvenChoice::EvenChoice(std::size_t every) : every_(every) {
    if (every == 0) throw std::invalid_argument("EvenChoice: every 0th particle");
}

std::vector<std::size_t> EvenChoice::of(const FrameGroup& group) {
    std::vector<std::size_t> shown;
    if (every_ == 1) {
        shown.resize(group.size());
        std::iota(shown.begin(), shown.end(), std::size_t{0});
        return shown;
    }
    std::vector<std::size_t> fresh;
    for (std::size_t i = 0; i < group.size(); ++i) {
        if (std::ranges::binary_search(chosen_, group.id[i]))
            shown.push_back(i);
        else if (!std::ranges::binary_search(left_out_, group.id[i]))
            fresh.push_back(i);
    }
    const std::vector<std::uint64_t> keys = places(group, fresh);
    std::vector<std::size_t> order(fresh.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return keys[k]; });
    std::vector<std::int64_t> chosen, left_out;
    for (const std::size_t k : order) {
        const std::size_t i = fresh[k];
        if (met_++ % every_ == 0) {
            chosen.push_back(group.id[i]);
            shown.push_back(i);
        } else {
            left_out.push_back(group.id[i]);
        }
    }
    add_sorted(chosen_, std::move(chosen));
    add_sorted(left_out_, std::move(left_out));
    std::ranges::sort(shown);
    return shown;
}

}  // namespace dmp::report
