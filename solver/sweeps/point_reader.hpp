// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/models/pair.hpp"
#include "solver/neighbours/cluster_list.hpp"
#include "solver/store/particle_store.hpp"

namespace dmp {

/// One value of a particle, or those of a cluster's members side by side.
inline double load(const double* values, int index) { return values[index]; }
inline Lanes load(const double* values, const Cluster& cluster) { return Lanes::gather(values, cluster.member.data()); }

template <int D, class Index>
auto load(const std::array<const double*, D>& values, const Index& at) {
    Vector<decltype(load(values[0], at)), D> vector;
    for (int axis = 0; axis < D; ++axis) vector[axis] = load(values[axis], at);
    return vector;
}

template <int D>
void store(const Vector<Lanes, D>& value, ParticleStore& particles, Field field, const Cluster& cluster) {
    for (int axis = 0; axis < D; ++axis)
        value[axis].scatter(particles.data(field, axis), cluster.member.data(), cluster.count);
}

/// Reads particles from the store in the form that pair laws take.
template <int D>
class PointReader {
  public:
    explicit PointReader(const ParticleStore& particles)
        : position_(vector(particles, Field::position)),
          velocity_(vector(particles, Field::velocity)),
          normal_(vector(particles, Field::wall_normal)),
          volume_(particles.data(Field::volume)),
          density_(particles.data(Field::density)),
          pressure_(particles.data(Field::pressure)),
          viscosity_(particles.data(Field::viscosity)),
          depth_(particles.data(Field::wall_distance)) {}

    template <class Index>
    [[nodiscard]] auto fluid(const Index& at) const {
        using T = decltype(load(volume_, at));
        return FluidPoint<T, D>{load<D>(position_, at), load<D>(velocity_, at), load(volume_, at),
                                load(density_, at),     load(pressure_, at),    load(viscosity_, at)};
    }
    /// `WithSurface`: also the wall's normal and depth (rigid particles of extrapolated walls).
    template <bool WithSurface, class Index>
    [[nodiscard]] auto solid(const Index& at) const {
        using T = decltype(load(volume_, at));
        SolidPoint<T, D> point{load<D>(position_, at),
                               load<D>(velocity_, at),
                               load(volume_, at),
                               load(density_, at),
                               load(pressure_, at),
                               Vector<T, D>::zero(),
                               T(0.0)};
        if constexpr (WithSurface) {
            point.normal = load<D>(normal_, at);
            point.depth = load(depth_, at);
        }
        return point;
    }

  private:
    static std::array<const double*, D> vector(const ParticleStore& particles, Field field) {
        std::array<const double*, D> axes{};
        for (int axis = 0; axis < D; ++axis) axes[axis] = particles.data(field, axis);
        return axes;
    }

    std::array<const double*, D> position_, velocity_, normal_;
    const double *volume_, *density_, *pressure_, *viscosity_, *depth_;
};

}  // namespace dmp
