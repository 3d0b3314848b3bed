// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/disorder.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "meshed_text.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::disorder_tests {
namespace {

using testing::Contains;

Texts disturbed(const Texts& texts, const std::string& lines) {
    return texts.with("spacing = \"0.125 m\"\n", "spacing = \"0.125 m\"\n" + lines);
}

/// Displacement of each fluid particle along an axis, across the channel's period as well [spacings].
std::vector<double> displacements(const ParticleSet& moved, const ParticleSet& lattice, int axis) {
    std::vector<double> all;
    for (std::size_t i = 0; i < lattice.size(); ++i) {
        if (lattice.kind(i) != PartKind::fluid) continue;
        double d = moved.position[i][axis] - lattice.position[i][axis];
        if (axis == 0) d -= 4 * std::round(d / 4);
        all.push_back(d / 0.125);
    }
    return all;
}

TEST(Disorder, DisplacesTheFluidEvenlyWithinItsAmplitude) {
    const ParticleSet lattice = mesh_texts(channel).particles;
    const ParticleSet moved = mesh_texts(disturbed(channel, "disorder = 0.2\n")).particles;
    ASSERT_EQ(moved.size(), lattice.size());
    for (int axis = 0; axis < 2; ++axis) {
        double sum = 0, squares = 0;
        const auto all = displacements(moved, lattice, axis);
        for (const double d : all) {
            EXPECT_LE(std::abs(d), 0.2);
            sum += d;
            squares += d * d;
        }
        // 512 samples of an even distribution: mean 0 and variance a^2/3, within three deviations of each.
        const auto n = static_cast<double>(all.size());
        EXPECT_NEAR(sum / n, 0, 3 * 0.2 / std::sqrt(3 * n));
        EXPECT_NEAR(squares / n, 0.04 / 3, 3 * 0.04 * std::sqrt(4.0 / 45 / n));
    }
    for (std::size_t i = 0; i < lattice.size(); ++i) {
        EXPECT_GE(moved.position[i][0], 0);
        EXPECT_LT(moved.position[i][0], 4);
        EXPECT_EQ(moved.volume[i], lattice.volume[i]);
        if (lattice.kind(i) == PartKind::fluid) continue;
        EXPECT_EQ(moved.position[i], lattice.position[i]);
    }
}

TEST(Disorder, IsTheSameForTheSameSeedOnly) {
    const auto positions = [](const std::string& lines) {
        return mesh_texts(disturbed(channel, lines)).particles.position;
    };
    const auto first = positions("disorder = 0.2\n");
    EXPECT_EQ(first, positions("disorder = 0.2\nseed = 1\n"));
    EXPECT_NE(first, positions("disorder = 0.2\nseed = 2\n"));
}

TEST(Disorder, DoesNotDependOnTheNumberOfParticles) {
    const Disorder disorder{0.3, 7};
    EXPECT_EQ(disorder.displacement(41, 0), disorder.displacement(41, 0));
    EXPECT_NE(disorder.displacement(41, 0), disorder.displacement(41, 1));
    EXPECT_NE(disorder.displacement(41, 0), disorder.displacement(42, 0));
}

TEST(Disorder, KeepsFluidInItsRegionAndOffBodies) {
    const Meshed meshed = mesh_texts(disturbed(flap_channel, "disorder = 0.4\nseed = 3\n"));
    const ParticleSet& set = meshed.particles;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::fluid) continue;
        EXPECT_GT(set.position[i][1], 0);
        EXPECT_LT(set.position[i][1], 2);
        for (std::size_t j = 0; j < set.size(); ++j) {
            if (set.kind(j) != PartKind::elastic) continue;
            EXPECT_GT((set.position[i] - set.position[j]).norm(), 0.4 * 0.125);
        }
    }
}

TEST(Disorder, StandsInTheReport) {
    EXPECT_THAT(mesh_texts(disturbed(channel, "disorder = 0.2\n")).report.notes,
                Contains("fluid particles displaced at random by up to 0.2 spacings along each axis, seed 1"));
    EXPECT_TRUE(mesh_texts(channel).report.notes.empty());
}

}  // namespace
}  // namespace dmp::tests::disorder_tests
