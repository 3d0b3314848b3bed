// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Solids of bonds between all that is near: what they are as a material, which bonds they have, where they are refused.
#include "mesher/bond_network.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <set>

#include <gmock/gmock.h>

#include "meshed_text.hpp"

namespace dmp {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing_mesh::channel;
using testing_mesh::fault_of;
using testing_mesh::mesh_texts;
using testing_mesh::Texts;

std::vector<Bond> bonds_of(const std::vector<Vec>& place, double within) {
    std::vector<Bond> bonds;
    for (int i = 0; i < static_cast<int>(place.size()); ++i)
        for (int j = i + 1; j < static_cast<int>(place.size()); ++j)
            if (const double apart = (place[i] - place[j]).norm(); apart < within) bonds.push_back({i, j, apart, 0});
    return bonds;
}

/// SUM k (r n.e.n)^2: what a small uniform strain costs.
double energy(const std::vector<Bond>& bonds, const std::vector<Vec>& place, const Eigen::Matrix3d& strain) {
    double sum = 0;
    for (const Bond& bond : bonds) {
        const Vec apart = place[bond.b] - place[bond.a];
        sum += bond.stiffness * std::pow(apart.dot(strain * apart) / apart.norm(), 2);
    }
    return sum;
}

/// Of a material with nu = 1/4, for each volume.
double energy(double modulus, const Eigen::Matrix3d& strain) {
    const double lame = modulus / 2.5;
    return lame * (0.5 * std::pow(strain.trace(), 2) + (strain * strain).trace());
}

Eigen::Matrix3d strain(double xx, double yy, double zz, double xy, double yz, double xz) {
    Eigen::Matrix3d all;
    all << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return all;
}

TEST(BondNetwork, of_a_hexagon_is_its_material_in_every_strain) {
    std::vector<Vec> place;
    constexpr int rings = 6;
    for (int j = -rings; j <= rings; ++j)
        for (int i = -rings; i <= rings; ++i)
            if (std::abs(i + j) <= rings) place.emplace_back(i + 0.5 * j, std::sqrt(0.75) * j, 0);
    for (const double within : {1.1, 1.8, 2.1}) {
        auto bonds = bonds_of(place, within);
        constexpr double modulus = 3e5, area = 117;
        const NetworkConstants constants = set_stiffness(bonds, place, modulus, area, 2);
        EXPECT_EQ(constants.exponent, 0);
        EXPECT_LT(constants.anisotropy, 1e-7);
        EXPECT_EQ(constants.softest, constants.stiffest);
        for (const auto& e : {strain(1, 0, 0, 0, 0, 0), strain(0.3, -0.7, 0, 0.4, 0, 0), strain(0, 0, 0, 1, 0, 0)})
            EXPECT_NEAR(energy(bonds, place, e) / (area * energy(modulus, e)), 1, 1e-12) << within;
    }
}

TEST(BondNetwork, of_a_square_lattice_weakens_its_diagonals_until_it_is_isotropic) {
    constexpr int side = 12;
    std::vector<Vec> place;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) place.emplace_back(i, j, 0);
    auto bonds = bonds_of(place, 1.5);
    constexpr double modulus = 2e4, area = side * side;
    const NetworkConstants constants = set_stiffness(bonds, place, modulus, area, 2);
    // 2 side (side - 1) edges and 2 (side - 1)^2 diagonals: k_2 / k_1 = side / (2 (side - 1)) = 2^(-p/2).
    EXPECT_NEAR(constants.exponent, 2 - 2 * std::log2(side / (side - 1.0)), 1e-6);
    EXPECT_LT(constants.anisotropy, 1e-6);
    for (const auto& e : {strain(1, 0, 0, 0, 0, 0), strain(0.3, -0.7, 0, 0.4, 0, 0)})
        EXPECT_NEAR(energy(bonds, place, e) / (area * energy(modulus, e)), 1, 1e-6);
}

TEST(BondNetwork, of_a_cube_with_edges_and_diagonals_needs_no_such_thing) {
    constexpr int side = 9;
    std::vector<Vec> place;
    for (int k = 0; k < side; ++k)
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) place.emplace_back(i, j, k);
    auto bonds = bonds_of(place, 1.5);
    constexpr double modulus = 2e4, volume = side * side * side;
    const NetworkConstants constants = set_stiffness(bonds, place, modulus, volume, 3);
    EXPECT_EQ(constants.exponent, 0);
    EXPECT_LT(constants.anisotropy, 0.02);
    for (const auto& e : {strain(1, 1, 1, 0, 0, 0), strain(1, -0.5, -0.5, 0.4, 0.2, 0.1)})
        EXPECT_NEAR(energy(bonds, place, e) / (volume * energy(modulus, e)), 1, 0.02);
    // Nearest neighbours alone resist no shear, whatever their stiffness: it is said.
    auto edges = bonds_of(place, 1.2);
    EXPECT_GT(set_stiffness(edges, place, modulus, volume, 3).anisotropy, 0.5);
}

/// The channel with a block of 0.5 m x 1 m on its bottom, clamped there, drawn over the water.
Texts block(const std::string& arrangement, const std::string& fill, const std::string& within = "0.21 m") {
    Texts texts{channel.scene +
                    "[[part]]\nname = \"block\"\nkind = \"springs\"\ndensity = \"1200 kg/m^3\"\n"
                    "youngs_modulus = \"1 MPa\"\nanchor = \"wall\"\nbonds_within = \"" +
                    within + "\"\n",
                channel.drawing + R"(Point(10) = {1.75, 0, 0};
Point(11) = {2.25, 0, 0};
Point(12) = {2.25, 1, 0};
Point(13) = {1.75, 1, 0};
Line(10) = {10, 11};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 10};
Curve Loop(2) = {10, 11, 12, 13};
Plane Surface(2) = {2};
Physical Surface("block") = {2};
)"};
    return texts.with("spacing = \"0.125 m\"",
                      "spacing = \"0.0625 m\"\narrangement = \"" + arrangement + "\"\nfill = \"" + fill + "\"");
}

class BondedSolid : public ::testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(BondedSolid, has_all_its_bonds_and_keeps_to_its_area) {
    const auto [arrangement, fill] = GetParam();
    const auto meshed = mesh_texts(block(arrangement, fill, "0.11 m"));
    const ParticleSet& set = meshed.particles;
    const auto& line = meshed.report.springs.at(0);
    ASSERT_TRUE(line.network);
    EXPECT_EQ(line.bodies, 1);
    EXPECT_EQ(line.pieces, 1);
    EXPECT_GT(line.anchored, 6U);
    std::set<std::pair<int, int>> bonded;
    for (const Bond& bond : set.bonds) EXPECT_TRUE(bonded.emplace(std::minmax(bond.a, bond.b)).second);
    std::size_t near = 0, nodes = 0;
    double lowest = 1, highest = 0, left = 4, right = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != ParticleKind::springs) continue;
        ++nodes;
        EXPECT_EQ(set.body[i], 0);
        lowest = std::min(lowest, set.position[i].y());
        highest = std::max(highest, set.position[i].y());
        left = std::min(left, set.position[i].x());
        right = std::max(right, set.position[i].x());
        for (std::size_t j = i + 1; j < set.size(); ++j)
            if (set.kind(j) == ParticleKind::springs && (set.position[i] - set.position[j]).norm() < 0.11) ++near;
    }
    EXPECT_EQ(bonded.size(), near);
    EXPECT_NEAR(static_cast<double>(nodes) / 128, 1, 0.04);
    const double off = *meshed.scene.particles.fill == FillKind::lattice ? 0.3 : 0.08;  // [spacings]
    for (const double distance : {lowest, 1 - highest, left - 1.75, 2.25 - right})
        EXPECT_NEAR(distance / 0.0625, 0.5, off);
    for (std::size_t i = 0; i < set.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) ASSERT_GT((set.position[i] - set.position[j]).norm(), 0.7 * 0.0625);
    EXPECT_THAT(meshed.report.text(), HasSubstr("give E = 1e+06 Pa, nu = 0.25 in an even strain"));
}

INSTANTIATE_TEST_SUITE_P(InThePlane, BondedSolid,
                         ::testing::Combine(::testing::Values("square", "hexagonal"),
                                            ::testing::Values("lattice", "relaxed", "sampled")),
                         [](const auto& of) {
                             return std::string(std::get<0>(of.param)) + "_" + std::get<1>(of.param);
                         });

TEST(BondedSolids, have_no_bonds_across_a_slit) {
    // A slit from above, a hundredth of a spacing wide, between two columns.
    const Texts slit =
        block("square", "lattice", "0.1 m")
            .with("Point(13)",
                  "Point(14) = {1.9997, 1, 0};\nPoint(15) = {1.9997, 0.5, 0};\nPoint(16) = "
                  "{2.0003, 0.5, 0};\nPoint(17) = {2.0003, 1, 0};\nPoint(13)")
            .with("Line(12) = {12, 13};",
                  "Line(12) = {12, 17};\nLine(14) = {17, 16};\nLine(15) = {16, "
                  "15};\nLine(16) = {15, 14};\nLine(17) = {14, 13};")
            .with("{10, 11, 12, 13};\nPlane Surface(2)", "{10, 11, 12, 14, 15, 16, 17, 13};\nPlane Surface(2)");
    const auto meshed = mesh_texts(slit);
    std::size_t across = 0;
    for (const Bond& bond : meshed.particles.bonds) {
        const Vec &a = meshed.particles.position[bond.a], &b = meshed.particles.position[bond.b];
        if ((a.x() < 2) == (b.x() < 2)) continue;
        ++across;
        EXPECT_LT(std::min(a.y(), b.y()), 0.5);
    }
    // Eight rows below the slit; a diagonal from the last of them crosses its end.
    EXPECT_EQ(across, 8U + 2 * 7);
}

TEST(BondedSolids, whose_particles_are_too_far_apart_are_refused) {
    EXPECT_THAT(fault_of(block("square", "lattice", "0.05 m")),
                AllOf(HasSubstr("a particle of 'block' at"), HasSubstr("has no other within 50 mm, bonds_within"),
                      HasSubstr("write 1.2 to 2 spacings")));
}

}  // namespace
}  // namespace dmp
