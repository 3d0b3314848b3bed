// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Elastic solids that pass into other solids.
#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "solver/monitor/penetration_monitor.hpp"
#include "solver/neighbours/neighbours.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/statics.hpp"

namespace dmp::tests::solver_penetration_tests {
namespace {

using testing::HasSubstr;

constexpr double spacing = 0.1;  // [m]

/// A floor of so many rows below y = 0, which begins half a spacing before its first column, and a block of 6 x 3
/// particles, the lowest of which start at this height above it, in units of the spacing; columns of both are half a
/// spacing apart.
struct BlockAboveFloor {
    Scene scene;
    ParticleSet set;
    PartKind floor;

    BlockAboveFloor(double height, PartKind kind_of_floor, int rows = 5, int first_column = 0) : floor(kind_of_floor) {
        std::vector<Vec> places;
        for (int row = 0; row < rows; ++row)
            for (int column = first_column; column < 12; ++column)
                places.emplace_back(spacing * column, -spacing * (row + 0.5), 0);
        const std::size_t of_floor = places.size();
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 6; ++column)
                places.emplace_back(spacing * (column + 3.5), spacing * (row + height), 0);
        set = set_of_nodes(2, places, std::vector<double>(places.size(), 1e-2));
        set.spacing = spacing;
        set.parts = {{"block", PartKind::elastic}, {"floor", floor}};
        set.box = {Vec(-1, -1, 0), Vec(2, 2, 0)};
        for (std::size_t i = 0; i < of_floor; ++i) {
            set.part[i] = 1;
            set.body[i] = floor == PartKind::rigid ? -1 : 1;
        }
        scene.dimension = 2;
        scene.particles.spacing = spacing;
    }
};

/// The surface that a particle of the floor shows: the nearest one.
SolidSurface surface_of(const Vec& place, double left, double bottom) {
    const double below = -place[1], inside = place[0] - left;
    return inside < below ? SolidSurface{-Vec::UnitX(), inside, std::numeric_limits<double>::infinity()}
                          : SolidSurface{Vec::UnitY(), below, bottom - below};
}

/// The warning once the block has been moved, by a distance in units of the spacing.
std::optional<std::string> after(const BlockAboveFloor& made, double move, bool has_surfaces = true) {
    Vec corner = Vec::Constant(1e9);
    for (std::size_t i = 0; i < made.set.size(); ++i)
        if (made.set.part[i] == 1) corner = corner.cwiseMin(made.set.position[i]);
    ParticleStore particles(made.set, {1000, 1000});
    for (ParticleGroup& group : particles.groups()) {
        if (group.kind() == PartKind::fluid) continue;
        group.declare({Field::wall_normal, Field::wall_distance, Field::opposite_distance});
        for (std::size_t i = 0; has_surfaces && i < group.owned(); ++i) {
            if (group.tags()[i].part == 0) continue;
            const Vec place(group.data(Field::position, 0)[i], group.data(Field::position, 1)[i], 0);
            const SolidSurface surface = surface_of(place, corner[0] - spacing / 2, spacing / 2 - corner[1]);
            for (int axis = 0; axis < 2; ++axis) group.data(Field::wall_normal, axis)[i] = surface.normal[axis];
            group.data(Field::wall_distance)[i] = surface.depth;
            group.data(Field::opposite_distance)[i] = surface.opposite;
        }
    }
    const Ranks ranks = Ranks::alone();
    Neighbours neighbours(ranks, particles.space(), 3 * spacing, 1);
    neighbours.renew(particles);
    PenetrationMonitor monitor(made.scene, 2e-6);
    monitor.start(particles, neighbours.list(), ranks);
    ParticleGroup& nodes = particles.of(PartKind::elastic);
    for (std::size_t i = 0; i < nodes.owned(); ++i)
        if (nodes.tags()[i].part == 0) nodes.data(Field::position, 1)[i] += move * spacing;
    neighbours.renew(particles);
    const std::optional<Warning> found = monitor.look(particles, neighbours.list(), nullptr, ranks, 0.25);
    if (!found) return {};
    EXPECT_FALSE(monitor.look(particles, neighbours.list(), nullptr, ranks, 0.5));  // once
    EXPECT_EQ(monitor.warning(nullptr)->text(), found->text());
    return found->text();
}

TEST(Penetration, is_more_than_half_a_spacing_behind_a_surface) {
    for (const PartKind kind : {PartKind::rigid, PartKind::elastic}) {
        const BlockAboveFloor made(2, kind);
        EXPECT_FALSE(after(made, 0));
        EXPECT_FALSE(after(made, -1.8));  // pressed against it, as contact holds it
        EXPECT_FALSE(after(made, -2.4));
        const auto found = after(made, -2.7);
        ASSERT_TRUE(found);
        EXPECT_THAT(*found, HasSubstr("contact.strength of 2e-06 J is too low for what presses the solids together: by "
                                      "0.25 s particle "));
        EXPECT_THAT(*found, HasSubstr("of 'block' had passed into 'floor', 0.7 spacings behind its surface, at ("));
        EXPECT_THAT(*found, HasSubstr("give a contact.strength of 2e-05 to 0.0002 J"));
        EXPECT_THAT(*after(made, -4), HasSubstr("2 spacings behind its surface"));
    }
}

TEST(Penetration, is_seen_without_surfaces_by_particles_that_are_too_near) {
    const BlockAboveFloor made(2, PartKind::elastic);
    EXPECT_FALSE(after(made, -2.3, false));  // 0.54 spacings from the nearest
    BlockAboveFloor above_columns = made;
    for (std::size_t i = 0; i < above_columns.set.size(); ++i)
        if (above_columns.set.part[i] == 0) above_columns.set.position[i][0] += spacing / 2;
    EXPECT_FALSE(after(above_columns, -2.05, false));
    EXPECT_THAT(*after(above_columns, -2.2, false), HasSubstr("0.3 spacings from one of its particles"));
}

// Particles behind a corner show one face only; one of a thin sheet's shows the side that it is nearer to.
TEST(Penetration, is_not_in_front_of_a_corner_or_beside_a_thin_sheet) {
    for (const PartKind kind : {PartKind::rigid, PartKind::elastic}) {
        const BlockAboveFloor at_corner(2, kind, 5, 4);  // its first column is at 3.5, over the corner
        for (const double move : {-1.8, -1.9, -2.1}) EXPECT_FALSE(after(at_corner, move)) << move;
        const BlockAboveFloor thin(2, kind, 1);
        for (const double move : {-1.8, -3.7, -3.8, -6.0}) EXPECT_FALSE(after(thin, move)) << move;
    }
}

TEST(Penetration, is_not_where_solids_are_joined_or_torn_apart) {
    EXPECT_FALSE(after(BlockAboveFloor(0.5, PartKind::rigid), -1.3));  // its lowest row has been beside the floor
    BlockAboveFloor pieces(2, PartKind::elastic);
    for (int& part : pieces.set.part) part = 0;
    pieces.set.parts.resize(1);
    pieces.scene.breaking.emplace_back();
    EXPECT_FALSE(after(pieces, -2.7));
}

}  // namespace
}  // namespace dmp::tests::solver_penetration_tests
