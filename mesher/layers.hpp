// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "mesher/cad_surface.hpp"
#include "mesher/mesh.hpp"
#include "mesher/searchable_particles.hpp"

namespace dmp::mesher {

/// How far layers of fluid are counted [spacings].
inline constexpr double layers_of_fluid = 5;

/// Counts the layers of particles through walls and fluids. From places on fluids' drawn surfaces it walks along the
/// normal, outward through the wall and inward through the fluid, for as long as the nearest particle is of that part
/// and no further than the largest hole in a lattice is wide. Layers are how far it comes [spacings], at most as many
/// as were asked for; not from places within two spacings of a spring body, which has the room. Where a lattice runs
/// along the surface, exactly that; where it is cut at an angle, up to one less.
class LayerCount {
  public:
    /// @param search knows images within three spacings
    LayerCount(const ParticleSet& set, const Scene& scene, const SearchableParticles& search)
        : set_(set), scene_(scene), search_(search) {}

    /// From the surface of the fluid with this part number.
    void add(const CadSurface& surface, int fluid);
    /// One for each part that was met, by number.
    [[nodiscard]] std::vector<MeshReport::LayerLine> lines() const;

  private:
    struct Walks {
        double asked = 0, fewest = 0, sum = 0;
        std::size_t count = 0;
        Vec where = Vec::Zero();
    };
    template <class Counts>
    [[nodiscard]] int nearest_part(const Vec& point, double radius, const Counts& counts) const;
    [[nodiscard]] double asked_of(int part) const;
    [[nodiscard]] int behind(const Vec& point, int fluid) const;
    [[nodiscard]] bool is_near_a_body(const Vec& point) const;
    void walk(const Vec& from, const Vec& direction, int part);

    const ParticleSet& set_;
    const Scene& scene_;
    const SearchableParticles& search_;
    std::map<int, Walks> walks_;
};

}  // namespace dmp::mesher
