// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "solver/models/contact/repulsion.hpp"
#include "solver/models/sph/morris_viscosity.hpp"
#include "solver/models/sph/pressure_force.hpp"
#include "solver/models/sph/walls.hpp"
#include "solver/sweeps/point_reader.hpp"

namespace dmp {

/// Sums pressure, viscous and contact forces over the neighbours of each cluster.
template <int D, class Kernel, class Solid>
class ForceSweep {
  public:
    ForceSweep(ParticleStore& particles, const ClusterList& list, const Kernel& kernel, const Solid& solid,
               const Repulsion& repulsion, int threads)
        : particles_(particles),
          list_(list),
          kernel_(kernel),
          solid_(solid),
          repulsion_(repulsion),
          with_contact_(repulsion.strength > 0),
          threads_(threads),
          read_(particles),
          range_(particles.data(Field::contact_range)),
          wall_range_(particles.data(Field::wall_contact_range)) {}

    void run() {
        sweep(ParticleKind::fluid, [this](const Cluster& cluster) { return force_on_fluid(cluster); });
        sweep(ParticleKind::rigid, [this](const Cluster& cluster) { return force_on_rigid(cluster); });
        sweep(ParticleKind::springs, [this](const Cluster& cluster) { return force_on_springs(cluster); });
    }

  private:
    using Force = Vector<Lanes, D>;

    template <class ForceOn>
    void sweep(ParticleKind kind, const ForceOn& force_on) {
        const auto clusters = list_.clusters(kind);
        const auto count = static_cast<std::ptrdiff_t>(clusters.size());
#pragma omp parallel for num_threads(threads_) schedule(static)
        for (std::ptrdiff_t c = 0; c < count; ++c)
            store<D>(force_on(clusters[c]), particles_, Field::force, clusters[c]);
    }

    Force force_on_fluid(const Cluster& cluster) const {
        const auto i = read_.fluid(cluster);
        const Lanes range = load(range_, cluster);
        Force force = Force::zero();
        for (const int index : list_.neighbours(cluster, ParticleKind::fluid)) {
            const auto j = read_.fluid(index);
            force += fluid_pair(i, j, i.position - j.position);
        }
        for (const int index : list_.neighbours(cluster, ParticleKind::rigid)) {
            const auto wall = read_.template solid<Solid::needs_surface>(index);
            const auto from_wall = i.position - wall.position;
            force += fluid_pair(i, solid_.rigid(i, wall, from_wall), from_wall);
            if (with_contact_) force += repulsion_.law(from_wall, min(range, Lanes(range_[index])));
        }
        for (const int index : list_.neighbours(cluster, ParticleKind::springs)) {
            const auto body = read_.template solid<false>(index);
            const auto from_body = i.position - body.position;
            force += fluid_pair(i, solid_.springs(i, body, from_body), from_body);
            if (with_contact_) force += repulsion_.law(from_body, min(range, Lanes(range_[index])));
        }
        return force;
    }

    /// The reaction to what the fluid feels, and contact with spring bodies.
    Force force_on_rigid(const Cluster& cluster) const {
        const auto wall = read_.template solid<Solid::needs_surface>(cluster);
        Force force = contact(cluster, wall.position, ParticleKind::springs, wall_range_);
        force += contact(cluster, wall.position, ParticleKind::fluid, range_);
        for (const int index : list_.neighbours(cluster, ParticleKind::fluid)) {
            const auto j = read_.fluid(index);
            const auto from_wall = j.position - wall.position;
            force -= fluid_pair(j, solid_.rigid(j, wall, from_wall), from_wall);
        }
        return force;
    }

    Force force_on_springs(const Cluster& cluster) const {
        const auto body = read_.template solid<false>(cluster);
        Force force = contact(cluster, body.position, ParticleKind::fluid, range_);
        force += contact(cluster, body.position, ParticleKind::rigid, wall_range_);
        force += contact(cluster, body.position, ParticleKind::springs, range_);
        for (const int index : list_.neighbours(cluster, ParticleKind::fluid)) {
            const auto j = read_.fluid(index);
            const auto from_body = j.position - body.position;
            force -= fluid_pair(j, solid_.springs(j, body, from_body), from_body);
        }
        return force;
    }

    /// Repulsion by the particles of one kind; `ranges` holds r* by particle.
    Force contact(const Cluster& cluster, const Vector<Lanes, D>& position, ParticleKind kind,
                  const double* ranges) const {
        const Lanes range = load(ranges, cluster);
        Force force = Force::zero();
        if (!with_contact_) return force;
        for (const int index : list_.neighbours(cluster, kind)) {
            const auto j = read_.template solid<false>(index);
            force += repulsion_.law(position - j.position, min(range, Lanes(ranges[index])));
        }
        return force;
    }

    template <class I, class J>
    Force fluid_pair(const I& i, const J& j, const Vector<Lanes, D>& separation) const {
        const Lanes distance = sqrt(dot(separation, separation));
        const Pair pair{i, j, separation, distance, kernel_.slope(distance)};
        return PressureForce::law(pair) + MorrisViscosity::law(pair);
    }

    ParticleStore& particles_;
    const ClusterList& list_;
    const Kernel& kernel_;
    const Solid& solid_;
    const Repulsion& repulsion_;
    bool with_contact_;
    int threads_;
    PointReader<D> read_;
    const double *range_, *wall_range_;  ///< r* by particle: of any contact; between spring bodies and walls [m]
};

}  // namespace dmp
