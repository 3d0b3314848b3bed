// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Of the SpaceBuilder: which parts of walls' surfaces face fluid.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "geometry/nearest_triangle.hpp"
#include "geometry/surface_box.hpp"
#include "geometry/winding_number.hpp"
#include "mesher/facing_part.hpp"
#include "mesher/space_builder.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

namespace {

/// How far in front of a surface fluid is looked for, more than triangles are off the round face that two parts share;
/// how closely surfaces are looked at [spacings].
constexpr double in_front = 0.1, check_every = 0.5;

/// Whether places lie in a body, for many places next to its surface: the nearest triangle tells, where the place is
/// straight in front of or behind it. Elsewhere, and where there are holes, it is the winding number.
class BodyInside {
  public:
    BodyInside(const TriangleSurface& surface, double reach)
        : surface_(surface), nearest_(surface, reach), winding_(surface) {}

    [[nodiscard]] bool holds(const Vec& position) const {
        constexpr double straight = 0.99;
        const auto found = surface_.has_holes ? std::nullopt : nearest_.nearest(position);
        if (!found || found->distance == 0) return winding_.inside(position);
        const auto& [a, b, c] = surface_.triangles[static_cast<std::size_t>(found->triangle)];
        const auto corner = [&](int k) -> const Vec& { return surface_.corners[static_cast<std::size_t>(k)]; };
        const Vec normal = (corner(b) - corner(a)).cross(corner(c) - corner(a)).normalized();
        const double cosine = (position - found->point).dot(normal) / found->distance;
        return std::abs(cosine) > straight ? cosine < 0 : winding_.inside(position);
    }

  private:
    const TriangleSurface& surface_;
    NearestTriangle nearest_;
    WindingNumber winding_;
};

/// Where fluid is, by the geometry.
class CadFluid {
  public:
    CadFluid(const std::vector<const TriangleSurface*>& fluids, const std::vector<const TriangleSurface*>& solids,
             double reach) {
        for (const TriangleSurface* fluid : fluids) fluids_.emplace_back(*fluid, reach);
        for (const TriangleSurface* solid : solids) solids_.emplace_back(*solid, reach);
    }
    [[nodiscard]] bool at(const Vec& position) const {
        const auto holds = [&](const BodyInside& body) { return body.holds(position); };
        return std::ranges::any_of(fluids_, holds) && std::ranges::none_of(solids_, holds);
    }

  private:
    std::vector<BodyInside> fluids_, solids_;
};

bool meet(const Box& one, const Box& other, double margin) {
    return (one.low.array() <= other.high.array() + margin).all() &&
           (other.low.array() <= one.high.array() + margin).all();
}

}  // namespace

bool SpaceBuilder::is_in_a_body(const Vec& position) const {
    const std::int16_t owner = owner_near(position);
    for (std::size_t w = 0; w < walls_.size(); ++w)
        if (walls_[w].is_solid && owner == owner_of_wall(w)) return true;
    return false;
}

Vec SpaceBuilder::in_the_box(Vec position) const {
    const ParticleSet& set = result_.particles;
    for (int axis = 0; axis < 3; ++axis) {
        const double period = set.box.extent()[axis];
        if (set.periodic.at(static_cast<std::size_t>(axis)))
            position[axis] -= period * std::floor((position[axis] - set.box.low[axis]) / period);
        position[axis] = set.mirrored_back(position[axis], axis);
    }
    return position;
}

void SpaceBuilder::leave_out_hidden_faces() {
    std::vector<const TriangleSurface*> solids, fluids;
    for (const Wall& wall : walls_) {
        if (wall.part->moves()) return;  // what is hidden now may come out
        if (wall.is_solid) solids.push_back(wall.surface);
    }
    if (solids.empty() || fluids_.empty()) return;
    for (const Part* fluid : fluids_) fluids.push_back(&geometry_.solid(fluid->name)->surface);
    const CadFluid fluid(fluids, solids, 2 * spacing_);
    // Far from all others the lattice knows; next to them the geometry is asked, which takes longer.
    std::vector<NearestTriangle> within_a_spacing;
    for (const Wall& wall : walls_) within_a_spacing.emplace_back(*wall.surface, spacing_);
    const auto is_next_to_another = [&](const Wall& wall, const Vec& position) {
        for (std::size_t w = 0; w < walls_.size(); ++w) {
            if (&walls_[w] == &wall || (!wall.is_solid && !walls_[w].is_solid)) continue;
            if (within_a_spacing[w].nearest(position)) return true;
        }
        return false;
    };
    const auto faces_fluid = [&](const Vec& position, const Vec& outward) {
        return fluid.at(in_the_box(position + in_front * spacing_ * outward));
    };
    const auto is_seen = [&](const Wall& wall, const Vec& position, const Vec& outward) {
        const bool alone = !is_next_to_another(wall, position);
        if (wall.is_solid)
            return (alone && owner_near(position + spacing_ * outward) >= 0) || faces_fluid(position, outward);
        return alone ? !is_in_a_body(position) : faces_fluid(position, outward) || faces_fluid(position, -outward);
    };
    for (Wall& wall : walls_) {
        const Box box = box_of(*wall.surface);
        // A wall that no body touches is the fluid's edge all over.
        if (!wall.is_solid && std::ranges::none_of(solids, [&](const TriangleSurface* solid) {
                return meet(box, box_of(*solid), in_front * spacing_);
            }))
            continue;
        Facing facing{
            facing_part(*wall.surface, check_every * spacing_,
                        [&](const Vec& position, const Vec& outward) { return is_seen(wall, position, outward); }),
            {}};
        const double area = wall.surface->area(), hidden = area - facing.surface.area();
        if (hidden < spacing_ * spacing_) continue;
        facing.nearest = NearestTriangle(facing.surface, 1.001 * wall.thickness);
        wall.facing = std::move(facing);
        has_hidden_faces_ = true;
        std::ostringstream note;
        note.precision(3);
        note << wall.part->name.value << ": " << 100 * hidden / area
             << " % of its surface faces no fluid, as it touches other rigid parts or lies outside of the fluid";
        result_.report.notes.push_back(note.str());
    }
}

}  // namespace dmp::mesher
