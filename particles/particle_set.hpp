// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/part_kind.hpp"
#include "base/vec.hpp"

namespace dmp::particles {

/// A harmonic bond, U = stiffness (r - rest_length)^2 (no 1/2), between particles a and b.
struct Bond {
    int a = 0, b = 0;
    double rest_length = 0;  ///< [m]
    double stiffness = 0;    ///< k_b [N/m]
    int join = -1;           ///< the scene's [[join]] that made it, of those between enabled parts; -1: its part
};

/// A hinge, U = stiffness (theta - rest_angle)^2 (no 1/2); theta in 2-D the signed angle from centre->a to centre->b,
/// in (-pi, pi]; in 3-D the angle between them, in [0, pi].
struct Hinge {
    int a = 0, centre = 0, b = 0;
    double rest_angle = 0;  ///< [rad]
    double stiffness = 0;   ///< k_a [J]
};

/// A dihedral (3-D), U = stiffness (phi - rest_angle)^2 (no 1/2), phi in (-pi, pi] the angle between the planes abc and
/// bcd, positive when, seen from b to c, d is turned clockwise from a; pi: all in a plane, a and d on different sides.
struct Dihedral {
    int a = 0, b = 0, c = 0, d = 0;
    double rest_angle = 0;  ///< in (-pi, pi] [rad]
    double stiffness = 0;   ///< k_d [J]
};

/// A node of elastic cells: no particle.
struct CellNode {
    Vec position = Vec::Zero();      ///< at rest [m]
    bool fixed = false;              ///< clamped
    std::array<bool, 3> on_plane{};  ///< by axis: on a plane of symmetry across it
};

/// A particle that is a cell of an elastic solid: a box, of which the solid fills the particle's volume, between nodes
/// on its corners (docs/elastic.md). Its particle is at the solid's centroid. Corner k is moved along axis i of the box
/// where bit i of k is set; in 2-D there are four.
struct SolidCell {
    int particle = 0;
    std::array<int, 8> node{};   ///< indices into cell_nodes
    Vec size = Vec::Zero();      ///< of the box along its axes [m]
    Vec centroid = Vec::Zero();  ///< of the solid, from the middle of the box, along its axes [m]
    Vec moment = Vec::Zero();    ///< mean of (X_i - centroid_i)^2 in the solid, by axis [m^2]
    /// Bit 8 axis + k: corner k is a period beyond its node along this axis, as the solid goes on through a
    /// periodic side.
    int periods = 0;

    [[nodiscard]] static int period_bit(int corner, int axis) { return 1 << (8 * axis + corner); }
    /// Where a corner is from its node [m].
    [[nodiscard]] Vec shift(int corner, const Box& box) const {
        Vec shift = Vec::Zero();
        for (int axis = 0; axis < 3; ++axis)
            if ((periods & period_bit(corner, axis)) != 0) shift[axis] = box.extent()[axis];
        return shift;
    }
};

/// A flat wall without an end, for spheres: they touch it from the side its normal points to.
struct WallPlane {
    int part = 0;               ///< index into parts
    Vec point = Vec::Zero();    ///< on the wall, at the start [m]
    Vec normal = Vec::UnitZ();  ///< unit vector into the side where spheres may be
};

/// A triangle of a wall for spheres, which touch it from both sides; the corners are indices into wall_corners,
/// counter- clockwise seen from outside where the surface has an outside.
struct WallTriangle {
    int part = 0;  ///< index into parts
    int a = 0, b = 0, c = 0;
};

/// A piece of the drawn surface of a part that touches others: in 2-D a straight line from a to b with the solid on its
/// left, in 3-D a triangle, counter-clockwise seen from outside the solid.
struct ContactPiece {
    static constexpr int none = -1;

    int part = 0;          ///< index into parts
    int a = 0, b = 0;      ///< indices into contact_points
    int c = none;          ///< likewise, of a triangle
    double thickness = 0;  ///< of the solid behind it, as far as contact looks [m]
};

/// The space that particles live in, and the parts they belong to: all of a particle set that does not grow with it.
struct ParticleSpace {
    struct PartInfo {
        std::string name;
        PartKind kind = PartKind::fluid;
    };

    int dimension = 2;
    double spacing = 0;              ///< [m]
    Box box;                         ///< periodic axes: one period; others: around everything
    std::array<bool, 3> periodic{};  ///< by axis
    /// By axis, low and high: whether that side of the box is a plane of symmetry; nothing lies beyond it.
    std::array<std::array<bool, 2>, 3> mirrored{};
    std::vector<PartInfo> parts;  ///< what the part numbers mean

    // walls for spheres; their parts are rigid, and need have no particles
    std::vector<WallPlane> wall_planes;
    std::vector<Vec> wall_corners;  ///< of the triangles, each once, at the start [m]
    std::vector<WallTriangle> wall_triangles;

    // surfaces of elastic bodies and of the walls they may touch; none where contact is between particles
    std::vector<Vec> contact_points;  ///< each once, as drawn [m]
    std::vector<ContactPiece> contact_pieces;

    /// The number of the part of that name; -1 where there is none.
    [[nodiscard]] int part_named(const std::string& name) const;
    [[nodiscard]] bool is_mirrored(int axis) const { return mirrored[axis][0] || mirrored[axis][1]; }
    /// Twice the place of the plane of symmetry that x lies beyond, minus x: its mirror image; else x.
    [[nodiscard]] double mirrored_back(double x, int axis) const {
        if (mirrored[axis][0] && x < box.low[axis]) return 2 * box.low[axis] - x;
        if (mirrored[axis][1] && x > box.high[axis]) return 2 * box.high[axis] - x;
        return x;
    }
};

/// The shortest periodic image of the vector between two points [m].
Vec nearest_image(Vec apart, const ParticleSpace& space);

/// The surface of an elastic solid near one of its particles, at rest. Without a normal, the particle is as good as
/// round: its surface is `depth` away in all directions.
struct SolidSurface {
    Vec normal = Vec::Zero();  ///< unit vector out of the solid, or 0
    double depth = 0;          ///< of the particle behind that surface [m]
    double opposite = 0;       ///< distance to the surface on the other side, against the normal [m]
};

/// What the mesher hands on: particles, bonds and walls, as plain arrays. A particle's id is its index.
struct ParticleSet : ParticleSpace {
    // one entry a particle
    std::vector<Vec> position;         ///< [m]
    std::vector<double> volume;        ///< volume it stands for in the SPH sums [m^2 x 1 m]
    std::vector<double> mass;          ///< inertial mass [kg]
    std::vector<int> part;             ///< index into parts
    std::vector<int> body;             ///< connected piece of elastic solids, by way of walls too; -1: none
    std::vector<std::uint8_t> fixed;   ///< 1: never moves (rigid walls, anchored ends)
    std::vector<std::uint8_t> seated;  ///< 1: drawn touching a wall, so that the wall does not push it away
    /// Rigid and elastic: unit vector from the nearest surface outward; 0 in fluids, and in solids that are not drawn.
    std::vector<Vec> wall_normal;
    /// Rigid and elastic: distance to that surface, > 0 behind it [m]; in an elastic solid that is thinner than its two
    /// rows of particles < 0; else 0.
    std::vector<double> wall_distance;
    /// Elastic: distance to the surface on the other side, against the normal [m]; else 0. Empty where there are none.
    std::vector<double> opposite_distance;

    // one entry a particle where there are spheres, 0 for particles of other kinds; empty where there are none
    std::vector<double> radius;         ///< of a sphere [m]; its moment of inertia is 2/5 mass radius^2
    std::vector<Vec> velocity;          ///< with which a sphere starts [m/s]
    std::vector<Vec> angular_velocity;  ///< with which a sphere starts, in the resting frame [rad/s]

    std::vector<Bond> bonds;
    std::vector<Hinge> hinges;
    std::vector<Dihedral> dihedrals;  ///< 3-D only
    std::vector<CellNode> cell_nodes;
    std::vector<SolidCell> cells;

    [[nodiscard]] std::size_t size() const { return position.size(); }
    [[nodiscard]] PartKind kind(std::size_t i) const { return parts[static_cast<std::size_t>(part[i])].kind; }
    [[nodiscard]] std::size_t count(PartKind wanted) const;
    [[nodiscard]] bool has_spheres() const { return !radius.empty(); }
    /// Where an elastic particle is in its solid.
    [[nodiscard]] SolidSurface surface(std::size_t i) const {
        return {wall_normal[i], wall_distance[i], opposite_distance.empty() ? 0 : opposite_distance[i]};
    }
};

}  // namespace dmp::particles
