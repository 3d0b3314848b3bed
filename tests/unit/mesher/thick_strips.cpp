// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Strips thicker than two spacings.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "meshed_text.hpp"
#include "mesher/spring_lattice.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::thick_strips_tests {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

/// A flap of 1 m on the floor of a channel of 4 m x 2 m with 0.125 m between particles, held at its foot.
Meshed strip_of(const std::string& thickness, const std::string& more = "") {
    return mesh_texts(flap_channel.with("bending_stiffness = \"3 N*m^2\"\naxial_stiffness = \"100 N\"",
                                        "youngs_modulus = \"1 kPa\"\nthickness = \"" + thickness + "\"\n" + more));
}

double volume_of_liquid(const ParticleSet& set) {
    double volume = 0;
    for (std::size_t i = 0; i < set.size(); ++i) volume += set.kind(i) == PartKind::fluid ? set.volume[i] : 0;
    return volume;
}

TEST(ThickStrips, have_a_row_a_spacing_in_equal_slices) {
    Scene dry;
    dry.particles.spacing = Value<double>(0.125, {"scene.toml", 1, 1});
    Scene in_liquid = dry;
    in_liquid.parts.emplace_back().kind = PartKind::fluid;
    for (const auto& [thickness, rows] :
         {std::pair{0.1, 2}, {0.25, 2}, {0.3, 2}, {0.32, 3}, {0.375, 3}, {0.44, 4}, {0.5, 4}, {0.7, 6}}) {
        Part part;
        part.thickness = Value<double>(thickness, {"scene.toml", 1, 1});
        const StripRows strip = strip_rows(part, in_liquid);
        EXPECT_EQ(strip.count, rows) << thickness;
        EXPECT_DOUBLE_EQ(strip.thickness(), std::max(0.25, thickness));
        part.cross_bonds = true;
        EXPECT_EQ(strip_rows(part, in_liquid).count, 2);
        EXPECT_EQ(strip_rows(part, in_liquid).apart, 0.125);
        part.cross_bonds = false;
        EXPECT_EQ(strip_rows(part, dry).count, 2) << "whose rows no liquid sees";
    }
}

TEST(ThickStrips, have_their_volume_mass_and_surfaces) {
    for (const auto& [text, thickness] : {std::pair{"0.375 m", 0.375}, {"0.3 m", 0.3}, {"0.5 m", 0.5}}) {
        const Meshed meshed = strip_of(text);
        const ParticleSet& set = meshed.particles;
        const auto& line = meshed.report.springs.front();
        const bool has_two_rows = thickness < 2.5 * 0.125;  // whose hinges have half of EI
        EXPECT_EQ(meshed.report.warnings.size(), has_two_rows ? 1U : 0U);
        double volume = 0, mass = 0, nearest = 10, highest = 0;
        std::size_t outer = 0;
        for (std::size_t i = 0; i < set.size(); ++i) {
            const Vec& at = set.position[i];
            if (set.kind(i) == PartKind::fluid && at[1] < 1)
                nearest = std::min(nearest, std::abs(at[0] - 2) / thickness);
            if (set.kind(i) != PartKind::elastic) continue;
            volume += set.volume[i];
            mass += set.mass[i];
            highest = std::max(highest, std::abs(at[0] - 2));
            // Half the material's thickness from its middle, on the nearer side; the middle row counts to one of them.
            EXPECT_NEAR(set.wall_distance[i], thickness / 2 - std::abs(at[0] - 2), 1e-12);
            EXPECT_NEAR(set.wall_distance[i] + set.opposite_distance[i], thickness, 1e-12);
            EXPECT_NEAR(std::abs(set.wall_normal[i][0]), 1, 1e-12);
            EXPECT_GT(set.wall_normal[i][0] * (at[0] - 2), -1e-12);
            outer += set.wall_distance[i] < 0.6 * 0.125 * 1.25 ? 1 : 0;
        }
        const double columns = 9, cells = 8;
        EXPECT_NEAR(volume, thickness * 0.125 * columns, 1e-12);
        EXPECT_NEAR(mass, 10 * 0.125 * cells, 1e-9) << "10 kg/m";
        EXPECT_EQ(outer, 2 * columns);
        EXPECT_GT(nearest, 0.5);
        EXPECT_NEAR(line.axial_stiffness / line.axial_stiffness_asked, has_two_rows ? 2.0 / 3 : 1, 1e-9);
        // The liquid has what the strip leaves of 4 m x 2 m; its last column reaches half a spacing on.
        EXPECT_NEAR(volume_of_liquid(set), 8 - thickness * (1 + 0.125 / 2), 1e-9);
        EXPECT_THAT(meshed.report.notes, Contains(HasSubstr(" apart")));
    }
    EXPECT_THAT(strip_of("0.375 m").report.notes,
                Contains("flap: its surfaces are 375 mm apart, on 3 rows of particles"));
    EXPECT_THAT(
        strip_of("0.375 m", "cross_bonds = true").report.warnings,
        Contains(HasSubstr("flows past its two rows of particles as if it were 250 mm; leave out cross_bonds")));
}

}  // namespace
}  // namespace dmp::tests::thick_strips_tests
