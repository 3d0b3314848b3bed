// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "particles/particle_set.hpp"
#include "scene/expression.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/spheres/smooth_edges.hpp"
#include "solver/spheres/sphere_rows.hpp"
#include "solver/spheres/wall_law.hpp"
#include "solver/state/archive.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// A law between a part of spheres and a wall's part.
struct WallPair {
    ContactModel model;
    ContactConstants<double> constants;
};

/// Which law holds between each part of spheres and each wall's part.
using WallPairs = std::vector<std::vector<std::optional<WallPair>>>;  // [sphere part][wall part]

/// What a sphere's touch of a wall remembers. Travels with the sphere.
struct WallContact {
    std::int64_t id = 0;        ///< of the sphere
    std::int32_t surface = -1;  ///< planes first, then triangles
    std::int32_t part = 0;      ///< the wall's
    std::array<double, 3> normal{};
    std::array<double, most_history> history{};
};

/// Walls that spheres touch: planes, and surfaces of triangles, whose parts may move.
///
/// A sphere touches a surface of triangles where its distance to the surface has a local minimum: in faces, edges and
/// corners, each place once. A place on one triangle that lies on another one too, which comes nearer elsewhere, is
/// none. So an edge that bends away is not felt from a face; in a corner that bends towards the sphere it touches both
/// faces. Touched triangles that follow each other over smooth edges (SmoothEdges) are one contact, that of the deepest
/// touch, unless their normals differ by 60 degrees or more: m contacts in place of one would be m times as stiff and
/// as damped, with a restitution of e^sqrt(m). What a contact remembers passes from triangle to triangle as it rolls.
/// A sphere's contacts with walls are summed in their own order by the rank that owns it.
class SphereWalls {
  public:
    /// `velocity` by part number.
    SphereWalls(const ParticleSpace& space, std::vector<std::array<Expression, 3>> velocity, WallPairs pairs);

    [[nodiscard]] bool empty() const { return planes_.empty() && triangles_.empty(); }

    [[nodiscard]] bool moves(int part) const { return motion_[static_cast<std::size_t>(part)].moves; }
    /// How far a part has moved since the start [m].
    [[nodiscard]] const Vec& displacement(int part) const {
        return motion_[static_cast<std::size_t>(part)].displacement;
    }
    /// From t to t + dt: walls move.
    void advance(double t, double dt);
    /// How fast any wall is at most in this step [m/s].
    [[nodiscard]] double largest_speed() const { return largest_speed_; }
    /// And at a time [m/s].
    [[nodiscard]] double largest_speed_at(double t) const;

    /// Lists what each owned sphere may touch until it or a wall has moved: surfaces less than `gap` away [m].
    void list(const SphereRows& rows, std::span<const ParticleTag> tags, double gap);
    /// Calls visit(row) for each sphere that may touch one until then.
    template <class Visit>
    void for_each_listed(const Visit& visit) const {
        for (const ListedSphere& sphere : listed_) visit(sphere.row);
    }
    /// Adds what walls do to the owned spheres, whose pair sums are complete.
    void add_loads(SphereRows& rows, std::span<const ParticleTag> tags, const ContactTime& time);

    /// The force of walls on this rank's spheres after add_loads [N].
    [[nodiscard]] const std::array<ExactSum, 3>& total_force() const { return total_; }
    [[nodiscard]] const std::vector<WallContact>& contacts() const { return contacts_; }
    /// The largest overlap of a sphere with a wall over its radius, and whose it is.
    struct Overlap {
        double ratio = 0;
        std::int32_t row = -1;
    };
    [[nodiscard]] Overlap largest_overlap(const SphereRows& rows) const;
    /// Energy that the contacts of this rank's spheres with walls store, as of add_loads [J].
    [[nodiscard]] ExactSum contact_energy(const SphereRows& rows, std::span<const ParticleTag> tags) const;

    /// Contacts go where their spheres go: `rank_of` by row. All ranks take part.
    void exchange(const Ranks& ranks, std::span<const int> rank_of);
    /// Loading, every rank gets all contacts; list() keeps its own. Ids of spheres are below `ids`; throws InputError
    /// for contacts of no sphere or no wall.
    void archive(Archive& file, const Ranks& ranks, std::int64_t ids);

  private:
    struct Motion {
        std::array<Expression, 3> velocity;
        bool moves = false;
        Vec displacement = Vec::Zero();  ///< since the start [m]
        Vec middle = Vec::Zero();        ///< velocity in the middle of the step [m/s]
        [[nodiscard]] Vec at(double t) const;
    };
    struct Candidate {
        std::int32_t surface = 0;
        std::array<double, 3> shift{};  ///< whole periods, of the wall towards the sphere [m]
    };
    struct ListedSphere {
        std::int32_t row = 0;
        std::size_t first = 0, end = 0;                  ///< candidates
        std::size_t first_contact = 0, end_contact = 0;  ///< contacts of the last step
    };
    struct Touch {
        std::int32_t surface = 0, part = 0;
        Vec nearest;  ///< on the wall
        Vec normal;
        double distance = 0;
        std::array<Vec, 3> corners;  ///< of a triangle, where it is seen
    };

    [[nodiscard]] int part_of(std::int32_t surface) const;
    [[nodiscard]] std::array<Vec, 3> corners_of(std::int32_t surface) const;
    [[nodiscard]] Touch touch_of(const Candidate& candidate, const Vec& position) const;
    [[nodiscard]] std::vector<Touch> touches_of(const ListedSphere& sphere, const SphereMotion& motion,
                                                std::uint16_t part) const;
    [[nodiscard]] bool is_hidden(std::size_t number, const std::vector<Touch>& all, double tolerance) const;
    [[nodiscard]] std::vector<std::size_t> smooth_surfaces(const std::vector<Touch>& touches) const;
    void list_triangles(const SphereRows& rows, double gap, std::vector<std::vector<Candidate>>& of_row) const;
    [[nodiscard]] const WallContact* remembered(const Touch& touch, std::span<const WallContact> before,
                                                const std::vector<Touch>& all) const;
    void assign_contacts(std::span<const ParticleTag> tags);

    ParticleSpace space_;
    std::vector<WallPlane> planes_;
    std::vector<WallTriangle> triangles_;
    SmoothEdges smooth_edges_;
    std::vector<Motion> motion_;  ///< by part
    WallPairs pairs_;
    double largest_speed_ = 0;
    std::vector<ListedSphere> listed_;
    std::vector<Candidate> candidates_;
    std::vector<WallContact> contacts_, next_contacts_;
    std::array<ExactSum, 3> total_;
};

}  // namespace dmp::solver
