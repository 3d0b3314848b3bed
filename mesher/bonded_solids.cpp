// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/bonded_solids.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/length_text.hpp"
#include "geometry/exact_predicates.hpp"
#include "geometry/nearest_curve.hpp"
#include "geometry/segments.hpp"
#include "geometry/triangle_tree.hpp"
#include "mesher/bond_network.hpp"
#include "mesher/uses.hpp"
#include "particles/cell_grid.hpp"
#include "particles/cell_pieces.hpp"

namespace dmp::mesher {

namespace {

/// A part's drawn area or volume.
class CadSolid {
  public:
    /// @param reach the longest bond that is asked for [m]
    CadSolid(const Geometry& geometry, const Part& part, double reach) {
        const Region* region = geometry.region(part.name);
        if (region == nullptr) {
            surface_.emplace(geometry.solid(part.name)->surface);
            return;
        }
        CurveSet outline;
        for_each_segment(*region, [&](const Vec& a, const Vec& b) { outline.pieces.push_back({{a, b}, false}); });
        edge_.emplace(outline, reach);
        outline_ = std::move(outline);
    }
    /// Whether a bond of two places in it goes out of it on its way.
    [[nodiscard]] bool is_left_between(const Vec& a, const Vec& b) const {
        if (surface_) {
            const auto hit = surface_->first_hit(a, b - a, [](int) { return true; });
            return hit && hit->distance < 1;
        }
        const auto nearest = edge_->nearest(0.5 * (a + b));
        if (!nearest || nearest->distance > 0.5 * (b - a).norm()) return false;
        return std::ranges::any_of(outline_.pieces, [&](const Polyline& piece) {
            return segments_cross(a, b, piece.points[0], piece.points[1]);
        });
    }

  private:
    CurveSet outline_;                     ///< in 2-D, a piece a segment
    std::optional<NearestCurve> edge_;     ///< of it
    std::optional<TriangleTree> surface_;  ///< in 3-D
};

/// The particles of a part, by number.
std::vector<std::size_t> members_of(const ParticleSet& set, int part) {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.part[i] == part) members.push_back(i);
    return members;
}

/// Fills that move particles hold a solid's in its shape by what is around it; where there is nothing, it swells.
constexpr double farthest_outside = 0.25;  // [spacings]

void need_particles_within(const ParticleSet& set, const std::vector<std::size_t>& members, const Geometry& geometry,
                           const Part& part) {
    const Vec far = Vec::Constant(std::numeric_limits<double>::infinity());
    Box drawn{far, -far};
    const auto add = [&](const Vec& point) {
        drawn.low = drawn.low.cwiseMin(point);
        drawn.high = drawn.high.cwiseMax(point);
    };
    if (const Region* region = geometry.region(part.name))
        for_each_segment(*region, [&](const Vec& a, const Vec& /*b*/) { add(a); });
    else
        std::ranges::for_each(geometry.solid(part.name)->surface.corners, add);
    for (const std::size_t i : members) {
        const Vec& at = set.position[i];
        const double outside = std::max((drawn.low - at).maxCoeff(), (at - drawn.high).maxCoeff());
        if (outside <= farthest_outside * set.spacing) continue;
        throw InputError(part.bonds_within.location,
                         "a particle of '" + *part.name + "' at " + position_text(at, set.dimension) + " was moved " +
                             length_text(outside) +
                             " out of the drawn part: no liquid and no wall is there that "
                             "would hold it",
                         "leave out bonds_within: cells keep the drawn shape; or write particles.fill = \"lattice\"");
    }
}

/// All bonds that may be, without stiffness.
std::vector<Bond> bonds_among(const ParticleSet& set, const std::vector<std::size_t>& members, double reach,
                              const CadSolid& solid) {
    Coordinates points;
    for (int axis = 0; axis < 3; ++axis)
        for (const std::size_t i : members) points[axis].push_back(set.position[i][axis]);
    const CellGrid grid(points, members.size(), set.dimension, reach);
    std::vector<Bond> bonds;
    for (const std::size_t i : members) {
        const Vec& here = set.position[i];
        std::set<int> partners;
        grid.for_each_near({here.x(), here.y(), here.z()}, reach, [&](int k) {
            const std::size_t j = members[static_cast<std::size_t>(k)];
            if (j > i && (set.position[j] - here).norm() <= (1 + 1e-9) * reach &&
                !solid.is_left_between(here, set.position[j]))
                partners.insert(static_cast<int>(j));
        });
        for (const int j : partners)
            bonds.push_back({static_cast<int>(i), j, (set.position[static_cast<std::size_t>(j)] - here).norm(), 0});
    }
    return bonds;
}

void need_bonds_of_all(const ParticleSet& set, const std::vector<std::size_t>& members, const std::vector<Bond>& bonds,
                       const Part& part) {
    std::vector<std::uint8_t> bonded(set.size(), 0);
    for (const Bond& bond : bonds)
        bonded[static_cast<std::size_t>(bond.a)] = bonded[static_cast<std::size_t>(bond.b)] = 1;
    const auto alone = std::ranges::find_if(members, [&](std::size_t i) { return bonded[i] == 0; });
    if (alone == members.end()) return;
    std::ostringstream problem;
    problem << "a particle of '" << *part.name << "' at " << position_text(set.position[*alone], set.dimension)
            << " has no other within " << length_text(*part.bonds_within) << ", bonds_within";
    throw InputError(part.bonds_within.location, problem.str(), "write 1.2 to 2 spacings, or refine particles.spacing");
}

}  // namespace

void bond_solids(MeshResult& result, const Geometry& geometry, const Scene& scene) {
    ParticleSet& set = result.particles;
    bool any = false;
    for (const Part* part : scene.parts_of(PartKind::elastic)) {
        if (!part->bonds_within.given()) continue;
        any = true;
        const std::vector<std::size_t> members = members_of(set, set.part_named(part->name));
        need_particles_within(set, members, geometry, *part);
        std::vector<Bond> bonds =
            bonds_among(set, members, part->bonds_within, CadSolid(geometry, *part, part->bonds_within));
        need_bonds_of_all(set, members, bonds, *part);
        double volume = 0;
        for (const std::size_t i : members) volume += set.volume[i];
        const auto line = std::ranges::find(result.report.springs, *part->name, &MeshReport::SpringLine::part);
        line->network = set_stiffness(bonds, set.position, part->youngs_modulus, volume, set.dimension);
        line->bonds = bonds.size();
        set.bonds.insert(set.bonds.end(), bonds.begin(), bonds.end());
        DisjointSets together(set.size());
        for (const Bond& bond : bonds)
            together.join(static_cast<std::size_t>(bond.a), static_cast<std::size_t>(bond.b));
        line->bodies =
            static_cast<int>(std::ranges::count_if(members, [&](std::size_t i) { return together.find(i) == i; }));
    }
    if (any) number_bodies(set);
}

void number_bodies(ParticleSet& set) {
    DisjointSets together(set.size());
    join_cells(set, together);
    for (const Bond& bond : set.bonds)
        together.join(static_cast<std::size_t>(bond.a), static_cast<std::size_t>(bond.b));
    std::vector<int> body_of(set.size(), -1);  // by the lowest particle, of a wall or not
    int bodies = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::elastic) continue;
        int& body = body_of[together.find(i)];
        if (body < 0) body = bodies++;
        set.body[i] = body;
    }
}

}  // namespace dmp::mesher
