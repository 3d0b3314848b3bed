// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/local_thickness.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "geometry/triangle_tree.hpp"

namespace dmp::geometry {

namespace {

/// The middles of the small triangles that a triangle is divided into, `parts` along each side.
template <class Visit>
void for_each_middle(const std::array<Vec, 3>& triangle, int parts, const Visit& visit) {
    const Vec first = (triangle[1] - triangle[0]) / parts, second = (triangle[2] - triangle[0]) / parts;
    for (int i = 0; i < parts; ++i)
        for (int j = 0; i + j < parts; ++j) {
            visit(triangle[0] + (i + 1.0 / 3) * first + (j + 1.0 / 3) * second);
            if (i + j + 1 < parts) visit(triangle[0] + (i + 2.0 / 3) * first + (j + 2.0 / 3) * second);
        }
}

}  // namespace

std::optional<ThicknessSample> LocalThickness::thinnest() const {
    const auto least = std::ranges::min_element(samples, {}, &ThicknessSample::thickness);
    if (least == samples.end()) return std::nullopt;
    return *least;
}

double LocalThickness::share_thinner(double limit) const {
    double thin = 0;
    for (const ThicknessSample& sample : samples)
        if (sample.thickness < limit) thin += sample.area;
    return area > 0 ? thin / area : 0;
}

LocalThickness local_thickness(const TriangleSurface& surface, double distance) {
    if (!(distance > 0)) throw std::invalid_argument("local_thickness: the distance of places must be positive");
    LocalThickness found;
    const TriangleTree tree(surface);
    std::vector<Vec> normals;
    for (const auto& [a, b, c] : surface.triangles) {
        const Vec& corner = surface.corners[static_cast<std::size_t>(a)];
        normals.push_back((surface.corners[static_cast<std::size_t>(b)] - corner)
                              .cross(surface.corners[static_cast<std::size_t>(c)] - corner));
    }
    // A ray inward from each of a triangle's places, to the first triangle that faces back.
    const auto sample = [&](std::size_t t, std::vector<ThicknessSample>& samples) {
        const double twice_area = normals[t].norm();
        if (!(twice_area > 0)) return;
        std::array<Vec, 3> triangle;
        double longest = 0;
        for (std::size_t k = 0; k < 3; ++k)
            triangle.at(k) = surface.corners[static_cast<std::size_t>(surface.triangles[t].at(k))];
        for (std::size_t k = 0; k < 3; ++k)
            longest = std::max(longest, (triangle.at((k + 1) % 3) - triangle.at(k)).norm());
        const int parts = static_cast<int>(std::clamp(std::ceil(longest / distance), 1.0, 32.0));
        const Vec inward = -normals[t] / twice_area;
        const auto is_opposite = [&](int other) {
            const Vec& normal = normals[static_cast<std::size_t>(other)];
            return normal.dot(inward) >= std::numbers::sqrt2 / 2 * normal.norm();
        };
        for_each_middle(triangle, parts, [&](const Vec& position) {
            const auto hit = tree.first_hit(position, inward, is_opposite);
            if (!hit) return;
            const Vec& facing = normals[static_cast<std::size_t>(hit->triangle)];
            const double slant = facing.cross(inward).norm() / facing.dot(inward);
            samples.push_back({position, position + hit->distance * inward, hit->distance,
                               0.5 * twice_area / (parts * parts), slant});
        });
    };
    const auto triangles = static_cast<std::ptrdiff_t>(normals.size());
    constexpr std::ptrdiff_t together = 256;
    const std::ptrdiff_t shares = (triangles + together - 1) / together;
    std::vector<std::vector<ThicknessSample>> samples(static_cast<std::size_t>(shares));
#pragma omp parallel for schedule(dynamic)
    for (std::ptrdiff_t share = 0; share < shares; ++share)
        for (std::ptrdiff_t t = share * together; t < std::min(triangles, (share + 1) * together); ++t)
            sample(static_cast<std::size_t>(t), samples[static_cast<std::size_t>(share)]);
    for (const Vec& normal : normals) found.area += 0.5 * normal.norm();
    for (const auto& some : samples)  // in the triangles' order, whoever looked at them
        found.samples.insert(found.samples.end(), some.begin(), some.end());
    return found;
}

}  // namespace dmp::geometry
