// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "models/sph/kernels.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::kernel_identities_tests {
namespace {

/// Sums over a square lattice of spacing 1 around the particle at its origin, V = 1.
template <class Kernel>
class LatticeSums {
  public:
    explicit LatticeSums(double support) : kernel_(support), support_(support) {}

    /// Sum of f(x, y, r) over all lattice points nearer than the support.
    template <class F>
    [[nodiscard]] double over_points(const F& f) const {
        double sum = 0;
        const int reach = static_cast<int>(std::ceil(support_));
        for (int x = -reach; x <= reach; ++x)
            for (int y = -reach; y <= reach; ++y)
                if (const double r = std::hypot(x, y); r < support_) sum += f(x, y, r);
        return sum;
    }

    [[nodiscard]] int points() const {
        return static_cast<int>(over_points([](int, int, double) { return 1; }));
    }
    [[nodiscard]] double sum() const {
        return over_points([&](int, int, double r) { return kernel_.value(r); });
    }
    [[nodiscard]] double half_moment() const {
        return over_points([&](int, int, double r) { return -0.5 * r * r * kernel_.slope(r); });
    }
    /// SUM 2 V F (f_i - f_j) for f = y^2/2 (Morris, Fox, Zhu 1997, eq. 22).
    [[nodiscard]] double laplacian() const {
        return over_points([&](int, int y, double r) { return -y * y * kernel_.slope(r); });
    }
    /// 8 SUM V (v_ij.r_ij)/r^2 F x_ij for v = (y^2/2, 0) (Monaghan 1992).
    [[nodiscard]] double shear() const {
        return over_points(
            [&](int x, int y, double r) { return r > 0 ? -4 * kernel_.slope(r) * square(x * y / r) : 0.0; });
    }
    /// The same for v = (x^2/2, 0).
    [[nodiscard]] double longitudinal() const {
        return over_points(
            [&](int x, int, double r) { return r > 0 ? -4 * kernel_.slope(r) * square(x * x / r) : 0.0; });
    }
    /// Of Morris' Laplacian, over waves of the Brillouin zone.
    [[nodiscard]] double largest_eigenvalue() const {
        constexpr int waves = 100;
        double largest = 0;
        for (int i = 0; i <= waves; ++i)
            for (int j = 0; j <= waves; ++j)
                largest = std::max(largest, over_points([&](int x, int y, double r) {
                                       const double phase = std::numbers::pi * (i * x + j * y) / waves;
                                       return -2 * kernel_.slope(r) * (1 - std::cos(phase));
                                   }));
        return largest;
    }

  private:
    Kernel kernel_;
    double support_;
};

std::vector<std::vector<double>> rows_of(const std::string& file) {
    std::ifstream stream(file);
    std::vector<std::vector<double>> rows;
    bool past_header = false;
    for (std::string line; std::getline(stream, line);) {
        if (line.empty() || line.front() == '#') continue;
        if (past_header) {
            std::istringstream cells(line);
            rows.emplace_back();
            for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
        }
        past_header = true;
    }
    return rows;
}

TEST(KernelIdentities, OfLucyOnASquareLattice) {
    const auto rows = rows_of(DMP_SOURCE_DIR "/tests/data/kernel_identities.csv");
    ASSERT_EQ(rows.size(), 4U);
    for (const auto& row : rows) {
        ASSERT_EQ(row.size(), 9U);
        SCOPED_TRACE("support " + std::to_string(row[0]));
        const LatticeSums<Lucy<2>> lattice(row[0]);
        EXPECT_EQ(lattice.points(), row[1]);
        EXPECT_NEAR(lattice.sum(), row[2], 1e-5);
        EXPECT_NEAR(lattice.half_moment(), row[3], 1e-5);
        EXPECT_NEAR(lattice.laplacian(), row[4], 1e-5);
        EXPECT_NEAR(lattice.shear(), row[5], 1e-4);  // four digits in the table
        EXPECT_NEAR(lattice.longitudinal(), row[6], 1e-4);
        EXPECT_NEAR(lattice.largest_eigenvalue(), row[7], 1e-4);
        EXPECT_NEAR(2 / lattice.largest_eigenvalue(), row[8], 1e-4);
    }
}

// From the expanded polynomial 1 - 10 q^2 + 20 q^3 - 15 q^4 + 4 q^5 and its numerical derivative, in 30 digits; the
// first sum also by Poisson summation of the Hankel transform (1.005142, 600 waves).
TEST(KernelIdentities, OfWendlandC2OnASquareLattice) {
    const LatticeSums<WendlandC2<2>> lattice(3.0);
    EXPECT_EQ(lattice.points(), 25);
    EXPECT_NEAR(lattice.sum(), 1.00514234077735619, 1e-13);
    EXPECT_NEAR(lattice.half_moment(), 0.99739926844389515, 1e-13);
    EXPECT_NEAR(lattice.laplacian(), 0.99739926844389515, 1e-13);
    EXPECT_NEAR(lattice.shear(), 0.88591246758018607, 1e-13);
    EXPECT_NEAR(lattice.longitudinal(), 3.10368460619539455, 1e-13);
}

// Worked out apart from the code, from each piece's expanded polynomial and its derivative.
struct Identities {
    double sum, half_moment, shear, longitudinal;
};

template <class Kernel>
void expect_identities(const Identities& expected) {
    const LatticeSums<Kernel> lattice(3.0);
    EXPECT_EQ(lattice.points(), 25);
    EXPECT_NEAR(lattice.sum(), expected.sum, 1e-13);
    EXPECT_NEAR(lattice.half_moment(), expected.half_moment, 1e-13);
    EXPECT_NEAR(lattice.laplacian(), expected.half_moment, 1e-13);
    EXPECT_NEAR(lattice.shear(), expected.shear, 1e-13);
    EXPECT_NEAR(lattice.longitudinal(), expected.longitudinal, 1e-12);
}

TEST(KernelIdentities, OfWendlandC4AndTheSplinesOnASquareLattice) {
    expect_identities<WendlandC4<2>>({1.0029796915554106, 0.9905770261932999, 0.81731422103626417, 3.1449938837369369});
    expect_identities<CubicSpline<2>>(
        {1.0034403964801619, 1.0067245147528718, 0.94643113772770093, 3.0804669212837856});
    expect_identities<QuinticSpline<2>>(
        {1.0000632245946193, 1.0007954430582375, 0.83172533929515657, 3.1714564329377919});
}

TEST(KernelIdentities, ConvergeToTheContinuum) {
    const LatticeSums<WendlandC2<2>> wendland(40.5);
    EXPECT_NEAR(wendland.sum(), 1, 1e-6);
    EXPECT_NEAR(wendland.half_moment(), 1, 1e-6);
    EXPECT_NEAR(wendland.longitudinal(), 3, 1e-2);
    const LatticeSums<Lucy<2>> lucy(40.5);
    EXPECT_NEAR(lucy.sum(), 1, 1e-5);
    EXPECT_NEAR(lucy.half_moment(), 1, 1e-4);
    EXPECT_NEAR(lucy.shear(), 1, 1e-2);
    const LatticeSums<CubicSpline<2>> cubic(40.5);
    EXPECT_NEAR(cubic.sum(), 1, 1e-5);
    EXPECT_NEAR(cubic.half_moment(), 1, 1e-4);
    const LatticeSums<QuinticSpline<2>> quintic(40.5);
    EXPECT_NEAR(quintic.sum(), 1, 1e-6);
    EXPECT_NEAR(quintic.longitudinal(), 3, 1e-2);
    const LatticeSums<WendlandC4<2>> smooth(40.5);
    EXPECT_NEAR(smooth.sum(), 1, 1e-6);
    EXPECT_NEAR(smooth.shear(), 1, 1e-2);
}

}  // namespace
}  // namespace dmp::tests::kernel_identities_tests
