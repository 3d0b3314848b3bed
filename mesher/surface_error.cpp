// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/surface_error.hpp"

#include <algorithm>
#include <cmath>

namespace dmp::mesher {

namespace {

/// Sums up a deviation; each place has a weight.
class Sums {
  public:
    void add(double deviation, double weight, const Vec& where) {
        ++line_.positions;
        weight_ += weight;
        sum_ += weight * deviation;
        squares_ += weight * deviation * deviation;
        if (!(std::abs(deviation) > line_.largest)) return;
        line_.largest = std::abs(deviation);
        line_.where = where;
    }
    [[nodiscard]] MeshReport::Deviation line() const {
        MeshReport::Deviation line = line_;
        if (weight_ > 0) {
            line.mean = sum_ / weight_;
            line.rms = std::sqrt(squares_ / weight_);
        }
        return line;
    }

  private:
    MeshReport::Deviation line_;
    double weight_ = 0, sum_ = 0, squares_ = 0;
};

struct Nearest {
    double square;
    Vec position;
};

/// The part's particle that is nearest to the point; where none is within the search, `square` is its square.
Nearest nearest_of(const ParticleSet& set, const SearchableParticles& search, int part, const Vec& point) {
    const double farthest = surface_search * set.spacing;
    // Most are within a spacing: look there first.
    for (const double radius : {set.spacing, farthest}) {
        Nearest best{radius * radius, point};
        bool any = false;
        search.for_each_near(point, radius, [&](std::size_t j, double square, const Vec& position) {
            if (set.part[j] != part || square >= best.square) return;
            best = {square, position};
            any = true;
        });
        if (any) return best;
    }
    return {farthest * farthest, point};
}

}  // namespace

MeshReport::SurfaceLine surface_error(const ParticleSet& set, const SearchableParticles& search,
                                      const CadSurface& surface, int part, std::vector<float>& error) {
    MeshReport::SurfaceLine line;
    line.part = set.parts[static_cast<std::size_t>(part)].name;
    Sums from_geometry, from_particles;
    for (const CadSurface::Sample& sample : surface.samples()) {
        const auto [square, position] = nearest_of(set, search, part, sample.point);
        const bool found = square < surface_search * surface_search * set.spacing * set.spacing;
        const double depth = found ? (sample.point - position).dot(sample.normal) / set.spacing : surface_search;
        from_geometry.add(depth - 0.5, sample.weight, sample.point);
        line.farthest = std::max(line.farthest, std::sqrt(square) / set.spacing);
    }
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.part[i] != part) continue;
        const auto nearest = surface.nearest(set.position[i]);
        if (!nearest || nearest->distance >= set.spacing) continue;
        const double deviation = nearest->distance / set.spacing - 0.5;
        error[i] = static_cast<float>(deviation);
        from_particles.add(deviation, 1, set.position[i]);
    }
    line.from_geometry = from_geometry.line();
    line.from_particles = from_particles.line();
    return line;
}

}  // namespace dmp::mesher
