// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/facing_part.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace dmp::mesher {

namespace {

using Corners = std::array<Vec, 3>;

class Cutter {
  public:
    Cutter(double distance, const std::function<bool(const Vec&, const Vec&)>& counts, TriangleSurface& out)
        : distance_(distance), counts_(counts), out_(out) {}

    /// Adds what counts of a triangle, or a piece of one; returns whether all of it does.
    bool add(const Corners& corners, const Vec& normal, bool has_geometry = true) {
        std::size_t longest = 0;
        for (const std::size_t k : {1U, 2U})
            if (length(corners, k) > length(corners, longest)) longest = k;
        if (has_geometry && length(corners, longest) <= finest * distance_) {  // there is nothing to cut
            const bool counted = counts_((corners[0] + corners[1] + corners[2]) / 3, normal);
            if (counted) put(corners);
            return counted;
        }
        if (length(corners, longest) <= distance_) {
            const int here = relevant_positions(corners, normal);
            if (here == positions) put(corners);
            if (here == positions || here == 0 || length(corners, longest) <= finest * distance_)
                return here == positions;
        }
        const std::size_t before = out_.triangles.size();
        const Vec middle = 0.5 * (corners.at(longest) + corners.at((longest + 1) % 3));
        Corners first = corners, second = corners;
        first.at((longest + 1) % 3) = middle;
        second.at(longest) = middle;
        const bool first_whole = add(first, normal, false), second_whole = add(second, normal, false);
        if (!first_whole || !second_whole) return false;
        out_.triangles.resize(before);
        out_.corners.resize(3 * before);
        put(corners);
        return true;
    }

  private:
    static constexpr int positions = 4;
    static constexpr double finest = 0.25;

    /// Of its middle and places next to its corners.
    [[nodiscard]] int relevant_positions(const Corners& corners, const Vec& normal) const {
        const Vec middle = (corners[0] + corners[1] + corners[2]) / 3;
        int count = counts_(middle, normal) ? 1 : 0;
        for (const Vec& corner : corners) count += counts_(0.9 * corner + 0.1 * middle, normal) ? 1 : 0;
        return count;
    }
    static double length(const Corners& corners, std::size_t side) {
        return (corners.at((side + 1) % 3) - corners.at(side)).norm();
    }
    void put(const Corners& corners) {
        const auto first = static_cast<int>(out_.corners.size());
        out_.corners.insert(out_.corners.end(), corners.begin(), corners.end());
        out_.triangles.push_back({first, first + 1, first + 2});
    }

    double distance_;
    const std::function<bool(const Vec&, const Vec&)>& counts_;
    TriangleSurface& out_;
};

}  // namespace

TriangleSurface facing_part(const TriangleSurface& surface, double distance,
                            const std::function<bool(const Vec& position, const Vec& normal)>& counts) {
    const auto triangles = static_cast<std::ptrdiff_t>(surface.triangles.size());
    constexpr std::ptrdiff_t together = 256;
    const std::ptrdiff_t shares = (triangles + together - 1) / together;
    std::vector<TriangleSurface> parts(static_cast<std::size_t>(shares));
#pragma omp parallel for schedule(dynamic)
    for (std::ptrdiff_t share = 0; share < shares; ++share) {
        Cutter cutter(distance, counts, parts[static_cast<std::size_t>(share)]);
        const std::ptrdiff_t end = std::min(triangles, (share + 1) * together);
        for (std::ptrdiff_t t = share * together; t < end; ++t) {
            const auto& [a, b, c] = surface.triangles[static_cast<std::size_t>(t)];
            const auto corner = [&](int k) -> const Vec& { return surface.corners[static_cast<std::size_t>(k)]; };
            const Vec across = (corner(b) - corner(a)).cross(corner(c) - corner(a));
            if (across.norm() > 0) cutter.add({corner(a), corner(b), corner(c)}, across.normalized());
        }
    }
    TriangleSurface whole;  // in the triangles' order, whoever looked at them
    for (const TriangleSurface& part : parts) {
        const auto first = static_cast<int>(whole.corners.size());
        whole.corners.insert(whole.corners.end(), part.corners.begin(), part.corners.end());
        for (const auto& [a, b, c] : part.triangles) whole.triangles.push_back({first + a, first + b, first + c});
    }
    return whole;
}

}  // namespace dmp::mesher
