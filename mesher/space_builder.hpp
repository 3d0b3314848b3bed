// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/geometry.hpp"
#include "geometry/nearest_triangle.hpp"
#include "mesher/body_surfaces.hpp"
#include "mesher/fit_particles.hpp"
#include "mesher/mesh.hpp"
#include "mesher/solid_cells.hpp"
#include "mesher/solid_on_boxes.hpp"
#include "mesher/space_lattice.hpp"
#include "mesher/spring_bodies.hpp"
#include "mesher/uses.hpp"
#include "mesher/vacancy.hpp"

namespace dmp::mesher {

/// Builds the particle set of a 3-D geometry: fluids fill their solids, walls stand behind the surfaces they are named
/// after, or fill the outer layers of a solid of that name; springs fill their solids, or stand to both sides of
/// surfaces as shells. Where solids overlap, walls take the room first, then springs, then fluids in the order of the
/// scene's parts.
class SpaceBuilder {
  public:
    SpaceBuilder(const Geometry& geometry, const Scene& scene);

    /// Makes ready for the nearest points of surfaces, which all that follows asks for.
    void sort_triangles();
    /// Every piece of a fluid's surface must be closed off: by a wall, another fluid, a solid of springs, a periodic
    /// side or a plane of symmetry. Throws InputError with the area and place of one that is not.
    void check_boundary() const;
    /// From here on, faces of rigid parts that touch each other, or lie outside of the fluid, count as their inside:
    /// where a body stands flush on a wall, particles look for the nearest face that fluid sees.
    void leave_out_hidden_faces();
    /// Before all others, so that what bonds join keeps its numbers.
    void add_elastic(const Part& part);
    void add_fluid(const Part& part);
    /// Lattice points outside all fluid, at most `layers` spacings behind the surface, that do not overlap a body.
    /// Where rigid parts meet, a point belongs to the nearest of them.
    void add_walls(const Part& part);
    /// Moves the fluid from the lattice to places at random that keep their distance.
    void sample();
    /// Moves fluid and walls until they follow the surfaces.
    void fit();
    /// Whether fluid that is moved to make room for bodies may stand there.
    [[nodiscard]] bool may_stand(const Vec& point) const;
    [[nodiscard]] ParticleSet& particles() { return result_.particles; }
    [[nodiscard]] MeshResult finish();
    /// Elastic parts that have become shells.
    [[nodiscard]] std::vector<Sheet> sheets() const;
    /// Lattice points in and about the box.
    [[nodiscard]] std::size_t candidates() const { return owner_.size(); }

  private:
    /// What of a wall's surface faces fluid.
    struct Facing {
        TriangleSurface surface;
        NearestTriangle nearest;
    };
    struct Wall {
        const Part* part;
        const TriangleSurface* surface;
        bool is_solid;     ///< the part is a body in the fluid, not the fluid's edge
        double thickness;  ///< how far the part reaches behind its surface, until it is fitted [m]
        NearestTriangle nearest{};
        std::optional<Facing> facing{};  ///< none: all of it

        [[nodiscard]] const TriangleSurface& face() const { return facing ? facing->surface : *surface; }
        [[nodiscard]] const NearestTriangle& nearest_face() const { return facing ? facing->nearest : nearest; }
    };
    struct WallPoint {
        int wall = -1;  ///< index into walls_; -1: no wall reaches the point
        int face = -1;  ///< index of the wall whose surface it is: that one, but where bodies touch walls
        SurfacePoint surface{};
    };

    /// In owner_: none; none, but near a wall's surface; a shell, or a solid of springs without a cell there; the solid
    /// wall with this index in walls_, and after them the solids of springs.
    static constexpr std::int16_t nobody = -1, nobody_near_a_wall = std::numeric_limits<std::int16_t>::min(),
                                  in_a_shell = nobody_near_a_wall + 1;
    static constexpr std::int16_t owner_of_wall(std::size_t wall) {
        return static_cast<std::int16_t>(-2 - static_cast<int>(wall));
    }
    struct WallParticle {
        Vec position, normal;
        double distance;
    };
    struct SpringSolid {
        const Part* part;
        std::vector<Vec> points;
        std::optional<SolidCells> cells{};  ///< where it is made of them
    };
    /// A solid of springs that is a sheet: it becomes a shell.
    struct ThinSolid {
        const Part* part;
        Part shell;  ///< the same, with the thickness that was drawn
        TriangleSurface middle;
    };

    /// Returns how many points in the solid others have.
    std::size_t claim(const TriangleSurface& solid, std::int16_t owner);
    std::size_t claim_by_vote(const TriangleSurface& solid, std::int16_t owner);
    void claim_elastic(const Part& part, const Solid& solid);
    void claim_points(const Part& part, const Solid& solid);
    void claim_cells(const Part& part, const Solid& solid);
    void claim_box(const Vec& low, const Vec& size);
    /// The surface that a part is clamped to; null: none.
    [[nodiscard]] const TriangleSurface* anchor_of(const Part& part) const;
    void clamp_cells(const Part& part, SolidCells& cells) const;
    void add_cells(SpringSolid& solid, int part, MeshReport::SpringLine& line);
    /// Whether liquid is to fill what solids of cells leave of the boxes that their surface cuts.
    [[nodiscard]] bool fills_beside_cells() const;
    /// What was added beside cells.
    struct Added {
        std::size_t particles = 0;
        double volume = 0;            ///< more than lattice points have [m^3]
        std::size_t left_points = 0;  ///< drawn as liquid that cells' boxes have
    };
    /// Adds the liquid that lattice points leave out there, and gives all particles of the part an equal share of its
    /// volume.
    Added fill_beside_cells(const Part& part, int number);
    struct CutBox;
    [[nodiscard]] std::vector<CutBox> boxes_cut_by_cells(const BoxLattice& boxes,
                                                         const std::vector<SolidOnBoxes>& solids, int fluid) const;
    void look_into(CutBox& cut, const BoxLattice& boxes, const Vacancy& vacancy, int fluid) const;
    /// False where the solid is thick enough for cells; throws InputError where it is thin, and no sheet.
    bool take_as_sheet(const Part& part, const Solid& solid);
    void clear_for_shell(const TriangleSurface& sheet);
    void clear_wedges();
    void add_body(const SpringBody& body, int part, MeshReport::SpringLine& line);
    void clamp(const Part& part, std::size_t first, MeshReport::SpringLine& line);
    [[nodiscard]] Vec lattice_step() const { return {lattice_->step()[0], lattice_->step()[1], lattice_->step()[2]}; }
    static Vec normal_of(const TriangleSurface& surface, int triangle);
    /// Whether the lattice point nearest to a place is a rigid body's.
    [[nodiscard]] bool is_in_a_body(const Vec& position) const;
    /// The place in the box that it is an image of.
    [[nodiscard]] Vec in_the_box(Vec position) const;
    /// The nearest point that faces fluid (or may, `hidden`) of the walls that counts(index into walls_) is true for,
    /// no further than they are thick. `last`, if given: by wall, a point of its surface that was found nearby; it
    /// takes the new one.
    template <class Counts>
    [[nodiscard]] WallPoint surface_at(const Vec& point, const Counts& counts, std::vector<Vec>* last = nullptr,
                                       bool hidden = false) const;
    [[nodiscard]] WallPoint surface_at(const Vec& point) const {
        return surface_at(point, [](std::size_t) { return true; });
    }
    /// The same for a lattice point of which `owner_` says who owns it: the wall that it may belong to.
    [[nodiscard]] WallPoint wall_at(const Vec& point, std::int16_t owner, std::vector<Vec>& last) const;
    [[nodiscard]] FitBounds bounds() const;
    [[nodiscard]] bool is_in_a_shell(const Vec& point) const;
    [[nodiscard]] bool is_in_a_wedge(const Vec& point) const;
    [[nodiscard]] Vec into_fluid(const Vec& position, int face, int triangle) const;
    void mark_band(const Wall& wall);
    void find_walls();
    [[nodiscard]] WallParticle wall_particle(const Vec& point, int face, const SurfacePoint& surface) const;
    void make_room(std::size_t particles);
    [[nodiscard]] bool closes(const Vec& point, const Part& fluid) const;
    [[nodiscard]] std::int16_t owner_near(const Vec& position) const;
    void add_particle(const Vec& position, int part, double density);
    [[nodiscard]] bool is_beyond_a_plane(const Vec& point) const;
    template <class Visit>
    void for_each_point(const Visit& visit) const;

    const Geometry& geometry_;
    const Scene& scene_;
    double spacing_;
    std::vector<const Part*> fluids_;
    std::vector<Wall> walls_;
    std::vector<SpringSolid> spring_solids_;
    std::vector<std::size_t> in_no_cell_;  ///< points in solids of springs that no whole cell has
    std::vector<ThinSolid> thin_solids_;
    std::vector<NearestTriangle> shells_;                    ///< as far as their nodes keep fluid away
    bool has_hidden_faces_ = false;                          ///< of some wall
    int bodies_ = 0;                                         ///< connected pieces of springs so far
    std::vector<NearestTriangle> fluid_edges_;               ///< by fluid: what lies on its surface
    std::vector<NearestTriangle> spring_faces_;              ///< by solid of springs, the same
    std::vector<std::vector<WallParticle>> wall_particles_;  ///< by wall; empty before find_walls()
    std::vector<std::size_t> taken_;                         ///< by fluid: points of its solid that others have
    MeshResult result_;
    std::optional<SpaceLattice> lattice_;
    /// By row, line and point of the lattice: the fluid (its index), the solid or the shell that the point lies in, or
    /// nobody.
    std::vector<std::int16_t> owner_;
};

template <class Counts>
SpaceBuilder::WallPoint SpaceBuilder::surface_at(const Vec& point, const Counts& counts, std::vector<Vec>* last,
                                                 bool hidden) const {
    WallPoint best;
    const auto nearest_from = [&](const Vec& shift) {
        for (std::size_t w = 0; w < walls_.size(); ++w) {
            if (!counts(w)) continue;
            const NearestTriangle& surface = hidden ? walls_[w].nearest : walls_[w].nearest_face();
            auto found = last != nullptr ? surface.nearest(point + shift, (*last)[w]) : surface.nearest(point + shift);
            if (found && last != nullptr) (*last)[w] = found->point;
            if (!found || found->distance >= walls_[w].thickness) continue;
            if (best.wall >= 0 && best.surface.distance <= found->distance) continue;
            found->point -= shift;
            best = {static_cast<int>(w), static_cast<int>(w), *found};
        }
    };
    nearest_from(Vec::Zero());
    const ParticleSet& set = result_.particles;
    for (int axis = 0; axis < 3; ++axis) {
        if (!set.periodic.at(static_cast<std::size_t>(axis))) continue;
        Vec shift = Vec::Zero();
        for (const double period : {set.box.extent()[axis], -set.box.extent()[axis]}) {
            shift[axis] = period;
            nearest_from(shift);
        }
    }
    return best;
}

template <class Visit>
void SpaceBuilder::for_each_point(const Visit& visit) const {
    std::size_t index = 0;
    for (std::size_t row = 0; row < lattice_->rows().size(); ++row)
        for (int line = 0; line < lattice_->rows()[row].lines; ++line)
            for (int point = 0; point < lattice_->points(); ++point)
                visit(owner_[index++], [&] { return lattice_->at(row, line, point); });
}

/// The box around the fluid solids of the scene; along periodic axes exactly one period.
Box fluid_box_in_space(const Geometry& geometry, const Scene& scene);

}  // namespace dmp::mesher
