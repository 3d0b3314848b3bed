// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "solver/output/velocity_gradient.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Von Mises' equivalent stress (3/2 s : s)^(1/2) of a symmetric stress [Pa], s its deviator.
double von_mises(const std::array<double, 6>& stress);

/// One array over this rank's fluid, in the store's order, components interleaved.
struct FluidValues {
    std::string name, unit;
    int components = 1;  ///< 1, 3 or 6
    std::vector<double> values;
};

/// Whether a particle lies beyond a plane of symmetry across this axis: a frame then shows its image.
bool is_shown_mirrored(const ParticleGroup& particles, const ParticleSpace& space, int axis, std::size_t i);

/// Where a particle is shown: within the periodic box, and on the fluid's side of planes of symmetry [m].
Vec shown_place(const ParticleGroup& particles, const ParticleSpace& space, std::size_t i);

/// What the frames and probes show of the fluid, worked out when it is asked for (docs/results.md):
///   velocity, pressure, density   as they are
///   stress         sigma = -p I + mu (grad v + grad v^T) [Pa]
///   shear_stress   mu (2 D : D)^(1/2) [Pa], D = (grad v + grad v^T) / 2
///   von_mises      of sigma [Pa]
///   vorticity      curl v [1/s]; in 2-D its z alone
///   residence_time in each region [s], an array a region
///   concentration  of each species, an array a species
/// All as they are where the particle is shown.
/// The velocity gradient is worked out once for all that need it.
class FluidFields {
  public:
    FluidFields(const Scene& scene, const ParticleStore& particles, const FluidStep& step)
        : scene_(scene), particles_(particles), step_(step) {}

    /// The arrays of a field: one, or for residence_time one a region. All ranks ask for the same.
    [[nodiscard]] std::vector<FluidValues> of(FluidField field);

    /// Whether neighbours are needed, as they are now.
    [[nodiscard]] static bool need_neighbours(FluidField field);

  private:
    [[nodiscard]] FluidValues stored(Field field) const;
    [[nodiscard]] std::vector<FluidValues> residence_times() const;
    [[nodiscard]] std::vector<FluidValues> concentrations() const;
    [[nodiscard]] const std::vector<Eigen::Matrix3d>& gradient();
    [[nodiscard]] std::array<double, 6> stress(std::size_t i);
    /// values_of(i) gives the components of particle i.
    template <class ValuesOf>
    [[nodiscard]] FluidValues each(const char* name, const char* unit, int components, const ValuesOf& values_of);

    const Scene& scene_;
    const ParticleStore& particles_;
    const FluidStep& step_;
    std::optional<std::vector<Eigen::Matrix3d>> gradient_;
};

}  // namespace dmp::solver
