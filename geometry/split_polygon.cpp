// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/split_polygon.hpp"

#include <Eigen/Geometry>
#include <numeric>

namespace dmp::geometry {

namespace {

/// Cuts ears off one polygon.
class EarCutter {
  public:
    explicit EarCutter(std::span<const Vec> corners)
        : corners_(corners), left_(corners.size()), searches_left_(tests_per_pair * corners.size() * corners.size()) {
        std::iota(left_.begin(), left_.end(), std::size_t{0});
        normal_ = Vec::Zero();
        for (std::size_t k = 0; k < corners.size(); ++k)
            normal_ += (corners[k] - corners[0]).cross(corners[(k + 1) % corners.size()] - corners[0]);
    }

    std::vector<std::array<std::size_t, 3>> cut() {
        std::vector<std::array<std::size_t, 3>> triangles;
        while (left_.size() > 3) {
            const std::size_t ear = best_ear();
            triangles.push_back(around(ear));
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        if (left_.size() == 3) triangles.push_back({left_[0], left_[1], left_[2]});
        return triangles;
    }

  private:
    /// How often corners are looked at, for each pair of them. A polygon that covers itself may have no ears at all.
    static constexpr std::size_t tests_per_pair = 8;

    /// The remaining corner `at` with the ones before and after it.
    [[nodiscard]] std::array<std::size_t, 3> around(std::size_t at) const {
        const std::size_t count = left_.size();
        return {left_[(at + count - 1) % count], left_[at], left_[(at + 1) % count]};
    }

    /// Twice the area that three corners span, seen along the normal; above 0: they turn as the polygon does.
    [[nodiscard]] double turn(std::size_t a, std::size_t b, std::size_t c) const {
        return (corners_[b] - corners_[a]).cross(corners_[c] - corners_[a]).dot(normal_);
    }

    [[nodiscard]] bool holds_another(const std::array<std::size_t, 3>& triangle) {
        const auto& [a, b, c] = triangle;
        for (const std::size_t other : left_) {
            --searches_left_;
            if (other == a || other == b || other == c) continue;
            if (turn(a, b, other) >= 0 && turn(b, c, other) >= 0 && turn(c, a, other) >= 0) return true;
        }
        return false;
    }

    /// The first ear; where rounding or a crossing leaves none, or the search takes too long, the corner that turns
    /// most.
    [[nodiscard]] std::size_t best_ear() {
        std::size_t most = 0;
        double most_turned = -1;
        for (std::size_t k = 0; k < left_.size(); ++k) {
            const auto triangle = around(k);
            const double turned = turn(triangle[0], triangle[1], triangle[2]);
            if (turned > most_turned) {
                most_turned = turned;
                most = k;
            }
            if (turned > 0 && searches_left_ > left_.size() && !holds_another(triangle)) return k;
        }
        return most;
    }

    std::span<const Vec> corners_;
    std::vector<std::size_t> left_;
    std::size_t searches_left_;
    Vec normal_;
};

}  // namespace

std::vector<std::array<std::size_t, 3>> split_polygon(std::span<const Vec> corners) {
    if (corners.size() < 3) return {};
    return EarCutter(corners).cut();
}

}  // namespace dmp::geometry
