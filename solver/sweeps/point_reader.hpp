// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "base/simd/vector.hpp"
#include "models/pair.hpp"
#include "solver/neighbours/space_order.hpp"
#include "solver/store/particle_group.hpp"

namespace dmp::solver {

/// One value of a particle, or the values of a cluster's members in lanes.
template <class L>
double load(const double* values, std::int32_t index) {
    return values[index];
}
template <class L>
L load(const double* values, const Cluster& cluster) {
    return L::load(values + cluster.first);
}
template <class L, int D, class Index>
auto load_vector(const std::array<const double*, D>& values, const Index& at) {
    Vector<decltype(load<L>(values[0], at)), D> vector;
    for (int axis = 0; axis < D; ++axis) vector[axis] = load<L>(values[axis], at);
    return vector;
}

template <class L, int D>
void store(const Vector<L, D>& value, ParticleGroup& group, Field field, const Cluster& cluster) {
    for (int axis = 0; axis < D; ++axis)
        value[axis].store(group.data(field, axis) + cluster.first, static_cast<std::size_t>(cluster.count));
}

template <int D>
std::array<const double*, D> axes_of(const ParticleGroup& group, Field field) {
    std::array<const double*, D> axes{};
    for (int axis = 0; axis < D; ++axis) axes[axis] = group.data(field, axis);
    return axes;
}

/// Reads fluid particles in the form used by pair laws: a single one as numbers, a cluster in lanes L. `WithGradient`:
/// with the corrected velocity gradient. The pressure is the reduced one where there is one.
template <class L, int D, bool WithGradient = false>
class FluidReader {
  public:
    explicit FluidReader(const ParticleGroup& fluid)
        : position_(axes_of<D>(fluid, Field::position)),
          velocity_(axes_of<D>(fluid, Field::velocity)),
          volume_(fluid.data(Field::volume)),
          density_(fluid.data(Field::density)),
          pressure_(fluid.data(fluid.has(Field::reduced_pressure) ? Field::reduced_pressure : Field::pressure)),
          viscosity_(fluid.data(Field::viscosity)) {
        if constexpr (WithGradient) {
            correction_ = fluid.data(Field::mean_correction);
            for (int k = 0; k < D * D; ++k) gradient_[k] = fluid.data(Field::velocity_gradient, k);
        }
    }

    template <class Index>
    [[nodiscard]] auto operator()(const Index& at) const {
        using T = decltype(load<L>(volume_, at));
        FluidPoint<T, D> point{load_vector<L, D>(position_, at),
                               load_vector<L, D>(velocity_, at),
                               load<L>(volume_, at),
                               load<L>(density_, at),
                               load<L>(pressure_, at),
                               load<L>(viscosity_, at)};
        if constexpr (WithGradient) {
            point.correction = load<L>(correction_, at);
            for (int k = 0; k < D * D; ++k) point.gradient[k / D][k % D] = load<L>(gradient_[k], at);
        }
        return point;
    }

  private:
    std::array<const double*, D> position_, velocity_;
    const double *volume_, *density_, *pressure_, *viscosity_;
    const double* correction_ = nullptr;
    std::array<const double*, D * D> gradient_{};
};

/// Reads particles of walls and elastic bodies (see BodyReader for where their surfaces count). `WithState`: also
/// density and pressure (plain walls). `WithSurface`: also the wall's normal and depth (rigid particles of extrapolated
/// walls). `WithMotion`: also the wall's slip, acceleration, motion, sliding and gradient of the surface's velocity, if
/// the scene has them.
template <class L, int D, bool WithState, bool WithSurface, bool WithMotion = false>
class SolidReader {
  public:
    explicit SolidReader(const ParticleGroup& solid)
        : position_(axes_of<D>(solid, Field::position)),
          velocity_(axes_of<D>(solid, Field::velocity)),
          normal_(axes_of<D>(solid, Field::wall_normal)),
          volume_(solid.data(Field::volume)),
          density_(solid.data(Field::density)),
          pressure_(solid.data(Field::pressure)),
          depth_(solid.data(Field::wall_distance)),
          slip_(solid.data(Field::wall_slip)),
          sliding_(solid.data(Field::wall_sliding)),
          acceleration_(axes_of<D>(solid, Field::wall_acceleration)),
          motion_(axes_of<D>(solid, Field::wall_motion)),
          slips_(solid.has(Field::wall_slip)),
          accelerates_(solid.has(Field::wall_acceleration)),
          moves_(solid.has(Field::wall_motion)),
          slides_(solid.has(Field::wall_sliding)) {
        if (moves_) surface_gradient_ = axes_of<D * D>(solid, Field::surface_gradient);
    }

    template <class Index>
    [[nodiscard]] auto operator()(const Index& at) const {
        using T = decltype(load<L>(volume_, at));
        SolidPoint<T, D> point{load_vector<L, D>(position_, at),
                               load_vector<L, D>(velocity_, at),
                               load<L>(volume_, at),
                               T(0.0),
                               T(0.0),
                               Vector<T, D>::zero(),
                               T(0.0),
                               T(0.0),
                               Vector<T, D>::zero(),
                               Vector<T, D>::zero(),
                               T(0.0)};
        point.motion = point.velocity;
        if constexpr (WithState) {
            point.density = load<L>(density_, at);
            point.pressure = load<L>(pressure_, at);
        }
        if constexpr (WithSurface) {
            point.normal = load_vector<L, D>(normal_, at);
            point.depth = load<L>(depth_, at);
        }
        if constexpr (WithMotion) {
            if (slips_) point.slip = load<L>(slip_, at);
            if (accelerates_) point.acceleration = load_vector<L, D>(acceleration_, at);
            if (moves_) {
                point.motion = load_vector<L, D>(motion_, at);
                for (int k = 0; k < D * D; ++k)
                    point.surface_gradient[k / D][k % D] = load<L>(surface_gradient_[k], at);
            }
            if (slides_) point.sliding = load<L>(sliding_, at);
        }
        return point;
    }

  private:
    std::array<const double*, D> position_, velocity_, normal_;
    const double *volume_, *density_, *pressure_, *depth_, *slip_, *sliding_;
    std::array<const double*, D> acceleration_, motion_;
    std::array<const double*, D * D> surface_gradient_{};
    bool slips_, accelerates_, moves_, slides_;
};

/// Reads particles of elastic bodies. `WithSurface`: with their surface's normal, their depths behind it and the
/// gradient of the body's velocity.
template <class L, int D, bool WithState, bool WithSurface>
class BodyReader {
  public:
    explicit BodyReader(const ParticleGroup& bodies)
        : read_(bodies),
          opposite_(WithSurface ? bodies.data(Field::opposite_distance) : nullptr),
          held_(WithSurface ? bodies.data(Field::held) : nullptr),
          gradient_(WithSurface ? axes_of<D * D>(bodies, Field::surface_gradient)
                                : std::array<const double*, D * D>{}) {}

    template <class Index>
    [[nodiscard]] auto operator()(const Index& at) const {
        auto point = read_(at);
        if constexpr (WithSurface) {
            point.opposite = load<L>(opposite_, at);
            point.held = load<L>(held_, at);
            for (int k = 0; k < D * D; ++k) point.surface_gradient[k / D][k % D] = load<L>(gradient_[k], at);
        }
        return point;
    }

  private:
    SolidReader<L, D, WithState, WithSurface> read_;
    const double *opposite_, *held_;
    std::array<const double*, D * D> gradient_;
};

}  // namespace dmp::solver
