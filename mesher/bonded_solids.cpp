// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/bonded_solids.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <sstream>

#include "base/disjoint_sets.hpp"
#include "base/length_text.hpp"
#include "geometry/inside_test.hpp"
#include "geometry/winding_number.hpp"
#include "mesher/bond_network.hpp"
#include "particles/cell_grid.hpp"

namespace dmp {

namespace {

/// A bond is looked at as often whether it is in the solid [spacings].
constexpr double looks_apart = 0.2;

/// A part's drawn area or volume.
class DrawnSolid {
  public:
    DrawnSolid(const Geometry& geometry, const Part& part, double spacing) : step_(looks_apart * spacing) {
        if (const Region* region = geometry.region(part.name))
            region_.emplace(*region);
        else
            winding_.emplace(geometry.solid(part.name)->surface);
    }
    /// Whether all that is between two places in it is in it, too.
    [[nodiscard]] bool holds_between(const Vec& a, const Vec& b) const {
        const auto looks = static_cast<int>(std::ceil((b - a).norm() / step_));
        for (int look = 1; look < looks; ++look) {
            const Vec place = a + static_cast<double>(look) / looks * (b - a);
            if (region_ ? region_->side_of(place) == Side::outside : !winding_->inside(place)) return false;
        }
        return true;
    }

  private:
    double step_;
    std::optional<InsideTest> region_;
    std::optional<WindingNumber> winding_;
};

/// The particles of a part, by number.
std::vector<std::size_t> members_of(const ParticleSet& set, int part) {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.part[i] == part) members.push_back(i);
    return members;
}

/// All bonds that may be, without stiffness.
std::vector<Bond> bonds_among(const ParticleSet& set, const std::vector<std::size_t>& members, double reach,
                              const DrawnSolid& solid) {
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
                solid.holds_between(here, set.position[j]))
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
    problem << "a particle of '" << *part.name << "' at " << place_text(set.position[*alone], set.dimension)
            << " has no other within " << length_text(*part.bonds_within) << ", bonds_within";
    throw InputError(part.bonds_within.place, problem.str(), "write 1.2 to 2 spacings, or refine particles.spacing");
}

}  // namespace

void bond_solids(MeshResult& result, const Geometry& geometry, const Scene& scene) {
    ParticleSet& set = result.particles;
    bool any = false;
    for (const Part* part : scene.parts_of(PartKind::springs)) {
        if (!part->bonds_within.given()) continue;
        any = true;
        const std::vector<std::size_t> members = members_of(set, set.part_named(part->name));
        std::vector<Bond> bonds =
            bonds_among(set, members, part->bonds_within, DrawnSolid(geometry, *part, set.spacing));
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
    for (const Bond& bond : set.bonds)
        together.join(static_cast<std::size_t>(bond.a), static_cast<std::size_t>(bond.b));
    std::vector<int> body_of(set.size(), -1);  // by the lowest particle, of a wall or not
    int bodies = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != ParticleKind::springs) continue;
        int& body = body_of[together.find(i)];
        if (body < 0) body = bodies++;
        set.body[i] = body;
    }
}

}  // namespace dmp
