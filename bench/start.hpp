// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/uses.hpp"
#include "particles/particle_set.hpp"
#include "scene/scene.hpp"

namespace dmp::bench {

/// The liquid of all starts and what drives it: blood in a narrow channel.
struct Liquid {
    static constexpr double spacing = 1e-4;       ///< dx [m]
    static constexpr double density = 1056;       ///< at rest [kg/m^3]
    static constexpr double viscosity = 3.5e-3;   ///< dynamic [Pa s]
    static constexpr double sound_speed = 10;     ///< c0 [m/s]
    static constexpr double speed = 0.13;         ///< all of the liquid flows along x with it [m/s]
    static constexpr double acceleration = 0.25;  ///< along x [m/s^2]
};

/// A channel between two plane walls of fixed particles, normal to y; periodic along x and, in 3-D, along z.
struct Channel {
    int dimension = 2;
    bool disordered = false;          ///< fluid particles displaced from their lattice
    std::size_t particles = 100'000;  ///< fluid particles asked for; `make_particles` comes near
    FluidScheme scheme = FluidScheme::plain;
    KernelKind kernel = KernelKind::wendland_c2;
    double support = 2.5;  ///< [dx]
    WallModel walls = WallModel::plain;
    double density_diffusion = 0;  ///< delta; 0: none
    double shifting = 0;           ///< s; 0: none
    double contact_range = 0;      ///< [dx]; 0: none
    bool implicit_viscosity = false;
    int species = 0;                     ///< that diffuse in the liquid
    std::vector<std::string> overrides;  ///< of the scene's keys, as `dmp run --set` has them
};

/// Largest displacement along each axis of a disordered start [dx].
inline constexpr double largest_displacement = 0.3;

/// Gives the channel what a scene with this scheme has where it leaves the numerics and the repulsion open.
void use_defaults_of_scenes(Channel& channel, FluidScheme scheme);

/// The particles: rows along x from the lower wall to the upper, walls as many layers as the support needs. In 2-D the
/// channel is four times as long as wide; in 3-D it is nearly a cube. It is at least 8 spacings wide.
ParticleSet make_particles(const Channel& channel);

/// The scene that goes with them. Particle sets carry no velocity, so the body force gets the liquid up to speed in the
/// first steps, and lists of neighbours then wear out as they do in a flow.
std::string scene_text(const Channel& channel);

/// The text read. Throws InputError where dmp cannot do it (yet).
Scene make_scene(const Channel& channel);

/// A number in [-1, 1) that depends on the three alone.
double noise(std::uint64_t seed, std::uint64_t id, std::uint64_t axis);

}  // namespace dmp::bench
