// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesher/mesh.hpp"

namespace dmp::mesher {

/// Builds the particle set of a scene of spheres part by part: walls, spheres whose places are given, those around
/// others, those that fill what is left of a box.
class SphereBuilder {
  public:
    explicit SphereBuilder(const Scene& scene);

    void add_plane(const Part& part);
    void add_surface(const Part& part);
    /// The part's spheres, which stand where it says (centres, positions, around, a box).
    void add_spheres(const Part& part);

    [[nodiscard]] ParticleSet& particles() { return result_.particles; }
    [[nodiscard]] MeshResult finish() { return std::move(result_); }

  private:
    struct Spheres {
        std::vector<Vec> centre;
        std::vector<double> radius;
        std::vector<Vec> velocity, spin;  ///< empty: by the part's formulas
        double coverage = 0;              ///< around: reached
    };

    int add_part(const Part& part, PartKind kind);
    [[nodiscard]] std::string path_of(const std::string& file) const;
    [[nodiscard]] Spheres listed(const Part& part) const;
    [[nodiscard]] Spheres around(const Part& part) const;
    [[nodiscard]] Spheres filled(const Part& part) const;
    void start(const Part& part, Spheres& spheres) const;
    [[nodiscard]] double rest_overlap(const Part& inner, const Part& part, double inner_radius, double radius) const;
    [[nodiscard]] std::uint64_t seed_of(int part) const;

    const Scene& scene_;
    MeshResult result_;
};

}  // namespace dmp::mesher
