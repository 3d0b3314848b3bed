// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "geometry/geometry.hpp"
#include "geometry/inside_test.hpp"
#include "geometry/nearest_curve.hpp"
#include "mesher/fit_particles.hpp"
#include "mesher/lattice.hpp"
#include "mesher/mesh.hpp"
#include "mesher/nodes_of_bodies.hpp"
#include "mesher/solid_cells.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

/// The sides of the box that are planes of symmetry: by axis, low and high.
std::array<std::array<bool, 2>, 3> mirrored_sides(const Scene& scene);

/// Widens a box around fluids by whole spacings, so that a point of a body lies in it too; not across sides beyond
/// which the scene goes on.
void widen_for_body(Box& box, const Vec& point, const Scene& scene);

/// The box around the fluid regions of the scene and solids of springs; along periodic axes exactly one period.
Box fluid_box(const Geometry& geometry, const Scene& scene);

/// Builds a particle set part by part: first the spring bodies, then the fluid around them, then the walls.
class ParticleBuilder {
  public:
    ParticleBuilder(const Geometry& geometry, const Scene& scene);

    /// Rows of nodes along each curve, with bonds along and across and four hinges or two diagonals a cell; of a
    /// region the lattice points in it, with the springs of each cell. Clamped at the anchors.
    void add_elastic(const Part& part);
    /// Lattice points inside the region, outside the bodies: a strip takes up half its rows on both sides of its curve.
    /// Points on the border of two fluids belong to the first of them.
    void add_fluid(const Part& part);
    /// Lattice points outside all fluid, at most `layers` spacings behind the curve, that do not overlap a body. Where
    /// rigid parts meet, a point belongs to the nearest of them.
    void add_walls(const Part& part);
    /// True where the point belongs to the region of fluid particle i.
    [[nodiscard]] bool holds(std::size_t i, const Vec& point) const;

    /// True where no spring body stands: outside of strips' rows, and not next to a solid's nodes.
    [[nodiscard]] bool clear_of_bodies(const Vec& point) const;

    /// Moves the fluid from the lattice to places at random that keep their distance.
    void sample();
    /// Moves fluid and walls until they follow the curves.
    void fit();
    [[nodiscard]] MeshResult finish();
    /// Lattice points that were looked at.
    [[nodiscard]] std::size_t candidates() const { return candidates_; }
    [[nodiscard]] ParticleSet& particles() { return result_.particles; }

  private:
    struct NewParticle {
        Vec position;
        double volume = 0, mass = 0;
        int body = -1;
        bool fixed = false;
        Vec wall_normal = Vec::Zero();
        double wall_distance = 0;
    };

    /// A rigid part's surface; `thickness` is how far the part reaches behind it, until it is fitted [m].
    struct Wall {
        const Part* part;
        double thickness;
        NearestCurve curve;
        /// Whether a particle so far behind the surface is of the wall: none at its thickness, whatever the digits.
        [[nodiscard]] bool holds(double distance) const { return distance < (1 - 1e-9) * thickness; }
    };
    struct Fluid {
        const Part* part;
        InsideTest region;
    };
    struct WallPoint {
        int wall = -1;  ///< index into walls_; -1: no wall reaches the point
        Projection surface;
    };

    /// A curve with rows of particles to both sides.
    struct Strip {
        CurveSet curve;
        double half;       ///< as far as the rows reach [m]
        bool is_thick;     ///< more than two spacings, as its material is
        Region outline{};  ///< what the rows fill, where it is thick
    };

    /// A region of springs, or of cells.
    struct SpringSolid {
        const Part* part;
        InsideTest region;
        std::vector<Vec> points;          ///< of the lattice that belong to whole cells
        std::vector<bool> anchored;       ///< of each point
        std::optional<SolidCells> cells;  ///< where it is made of them; points are their centroids
    };

    int add_part(const Part& part, PartKind kind);
    int add_particle(int part, const NewParticle& particle);
    /// Within the drawn area of a solid of springs, also where no whole cell of it is.
    [[nodiscard]] bool is_in_a_solid(const Vec& point) const;
    void claim_solids();
    void refuse_overlap(const SpringSolid& solid, const SolidCells& cells) const;
    /// The lattice points in the area that belong to whole cells of springs.
    void claim_points(SpringSolid& solid);
    void claim_cells(SpringSolid& solid, const Region& region);
    void add_solid(const SpringSolid& solid, int part_number, MeshReport::SpringLine& line);
    void add_cells(const SpringSolid& solid, int part_number, MeshReport::SpringLine& line);
    /// Whether liquid is to fill what solids of cells and thick strips leave of the boxes that their surface cuts.
    [[nodiscard]] bool fills_beside_bodies() const;
    struct Filled {
        std::size_t particles = 0;
        double area = 0;       ///< of liquid more than lattice points have [m^2]
        double of_strips = 0;  ///< drawn as liquid, of thick strips [m^2]
    };
    /// Adds the liquid that lattice points leave out there, and gives all particles of the part an equal share of its
    /// volume.
    Filled fill_beside_bodies(const Part& part, int number);
    [[nodiscard]] std::vector<Vec> places_beside_bodies(const Part& part, const std::vector<Vec>& corners) const;
    void add_unbonded(const SpringSolid& solid, int part_number, MeshReport::SpringLine& line);
    void clamp_cells(const Part& part, SolidCells& cells) const;
    [[nodiscard]] std::vector<bool> anchored_nodes(const Part& part, const std::vector<Vec>& nodes) const;
    [[nodiscard]] Vec lattice_step() const { return {lattice_.step()[0], lattice_.step()[1], 0}; }
    /// Whether a curve ends a period from where it begins.
    [[nodiscard]] bool goes_on_through_a_side(const Polyline& curve) const;
    /// Within a strip's rows; also half a spacing beside a thick one where fill_beside_bodies() brings liquid.
    [[nodiscard]] bool is_in_a_strip(const Vec& point) const;
    [[nodiscard]] bool is_in_a_thin_strip(const Vec& point) const;
    [[nodiscard]] bool is_in_an_outline(const Vec& point) const;
    void add_ladder(const Part& part, int part_number, const Polyline& curve, MeshReport::SpringLine& line);
    /// Where a piece of an elastic solid is clamped: at named points, or at its ends that lie on a curve.
    [[nodiscard]] std::vector<Vec> anchors_of(const Part& part, const Polyline& curve) const;
    [[nodiscard]] std::vector<bool> anchored_columns(const Part& part, const Polyline& curve,
                                                     const std::vector<Vec>& middles, double along) const;
    /// The fluid part that holds the point, also on its border with another or a solid; none outside and on walls.
    [[nodiscard]] const Part* fluid_at(const Vec& point) const;
    /// The wall the point belongs to, and its surface, looked for across periodic sides as well.
    [[nodiscard]] WallPoint wall_at(const Vec& point) const;
    void nearest_from_images(const Vec& point, WallPoint& best) const;
    /// From a point on the surface into the fluid: the mean direction in which fluid lies.
    [[nodiscard]] Vec normal_on_surface(const Vec& point) const;

    const Geometry& geometry_;
    const Scene& scene_;
    double spacing_;
    Lattice lattice_;
    std::vector<Fluid> fluids_;
    std::vector<Wall> walls_;
    std::vector<Strip> strips_;
    std::vector<SpringSolid> solids_;
    NodesOfBodies nodes_;
    int bodies_ = 0;
    std::size_t candidates_ = 0;
    MeshResult result_;
};

}  // namespace dmp::mesher
