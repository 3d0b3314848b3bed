// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/spheres/sphere_rows.hpp"

namespace dmp::solver {

/// Two rows that are near each other; `finder` decides whose thread works on the pair.
struct NearSpheres {
    std::int32_t finder = 0, other = 0;
};

/// Finds spheres whose surfaces are near each other, of any sizes. A grid for each class of sizes (largest to smallest
/// radius with skin 2:1), with cells that fit it; a sphere looks into its own class and those of larger spheres. So
/// small ones never search as far as a large one reaches among themselves, and a large one does not look at all.
/// (Hierarchical grid: Ogarko & Luding 2012.)
class SphereSearch {
  public:
    /// Surfaces less than `gap` and both spheres' skins apart are near [m]; skins by row.
    SphereSearch(const SphereRows& rows, double gap, std::span<const float> skins);

    /// Appends each pair that one of the rows [begin, end) finds; rows are owned or copies. Over all rows every pair
    /// with an owned sphere in it is found once.
    void append_near(std::int32_t begin, std::int32_t end, std::vector<NearSpheres>& found) const;

  private:
    struct Grid {
        double cell = 0, inverse_cell = 0, largest_radius = 0;
        std::array<double, 3> low{};
        std::array<std::int64_t, 3> cells{1, 1, 1};
        std::vector<std::int32_t> start;              ///< first entry of each cell, x fastest
        std::vector<std::int32_t> row;                ///< by entry
        std::array<std::vector<double>, 4> position;  ///< x, y, z, radius with skin by entry

        void fill(const SphereRows& rows, std::span<const float> skins, const std::vector<std::int32_t>& members,
                  double gap);
        using Cell = std::array<std::int64_t, 3>;
        [[nodiscard]] std::int64_t at(int axis, double x) const;
        [[nodiscard]] Cell cell_at(const double* x, double shift) const;
        [[nodiscard]] std::size_t number_of(std::int64_t x, std::int64_t y, std::int64_t z) const {
            return static_cast<std::size_t>((z * cells[1] + y) * cells[0] + x);
        }
        /// Calls keep(row) for members whose surface with skin is less than `around` from the sphere's centre.
        template <class Keep>
        void for_each_near(const SphereMotion& sphere, double around, std::vector<std::int32_t>& scratch,
                           const Keep& keep) const;
        /// The same for a member, so that of each two members one is kept for the other.
        template <class Keep>
        void for_each_near_behind(std::int32_t member, const SphereMotion& sphere, double around,
                                  std::vector<std::int32_t>& scratch, const Keep& keep) const;
        /// The entries [begin, end) among them.
        [[nodiscard]] std::size_t find_near(std::int32_t begin, std::int32_t end, const SphereMotion& sphere,
                                            double around, std::vector<std::int32_t>& scratch) const;
    };

    const SphereRows& rows_;
    double gap_;
    std::span<const float> skins_;
    std::vector<std::uint8_t> class_of_;
    std::vector<Grid> grids_;  ///< from the smallest class on
};

}  // namespace dmp::solver
