// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/geometry.hpp"
#include "geometry/nearest_triangle.hpp"
#include "mesher/mesh.hpp"
#include "mesher/space_lattice.hpp"

namespace dmp {

/// Builds the particle set of a 3-D drawing: fluids fill their solids, walls stand behind the surfaces they are named
/// after, or fill the outer layers of a solid of that name. Where solids overlap, walls take the room first, then
/// fluids in the order of the scene's parts.
class SpaceBuilder {
  public:
    SpaceBuilder(const Geometry& geometry, const Scene& scene);

    /// Makes ready for the nearest points of surfaces, which all that follows asks for.
    void sort_triangles();
    /// Every piece of a fluid's surface must be closed off: by a wall, another fluid, a periodic side or a plane of
    /// symmetry. Throws InputError with the area and place of one that is not.
    void check_boundary() const;
    void add_fluid(const Part& part);
    /// Lattice points outside all fluid, at most `layers` spacings behind the surface. Where rigid parts meet, a point
    /// belongs to the nearest of them.
    void add_walls(const Part& part);
    [[nodiscard]] MeshResult finish();
    /// Lattice points in and about the box.
    [[nodiscard]] std::size_t candidates() const { return owner_.size(); }

  private:
    struct Wall {
        const Part* part;
        const TriangleSurface* surface;
        bool is_solid;     ///< the part is a body in the fluid, not the fluid's edge
        double thickness;  ///< how far the part reaches behind its surface [m]
        std::optional<NearestTriangle> nearest;
    };
    struct WallPoint {
        int wall = -1;  ///< index into walls_; -1: no wall reaches the point
        SurfacePoint surface;
    };

    struct WallParticle {
        Vec position, normal;
        double distance;
    };

    /// Returns how many points in the solid others have.
    std::size_t claim(const TriangleSurface& solid, std::int16_t owner);
    /// `last`: by wall, a point of its surface that was found nearby; it takes the new one.
    [[nodiscard]] WallPoint wall_at(const Vec& point, std::int16_t owner, std::vector<Vec>& last) const;
    void mark_band(const Wall& wall);
    void find_walls();
    [[nodiscard]] WallParticle wall_particle(const Vec& point, int wall, const SurfacePoint& surface) const;
    void make_room(std::size_t particles);
    [[nodiscard]] bool closes(const Vec& point, const Part& fluid) const;
    [[nodiscard]] std::int16_t owner_near(const Vec& place) const;
    void add_particle(const Vec& position, int part, double density);
    [[nodiscard]] bool is_beyond_a_plane(const Vec& point) const;
    template <class Visit>
    void for_each_point(const Visit& visit) const;

    const Geometry& geometry_;
    const Scene& scene_;
    double spacing_;
    std::vector<const Part*> fluids_;
    std::vector<Wall> walls_;
    std::vector<NearestTriangle> fluid_edges_;               ///< by fluid: what lies on its surface
    std::vector<std::vector<WallParticle>> wall_particles_;  ///< by wall; empty before find_walls()
    std::vector<std::size_t> taken_;                         ///< by fluid: points of its solid that others have
    MeshResult result_;
    std::optional<SpaceLattice> lattice_;
    /// By row, line and point of the lattice: the fluid (its index) or the solid wall (-2 less its index) that the
    /// point lies in; -1: none; the lowest number: none, but near a wall's surface.
    std::vector<std::int16_t> owner_;
};

/// The box around the fluid solids of the scene; along periodic axes exactly one period.
Box fluid_box_in_space(const Geometry& geometry, const Scene& scene);

}  // namespace dmp
