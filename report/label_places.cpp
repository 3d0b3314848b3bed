// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/label_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace dmp::report {

namespace {

struct Candidate {
    PictureBox box;
    double penalty = 0;  ///< of the place itself [px^2]
};

/// Around a mark, the best ones first.
std::vector<Candidate> candidates(const PictureBox& mark, double width, double height) {
    struct Side {
        double x, y;  ///< where the label's centre is of the mark's, in halves of both sizes
        double penalty;
    };
    constexpr std::array<Side, 8> sides{
        {{1, 0, 0}, {0, -1, 1}, {-1, 0, 2}, {0, 1, 2}, {1, -1, 3}, {1, 1, 3}, {-1, -1, 4}, {-1, 1, 4}}};
    constexpr double gap = 1;
    std::vector<Candidate> all;
    for (const double away : {0.0, 8.0, 18.0, 30.0})
        for (const Side& side : sides) {
            const double reach_x = (mark.right - mark.left + width) / 2 + gap + away;
            const double reach_y = (mark.bottom - mark.top + height) / 2 + away;
            // Diagonal ones touch the mark's corner.
            const double part = side.x != 0 && side.y != 0 ? 0.85 : 1;
            const double x = mark.centre().x + side.x * part * reach_x, y = mark.centre().y + side.y * part * reach_y;
            all.push_back({{x - width / 2, y - height / 2, x + width / 2, y + height / 2}, side.penalty + 1.5 * away});
        }
    return all;
}

/// Small boxes along the line.
std::vector<PictureBox> along(const std::vector<PicturePoint>& line) {
    constexpr double step = 4;
    std::vector<PictureBox> boxes;
    for (std::size_t k = 1; k < line.size(); ++k) {
        const PicturePoint a = line[k - 1], b = line[k];
        const int pieces = std::max(1, static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / step));
        for (int i = 0; i <= pieces; ++i) {
            const double part = static_cast<double>(i) / pieces;
            const double x = a.x + part * (b.x - a.x), y = a.y + part * (b.y - a.y);
            boxes.push_back({x - step / 2, y - step / 2, x + step / 2, y + step / 2});
        }
    }
    return boxes;
}

double area_shared_with(const std::vector<PictureBox>& others, const PictureBox& box) {
    double sum = 0;
    for (const PictureBox& other : others) sum += shared_area(box, other);
    return sum;
}

}  // namespace

double shared_area(const PictureBox& a, const PictureBox& b) {
    return std::max(0.0, std::min(a.right, b.right) - std::max(a.left, b.left)) *
           std::max(0.0, std::min(a.bottom, b.bottom) - std::max(a.top, b.top));
}

std::vector<PictureBox> label_places(const LabelObstacles& obstacles, const std::vector<double>& widths,
                                     double height) {
    constexpr int passes = 4;  // the first one does not know the later labels
    constexpr double of_mark = 4, of_label = 3, of_line = 0.5, of_outside = 100;
    const std::vector<PictureBox> line = along(obstacles.line);
    std::vector<PictureBox> places;
    for (int pass = 0; pass < passes; ++pass)
        for (std::size_t k = 0; k < widths.size(); ++k) {
            double least = std::numeric_limits<double>::infinity();
            PictureBox best;
            for (const Candidate& each : candidates(obstacles.marks[k], widths[k], height)) {
                double penalty = each.penalty + of_mark * area_shared_with(obstacles.marks, each.box) +
                                 of_line * area_shared_with(line, each.box) +
                                 of_outside * (widths[k] * height - shared_area(each.box, obstacles.frame));
                for (std::size_t other = 0; other < places.size(); ++other)
                    if (other != k) penalty += of_label * shared_area(each.box, places[other]);
                if (penalty < least) {
                    least = penalty;
                    best = each.box;
                }
            }
            if (pass == 0)
                places.push_back(best);
            else
                places[k] = best;
        }
    return places;
}

}  // namespace dmp::report
