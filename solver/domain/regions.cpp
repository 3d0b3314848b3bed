// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/domain/regions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace dmp::solver {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Split {
    int axis = 0;
    double position = 0;
    std::size_t below = 0;  ///< number of boxes
};

/// A plane with the first few boxes below it and the others above.
std::optional<Split> split(std::span<const Box> boxes) {
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> lowest(boxes.size());  // of this box and the following ones
        for (std::size_t k = boxes.size(); k-- > 0;)
            lowest[k] = k + 1 < boxes.size() ? std::min(boxes[k].low[axis], lowest[k + 1]) : boxes[k].low[axis];
        double highest = boxes[0].high[axis];
        for (std::size_t below = 1; below < boxes.size(); ++below) {
            highest = std::max(highest, boxes[below - 1].high[axis]);
            if (highest <= lowest[below]) return Split{axis, highest, below};
        }
    }
    return std::nullopt;
}

}  // namespace

Regions::Regions(const Box& space, int ranks) : boxes_(static_cast<std::size_t>(ranks), Box{space.high, space.low}) {
    boxes_.front() = space;
}

std::optional<Regions> Regions::along(const Box& space, std::span<const Box> boxes) {
    Regions regions(space, static_cast<int>(boxes.size()));
    if (!regions.cut(boxes, 0, 0, regions.root_)) return std::nullopt;
    regions.set_boxes(regions.root_, space);
    return regions;
}

/// Cuts the part of space of the ranks first, first + 1, ..., which have these boxes.
bool Regions::cut(std::span<const Box> boxes, int first, int depth, int& part) {
    depth_ = std::max(depth_, depth);
    part = -1 - first;
    if (boxes.size() == 1) return true;
    const std::optional<Split> found = split(boxes);
    if (!found) return false;
    Cut here;
    here.axis = found->axis;
    here.position[0] = found->position;
    here.share_below = static_cast<double>(found->below) / static_cast<double>(boxes.size());
    if (!cut(boxes.first(found->below), first, depth + 1, here.below)) return false;
    if (!cut(boxes.subspan(found->below), first + static_cast<int>(found->below), depth + 1, here.above)) return false;
    part = static_cast<int>(cuts_.size());
    cuts_.push_back(here);
    return true;
}

void Regions::set_boxes(int part, const Box& box) {
    if (part < 0) {
        boxes_[static_cast<std::size_t>(-1 - part)] = box;
        return;
    }
    const Cut& cut = cuts_[static_cast<std::size_t>(part)];
    Box below = box, above = box;
    below.high[cut.axis] = above.low[cut.axis] = std::clamp(cut.position[0], box.low[cut.axis], box.high[cut.axis]);
    set_boxes(cut.below, below);
    set_boxes(cut.above, above);
}

void Regions::divide_ties(const Ranks& ranks, const WeightedPoints& points) {
    struct Tied {
        int cut = 0;
        double next = 0, after = 0;  ///< coordinates on the plane
        std::int64_t weight = 0;
        bool operator<(const Tied& other) const {
            return std::tie(cut, next, after) < std::tie(other.cut, other.next, other.after);
        }
    };
    // Integer weights: their sums are the same on every rank.
    constexpr double unit = 1 << 20;
    // From the whole to the parts, because the points of a part depend on the cuts before it.
    for (int depth = 0; depth < depth_; ++depth) {
        std::vector<std::int64_t> below(cuts_.size()), all(cuts_.size());
        std::vector<Tied> tied;
        for (std::size_t k = 0; k < points.weights.size(); ++k) {
            const std::array<double, 3> point = points.point(k);
            int part = root_;
            for (int level = 0; level < depth && part >= 0; ++level) part = side(cuts_[part], point);
            if (part < 0) continue;
            const Cut& cut = cuts_[part];
            const std::int64_t weight = std::llround(points.weights[k] * unit);
            all[part] += weight;
            if (point[cut.axis] < cut.position[0]) below[part] += weight;
            if (point[cut.axis] == cut.position[0])
                tied.push_back({part, point[(cut.axis + 1) % 3], point[(cut.axis + 2) % 3], weight});
        }
        ranks.sum(below);
        ranks.sum(all);
        tied = ranks.all_gather(tied);
        std::sort(tied.begin(), tied.end());
        for (const Tied& point : tied) {
            Cut& cut = cuts_[point.cut];
            if (cut.position[1] == -infinity)
                cut.position[1] = infinity;  // all of them below, unless a position is found next
            const double wanted = cut.share_below * static_cast<double>(all[point.cut]);
            const double passed = static_cast<double>(below[point.cut]) + 0.5 * static_cast<double>(point.weight);
            if (passed > wanted && cut.position[1] == infinity)
                cut.position = {cut.position[0], point.next, point.after};
            below[point.cut] += point.weight;
        }
    }
}

}  // namespace dmp::solver
