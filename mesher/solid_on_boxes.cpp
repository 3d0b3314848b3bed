// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/solid_on_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/surface_crossings.hpp"

namespace dmp::mesher {

namespace {

constexpr int lines_across = 7;  ///< of a box, along y and along z

}  // namespace

SolidOnBoxes::SolidOnBoxes(const TriangleSurface& surface, const BoxLattice& lattice) : lattice_(lattice) {
    Vec low = Vec::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Vec& corner : surface.corners) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const auto place = [&](double x) { return (x - lattice_.origin[axis]) / lattice_.step[axis]; };
        first_[axis] = std::max(lattice_.first[axis], static_cast<int>(std::floor(place(low[axis]) + 1e-9)));
        last_[axis] = std::min(lattice_.last[axis], static_cast<int>(std::ceil(place(high[axis]) - 1e-9)));
        if (last_[axis] <= first_[axis]) last_ = first_;  // none of it is in the scene
    }
    sums_.resize(static_cast<std::size_t>(last_[0] - first_[0]) * (last_[1] - first_[1]) * (last_[2] - first_[2]));

    const double step_y = lattice_.step[1] / lines_across, step_z = lattice_.step[2] / lines_across;
    const int lines = lines_across * (last_[1] - first_[1]), layers = lines_across * (last_[2] - first_[2]);
    const Vec start = lattice_.corner(first_);
    std::vector<LineRow> rows;
    for (int row = 0; row < layers; ++row)
        rows.push_back({start[2] + (row + 0.5) * step_z, start[1] + 0.5 * step_y, step_y, lines});
    const SurfaceCrossings crossings(surface, rows);
    const auto inside_of = [&](int row, int line) {
        std::vector<Stretch> inside;
        int depth = 0;
        double entered = 0;
        for (const Crossing& crossing : crossings.of(static_cast<std::size_t>(row), line)) {
            const int before = depth;
            depth += crossing.direction;
            if (before <= 0 && depth > 0) entered = crossing.x;
            if (before > 0 && depth <= 0 && crossing.x > entered) inside.push_back({entered, crossing.x});
        }
        return inside;
    };
    using Row = std::vector<std::vector<Stretch>>;
    Row first_row, row_before(static_cast<std::size_t>(lines)), here(row_before);
    const auto is_whole_period = [&](int axis) {
        return lattice_.period[axis] > 0 && first_[axis] == 0 && last_[axis] == lattice_.period[axis];
    };
    for (int row = 0; row < layers; ++row) {
        for (int line = 0; line < lines; ++line) {
            here[line] = inside_of(row, line);
            const std::array<int, 2> box{first_[1] + line / lines_across, first_[2] + row / lines_across};
            const Vec middle = lattice_.middle({0, box[0], box[1]});
            add_line(box, Vec(0, rows[row].first_y + line * step_y - middle[1], rows[row].z - middle[2]), here[line]);
            if (line > 0 && line % lines_across == 0) join_boxes({box[0] - 1, box[1]}, 1, here[line - 1], here[line]);
            if (row > 0 && row % lines_across == 0) join_boxes({box[0], box[1] - 1}, 2, row_before[line], here[line]);
            if (row + 1 == layers && is_whole_period(2))
                join_boxes(box, 2, here[line], row == 0 ? here[line] : first_row[line]);
            if (line + 1 == lines && is_whole_period(1)) join_boxes(box, 1, here[line], here[0]);
            if (is_whole_period(0)) join_ends({box[0], box[1]}, here[line]);
        }
        if (row == 0) first_row = here;
        std::swap(row_before, here);
    }
}

std::size_t SolidOnBoxes::number(const std::array<int, 3>& box) const {
    return (static_cast<std::size_t>(box[2] - first_[2]) * (last_[1] - first_[1]) + (box[1] - first_[1])) *
               (last_[0] - first_[0]) +
           (box[0] - first_[0]);
}

/// `line`: where it is, from the middle of the box.
void SolidOnBoxes::add_line(const std::array<int, 2>& box, const Vec& line, const std::vector<Stretch>& inside) {
    for (const auto& [from, to] : inside)
        for (int i = first_[0]; i < last_[0]; ++i) {
            const double low = lattice_.corner({i, 0, 0})[0], high = low + lattice_.step[0], middle = (low + high) / 2;
            const double a = std::max(from, low) - middle, b = std::min(to, high) - middle;
            if (b <= a) continue;
            Sums& sums = sums_[number({i, box[0], box[1]})];
            sums.length += b - a;
            sums.first += Vec((b * b - a * a) / 2, line[1] * (b - a), line[2] * (b - a));
            sums.second += Vec((b * b * b - a * a * a) / 3, line[1] * line[1] * (b - a), line[2] * line[2] * (b - a));
            if (from < high && to > high) sums.joined[0] = true;
        }
}

/// Where stretches of neighbouring lines on both sides of a face overlap, there is solid on it.
void SolidOnBoxes::join_boxes(const std::array<int, 2>& box, int axis, const std::vector<Stretch>& last,
                              const std::vector<Stretch>& next) {
    for (const Stretch& one : last)
        for (const Stretch& other : next) {
            const double from = std::max(one.from, other.from), to = std::min(one.to, other.to);
            for (int i = first_[0]; i < last_[0]; ++i) {
                const double low = lattice_.corner({i, 0, 0})[0];
                if (std::max(from, low) < std::min(to, low + lattice_.step[0]))
                    sums_[number({i, box[0], box[1]})].joined[axis] = true;
            }
        }
}

/// Of a line through a whole period: where it is inside at both ends, the solid goes on through them.
void SolidOnBoxes::join_ends(const std::array<int, 2>& box, const std::vector<Stretch>& inside) {
    if (inside.empty()) return;
    const double a_little = 1e-6 * lattice_.step[0];
    const double low = lattice_.corner(first_)[0] + a_little, high = lattice_.corner(last_)[0] - a_little;
    if (inside.front().from < low && inside.back().to > high)
        sums_[number({last_[0] - 1, box[0], box[1]})].joined[0] = true;
}

Filling SolidOnBoxes::filling(const std::array<int, 3>& box) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (box[axis] < first_[axis] || box[axis] >= last_[axis]) return {};
    const Sums& sums = sums_[number(box)];
    // Of a solid that only touches the box there is no centroid.
    if (!(sums.length > 1e-9 * lines_across * lines_across * lattice_.step[0])) return {};
    const double across = lattice_.step[1] * lattice_.step[2] / (lines_across * lines_across);
    const Vec centroid = sums.first / sums.length;
    Vec moment = sums.second / sums.length - centroid.cwiseAbs2();
    for (const int axis : {1, 2}) {  // a line stands for a strip as wide as the lines are apart
        const double strip = lattice_.step[axis] / lines_across;
        moment[axis] += strip * strip / 12;
    }
    return {sums.length * across, lattice_.middle(box) + centroid, moment.cwiseMax(0.0)};
}

double SolidOnBoxes::volume() const {
    double length = 0;
    for (const Sums& sums : sums_) length += sums.length;
    return length * lattice_.step[1] * lattice_.step[2] / (lines_across * lines_across);
}

SolidCells SolidOnBoxes::cells() const {
    return solid_cells(lattice_, first_, last_,
                       {[this](const auto& box) { return filling(box); },
                        [this](const auto& box, int axis) { return sums_[number(box)].joined[axis]; }});
}

}  // namespace dmp::mesher
