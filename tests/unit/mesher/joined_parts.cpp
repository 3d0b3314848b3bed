// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Bonds between parts: which are made, which are not, and what is said of them.
#include <cmath>
#include <set>

#include <gmock/gmock.h>

#include "meshed_text.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::joined_parts_tests {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double spacing = 0.125;

std::string block_part(const std::string& name, const std::string& modulus) {
    return "[[part]]\nname = \"" + name +
           "\"\nkind = \"elastic\"\nmodel = \"springs\"\ndensity = \"1200 kg/m^3\"\npoisson_ratio = "
           "0.25\nyoungs_modulus = \"" +
           modulus + "\"\n";
}

/// A block of 0.5 m x 1 m that stands on the channel's bottom from x on; points and lines from `first` on.
std::string block_geometry(const std::string& name, int first, const std::string& x) {
    const auto n = [first](int k) { return std::to_string(first + k); };
    const auto point = [&](int k, const std::string& px, const std::string& py) {
        return "Point(" + n(k) + ") = {" + px + ", " + py + ", 0};\n";
    };
    const auto line = [&](int k) { return "Line(" + n(k) + ") = {" + n(k) + ", " + n((k + 1) % 4) + "};\n"; };
    return point(0, x, "0") + point(1, x + " + 0.5", "0") + point(2, x + " + 0.5", "1") + point(3, x, "1") + line(0) +
           line(1) + line(2) + line(3) + "Curve Loop(" + n(0) + ") = {" + n(0) + ", " + n(1) + ", " + n(2) + ", " +
           n(3) + "};\nPlane Surface(" + n(0) + ") = {" + n(0) + "};\nPhysical Surface(\"" + name + "\") = {" + n(0) +
           "};\n";
}

std::string join(const std::string& a, const std::string& b, const std::string& more = {}) {
    return "[[join]]\nname = \"seam\"\nparts = [\"" + a + "\", \"" + b + "\"]\n" + more;
}

/// Two blocks beside each other, `gap` [m] apart.
Texts two_blocks(const std::string& gap, const std::string& joined) {
    return {channel.scene + block_part("left", "1 MPa") + block_part("right", "3 MPa") + joined,
            channel.cad_geometry + block_geometry("left", 10, "1.25") + block_geometry("right", 20, "1.75 + " + gap)};
}

double mean_of_own(const ParticleSet& set, const std::string& part) {
    double sum = 0;
    int count = 0;
    for (const Bond& bond : set.bonds) {
        if (bond.join >= 0 || set.parts[set.part[bond.a]].name != part) continue;
        sum += bond.stiffness;
        ++count;
    }
    return sum / count;
}

TEST(JoinedParts, are_bonded_to_their_neighbours_and_are_one_body) {
    const auto meshed = mesh_texts(two_blocks("0", join("left", "right")));
    const ParticleSet& set = meshed.particles;
    const auto& line = meshed.report.joins.at(0);
    EXPECT_EQ(line.bonds, 8U + 2 * 7) << "along the rows, and diagonals";
    EXPECT_EQ(line.across_gaps, 0U);
    EXPECT_NEAR(line.shortest, spacing, 1e-12);
    EXPECT_NEAR(line.longest, std::sqrt(2.0) * spacing, 1e-12);
    const double in_series = 2 / (1 / mean_of_own(set, "left") + 1 / mean_of_own(set, "right"));
    EXPECT_NEAR(line.stiffness / in_series, 1, 1e-12);
    std::size_t made = 0;
    for (const Bond& bond : set.bonds) {
        EXPECT_EQ(bond.join >= 0, set.part[bond.a] != set.part[bond.b]);
        if (bond.join < 0) continue;
        ++made;
        EXPECT_EQ(bond.stiffness, line.stiffness);
        EXPECT_EQ(bond.rest_length, (set.position[bond.a] - set.position[bond.b]).norm());
    }
    EXPECT_EQ(made, line.bonds);
    for (std::size_t i = 0; i < set.size(); ++i) EXPECT_EQ(set.body[i], set.kind(i) == PartKind::elastic ? 0 : -1);
    for (const auto& springs : meshed.report.springs) EXPECT_EQ(springs.pieces, 1) << springs.part;
    EXPECT_THAT(meshed.report.text(), AllOf(HasSubstr("join seam: 22 bonds of k_b = "),
                                            HasSubstr("between left and right, 125 mm to 176.8 mm long")));
    EXPECT_THAT(meshed.report.json(), HasSubstr("\"joins\""));
}

TEST(JoinedParts, have_the_stiffness_and_the_reach_that_are_asked_for) {
    const auto meshed =
        mesh_texts(two_blocks("0", join("left", "right", "stiffness = \"7 N/m\"\nwithin = \"0.13 m\"\n")));
    EXPECT_EQ(meshed.report.joins.at(0).bonds, 8U);
    EXPECT_EQ(meshed.report.joins.at(0).stiffness, 7);
}

TEST(JoinedParts, are_not_bonded_across_a_gap) {
    // A row of water between them: the next rows are two spacings apart.
    const Texts apart = two_blocks("0.125", join("left", "right", "within = \"0.28 m\"\n"));
    EXPECT_THAT(fault_of(apart),
                AllOf(HasSubstr("join 'seam' makes no bond: all 22 pairs of 'left' and 'right'"),
                      HasSubstr("have a particle of another part between them"), HasSubstr("so that they touch")));
    // Nearer than any gap, nothing is within reach; with the whole truth about how far that is.
    EXPECT_THAT(
        fault_of(two_blocks("0.125", join("left", "right"))),
        AllOf(HasSubstr("no two particles of 'left' and 'right' that are free or not bonded yet are within 187.5 "
                        "mm of each other; the nearest are 250 mm apart"),
              HasSubstr("larger within")));
    // A block on the bottom and one on top of it that hangs over water on one side.
    Texts over = two_blocks("0", join("left", "right", "within = \"0.28 m\"\n"));
    EXPECT_EQ(mesh_texts(over).report.joins.at(0).across_gaps, 0U);
}

TEST(JoinedParts, of_a_body_and_a_wall_hold_it) {
    const auto meshed = mesh_texts(two_blocks("1", join("wall", "left")));
    const auto& line = meshed.report.joins.at(0);
    EXPECT_EQ(line.bonds, 4U + 2 * 4);
    EXPECT_NEAR(line.stiffness / (2 * mean_of_own(meshed.particles, "left")), 1, 1e-12)
        << "half a bond, as the wall does not yield";
    for (std::size_t i = 0; i < meshed.particles.size(); ++i) {
        const std::string& part = meshed.particles.parts[meshed.particles.part[i]].name;
        EXPECT_EQ(meshed.particles.body[i], part == "left" ? 0 : part == "right" ? 1 : -1);
    }
}

TEST(JoinedParts, become_one_body_by_way_of_a_wall_s_particle) {
    const std::string both = join("wall", "left") + join("right", "wall");
    const auto touching =
        mesh_texts(two_blocks("0.125", both).with("\"seam\"\nparts = [\"right", "\"other\"\nparts = [\"right"));
    const auto apart =
        mesh_texts(two_blocks("1", both).with("\"seam\"\nparts = [\"right", "\"other\"\nparts = [\"right"));
    const auto bodies = [](const ParticleSet& set) {
        return std::set<int>(set.body.begin(), set.body.end()).size() - 1;  // but -1
    };
    EXPECT_EQ(bodies(touching.particles), 1U);
    EXPECT_EQ(bodies(apart.particles), 2U);
}

TEST(JoinedParts, may_be_one_part_with_longer_bonds) {
    const auto meshed = mesh_texts(two_blocks("0", join("left", "left", "within = \"0.26 m\"\n")));
    EXPECT_EQ(meshed.report.joins.at(0).bonds, 2U * 8 + 4 * 6) << "two cells along rows and columns";
    std::set<std::pair<int, int>> ends;
    for (const Bond& bond : meshed.particles.bonds) EXPECT_TRUE(ends.emplace(std::minmax(bond.a, bond.b)).second);
}

TEST(JoinedParts, of_which_one_is_left_out_are_not_joined) {
    const Texts without =
        two_blocks("0", join("left", "right")).with("name = \"right\"\n", "name = \"right\"\nenabled = false\n");
    const auto meshed = mesh_texts(without);
    EXPECT_TRUE(meshed.report.joins.empty());
    EXPECT_THAT(meshed.report.text(), Not(HasSubstr("join")));
}

TEST(JoinedParts, that_are_held_have_nothing_to_gain) {
    const Texts held =
        two_blocks("1", join("wall", "left")).with("name = \"left\"\n", "name = \"left\"\nanchor = \"wall\"\n");
    EXPECT_THAT(fault_of(held), HasSubstr("the nearest are 250 mm apart"));
}

}  // namespace
}  // namespace dmp::tests::joined_parts_tests
