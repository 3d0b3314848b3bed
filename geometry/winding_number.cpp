// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/winding_number.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace dmp::geometry {

double solid_angle(const Vec& point, const std::array<Vec, 3>& triangle) {
    const Vec a = triangle[0] - point, b = triangle[1] - point, c = triangle[2] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double volume = a.dot(b.cross(c));
    const double sum = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    return 2 * std::atan2(volume, sum);
}

double winding_number(const TriangleSurface& surface, const Vec& point) {
    double sum = 0;
    for (const auto& [a, b, c] : surface.triangles)
        sum += solid_angle(point,
                           {surface.corners[static_cast<std::size_t>(a)], surface.corners[static_cast<std::size_t>(b)],
                            surface.corners[static_cast<std::size_t>(c)]});
    return sum / (4 * std::numbers::pi);
}

WindingNumber::WindingNumber(const TriangleSurface& surface, double farness)
    : tree_(surface), dipoles_(tree_.nodes().size()) {
    std::vector<double> areas(dipoles_.size(), 0);
    // Children stand behind their parents.
    for (std::size_t number = dipoles_.size(); number-- > 0;) {
        const TriangleTree::Node& node = tree_.nodes()[number];
        Dipole& dipole = dipoles_[number];
        const auto add = [&](const Vec& moment, const Vec& position, double area) {
            dipole.moment += moment;
            dipole.position += area * position;
            areas[number] += area;
        };
        if (node.second != 0) {
            for (const std::size_t child : {number + 1, static_cast<std::size_t>(node.second)})
                add(dipoles_[child].moment, dipoles_[child].position, areas[child]);
        } else {
            for (std::int32_t k = node.first; k < node.first + node.count; ++k) {
                const auto& [a, b, c] = tree_.at(static_cast<std::size_t>(k));
                const Vec moment = 0.5 * (b - a).cross(c - a);
                add(moment, (a + b + c) / 3, moment.norm());
            }
        }
        if (areas[number] > 0)
            dipole.position /= areas[number];
        else
            dipole.position = 0.5 * (node.box.low + node.box.high);
        const Vec farthest = (dipole.position - node.box.low).cwiseMax(node.box.high - dipole.position);
        dipole.reach = farness * farness * farthest.squaredNorm();
    }
}

double WindingNumber::at(const Vec& point) const {
    std::array<std::int32_t, 64> waiting;  // deeper than any tree of halves
    std::size_t count = 0;
    if (!dipoles_.empty()) waiting[count++] = 0;
    double sum = 0;
    while (count > 0) {
        const std::int32_t number = waiting[--count];
        const Dipole& dipole = dipoles_[static_cast<std::size_t>(number)];
        const Vec separation = dipole.position - point;
        const double square = separation.squaredNorm();
        if (square > dipole.reach) {
            sum += dipole.moment.dot(separation) / (square * std::sqrt(square));
            continue;
        }
        const TriangleTree::Node& node = tree_.nodes()[static_cast<std::size_t>(number)];
        if (node.second != 0) {
            waiting[count++] = node.second;
            waiting[count++] = number + 1;
            continue;
        }
        for (std::int32_t k = node.first; k < node.first + node.count; ++k)
            sum += solid_angle(point, tree_.at(static_cast<std::size_t>(k)));
    }
    return sum / (4 * std::numbers::pi);
}

}  // namespace dmp::geometry
