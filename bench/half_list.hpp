// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "bench/uses.hpp"
#include "particles/particle_set.hpp"
#include "scene/scene.hpp"

namespace dmp::bench {

/// The yardstick: the plain loop over a half Verlet list that one writes in an afternoon, in double, without vector
/// instructions by hand and on one thread. Particles are sorted by cell and lie in memory as structures; the list, with
/// a skin of a tenth of the support, is built once; walls do not list walls; periodic copies stand behind the
/// particles. One sweep computes Tait's pressure of each particle, and for each pair pressure, Morris' viscosity and
/// continuity (Monaghan 1994; Morris, Fox & Zhu 1997), and adds to both.
class HalfList {
  public:
    virtual ~HalfList() = default;

    /// Forces and density rates of all particles, from nothing.
    virtual void sweep() = 0;

    [[nodiscard]] virtual std::size_t particles() const = 0;
    /// Pairs in the list; a pair across a periodic border counts once.
    [[nodiscard]] virtual std::size_t pairs_listed() const = 0;
    /// Those nearer than the support; each has a fluid particle.
    [[nodiscard]] virtual std::size_t pairs_within_support() const = 0;

    /// By the particle's index in the set that the list was made from.
    [[nodiscard]] virtual std::array<double, 3> force(std::size_t i) const = 0;  ///< [N]
    [[nodiscard]] virtual double density_rate(std::size_t i) const = 0;          ///< [kg/m^3/s]
};

/// What particle i of a start carries in a sweep: the liquid flows, everything has a little noise on it, so that no
/// term vanishes.
struct SweepState {
    std::array<double, 3> velocity{};  ///< [m/s]
    double density = 0;                ///< [kg/m^3]
};
SweepState sweep_state(const ParticleSet& set, std::size_t i);

/// `support` in m.
std::unique_ptr<HalfList> make_half_list(const ParticleSet& set, KernelKind kernel, double support);

}  // namespace dmp::bench
