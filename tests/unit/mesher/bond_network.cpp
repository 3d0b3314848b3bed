// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Solids of bonds between all that is near: what they are as a material, which bonds they have, where they are refused.
#include "mesher/bond_network.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <set>

#include <gmock/gmock.h>

#include "meshed_text.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::bond_network_tests {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::vector<Bond> bonds_of(const std::vector<Vec>& position, double within) {
    std::vector<Bond> bonds;
    for (int i = 0; i < static_cast<int>(position.size()); ++i)
        for (int j = i + 1; j < static_cast<int>(position.size()); ++j)
            if (const double apart = (position[i] - position[j]).norm(); apart < within)
                bonds.push_back({i, j, apart, 0});
    return bonds;
}

/// SUM k (r n.e.n)^2: what a small uniform strain costs.
double energy(const std::vector<Bond>& bonds, const std::vector<Vec>& position, const Eigen::Matrix3d& strain) {
    double sum = 0;
    for (const Bond& bond : bonds) {
        const Vec apart = position[bond.b] - position[bond.a];
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
    std::vector<Vec> position;
    constexpr int rings = 6;
    for (int j = -rings; j <= rings; ++j)
        for (int i = -rings; i <= rings; ++i)
            if (std::abs(i + j) <= rings) position.emplace_back(i + 0.5 * j, std::sqrt(0.75) * j, 0);
    for (const double within : {1.1, 1.8, 2.1}) {
        auto bonds = bonds_of(position, within);
        constexpr double modulus = 3e5, area = 117;
        const NetworkConstants constants = set_stiffness(bonds, position, modulus, area, 2);
        EXPECT_LT(constants.anisotropy, 1e-12);
        EXPECT_NEAR(constants.softest / constants.stiffest, 1, 1e-12);
        for (const auto& e : {strain(1, 0, 0, 0, 0, 0), strain(0.3, -0.7, 0, 0.4, 0, 0), strain(0, 0, 0, 1, 0, 0)})
            EXPECT_NEAR(energy(bonds, position, e) / (area * energy(modulus, e)), 1, 1e-12) << within;
    }
}

TEST(BondNetwork, of_a_square_lattice_weakens_its_diagonals_until_it_is_isotropic) {
    constexpr int side = 12;
    std::vector<Vec> position;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) position.emplace_back(i, j, 0);
    auto bonds = bonds_of(position, 1.5);
    constexpr double modulus = 2e4, area = side * side;
    const NetworkConstants constants = set_stiffness(bonds, position, modulus, area, 2);
    // 2 side (side - 1) edges and 2 (side - 1)^2 diagonals: those are half as stiff, and a little more for being fewer.
    EXPECT_NEAR(constants.softest / constants.stiffest, side / (2 * (side - 1.0)), 1e-12);
    EXPECT_LT(constants.anisotropy, 1e-12);
    for (const auto& e : {strain(1, 0, 0, 0, 0, 0), strain(0.3, -0.7, 0, 0.4, 0, 0)})
        EXPECT_NEAR(energy(bonds, position, e) / (area * energy(modulus, e)), 1, 1e-6);
}

TEST(BondNetwork, of_bonds_at_random_is_isotropic_as_a_whole) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> along(0, 1);
    for (const int dimension : {2, 3}) {
        std::vector<Vec> position(400);
        for (Vec& at : position) at = Vec(along(random), 0.3 * along(random), dimension == 3 ? 2 * along(random) : 0);
        auto bonds = bonds_of(position, 0.2);
        const NetworkConstants constants = set_stiffness(bonds, position, 7e5, 0.3, dimension);
        EXPECT_LT(constants.anisotropy, 1e-10);
        EXPECT_GT(constants.softest, 0.1 * constants.stiffest);
        const double out = dimension == 3 ? 1 : 0;
        for (const auto& e : {strain(1, 0, 0, 0, 0, 0), strain(0.3, -0.7, 0.2 * out, 0.4, 0.5 * out, -0.1 * out)})
            EXPECT_NEAR(energy(bonds, position, e) / (0.3 * energy(7e5, e)), 1, 1e-9) << dimension;
    }
}

TEST(BondNetwork, that_would_have_to_push_keeps_what_is_left_of_its_anisotropy) {
    // All bonds within 20 degrees of one line.
    std::vector<Vec> position{Vec::Zero()};
    std::vector<Bond> bonds;
    for (const double angle : {-0.35, -0.2, 0.0, 0.2, 0.35}) {
        bonds.push_back({0, static_cast<int>(position.size()), 1, 0});
        position.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    const NetworkConstants constants = set_stiffness(bonds, position, 1, 1, 2);
    EXPECT_GT(constants.softest, 0);
    EXPECT_GT(constants.anisotropy, 0.1);
    EXPECT_NEAR(energy(bonds, position, strain(1, 1, 0, 0, 0, 0)) / energy(1, strain(1, 1, 0, 0, 0, 0)), 1, 1e-12)
        << "an even one is met with E all the same";
}

TEST(BondNetwork, of_a_cube_with_edges_and_diagonals_needs_little_of_that) {
    constexpr int side = 9;
    std::vector<Vec> position;
    for (int k = 0; k < side; ++k)
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) position.emplace_back(i, j, k);
    auto bonds = bonds_of(position, 1.5);
    constexpr double modulus = 2e4, volume = side * side * side;
    const NetworkConstants constants = set_stiffness(bonds, position, modulus, volume, 3);
    EXPECT_GT(constants.softest, 0.8 * constants.stiffest);
    EXPECT_LT(constants.anisotropy, 1e-12);
    for (const auto& e : {strain(1, 1, 1, 0, 0, 0), strain(1, -0.5, -0.5, 0.4, 0.2, 0.1)})
        EXPECT_NEAR(energy(bonds, position, e) / (volume * energy(modulus, e)), 1, 1e-12);
    // Nearest neighbours alone resist no shear, whatever their stiffness: it is said.
    auto edges = bonds_of(position, 1.2);
    EXPECT_GT(set_stiffness(edges, position, modulus, volume, 3).anisotropy, 0.5);
}

/// The channel with a block of 0.5 m x 1 m on its bottom, clamped there, drawn over the water.
Texts block(const std::string& arrangement, const std::string& fill, const std::string& within = "0.21 m") {
    Texts texts{channel.scene +
                    "[[part]]\nname = \"block\"\nkind = \"elastic\"\ndensity = \"1200 kg/m^3\"\n"
                    "youngs_modulus = \"1 MPa\"\nanchor = \"wall\"\nbonds_within = \"" +
                    within + "\"\n",
                channel.cad_geometry + R"(Point(10) = {1.75, 0, 0};
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
    double squares = 0, in_layer = 0, least = 1;  // of the distance to the outline [spacings]
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::elastic) continue;
        ++nodes;
        EXPECT_EQ(set.body[i], 0);
        const Vec& at = set.position[i];
        const double distance = std::min({at.y(), 1 - at.y(), at.x() - 1.75, 2.25 - at.x()}) / 0.0625;
        least = std::min(least, distance);
        if (distance < 0.6) {  // of hexagonal rows, every other one
            squares += std::pow(distance - 0.5, 2);
            ++in_layer;
        }
        for (std::size_t j = i + 1; j < set.size(); ++j)
            if (set.kind(j) == PartKind::elastic && (set.position[i] - set.position[j]).norm() < 0.11) ++near;
    }
    EXPECT_EQ(bonded.size(), near);
    EXPECT_NEAR(static_cast<double>(nodes) / 128, 1, 0.04);
    EXPECT_GT(in_layer, 30);
    if (*meshed.scene.particles.fill == FillKind::lattice) {
        EXPECT_GT(least, -1e-9);
    } else {
        EXPECT_GT(least, 0.25) << "in corners";
        EXPECT_LT(std::sqrt(squares / in_layer), 0.05);
    }
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
    // A slit from above, a hundredth of a spacing wide, between two columns of eight.
    const Texts slit =
        block("square", "lattice", "0.1 m")
            .with("Point(13)",
                  "Point(14) = {1.9997, 1, 0};\nPoint(15) = {1.9997, 0.49, 0};\nPoint(16) = "
                  "{2.0003, 0.49, 0};\nPoint(17) = {2.0003, 1, 0};\nPoint(13)")
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
    // Eight rows below the slit; diagonals from the last of them would cross its end.
    EXPECT_EQ(across, 8U + 2 * 7);
}

TEST(BondedSolids, whose_particles_are_too_far_apart_are_refused) {
    EXPECT_THAT(fault_of(block("square", "lattice", "0.05 m")),
                AllOf(HasSubstr("a particle of 'block' at"), HasSubstr("has no other within 50 mm, bonds_within"),
                      HasSubstr("write 1.2 to 2 spacings")));
}

TEST(BondedSolids, that_swell_where_nothing_holds_their_particles_are_refused) {
    for (const int dimension : {2, 3}) {
        const std::string drawn = dimension == 3 ? "Box(1) = {0, 0, 0, 1, 0.25, 0.25};\nPhysical Volume"
                                                 : "Rectangle(1) = {0, 0, 0, 1, 0.25};\nPhysical Surface";
        const auto bar = [&](const std::string& fill) {
            return Texts{
                "schema = 1\ntitle = \"bar\"\ndimension = " + std::to_string(dimension) +
                    "\n[geometry]\nfile = \"channel.geo\"\n[particles]\nspacing = \"0.0625 m\"\nfill = \"" + fill +
                    "\"\n[[part]]\nname = \"bar\"\nkind = \"elastic\"\ndensity = \"1000 kg/m^3\"\n"
                    "youngs_modulus = \"1 MPa\"\nbonds_within = \"0.11 m\"\n[flow]\nlargest_speed = \"1 m/s\"\n"
                    "[run]\nduration = \"1 s\"\n[output]\nevery = \"1 s\"\n",
                "SetFactory(\"OpenCASCADE\");\n" + drawn + "(\"bar\") = {1};\n"};
        };
        EXPECT_EQ(mesh_texts(bar("lattice")).particles.size(), dimension == 3 ? 256U : 64U);
        for (const char* fill : {"relaxed", "sampled"})
            EXPECT_THAT(fault_of(bar(fill)),
                        AllOf(HasSubstr("a particle of 'bar' at"), HasSubstr("out of the drawn part"),
                              HasSubstr("leave out bonds_within")))
                << fill << " in " << dimension << "-D";
    }
}

}  // namespace
}  // namespace dmp::tests::bond_network_tests
