// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// All sweeps for one vector unit. Compiled once for each, with its instructions switched on and DMP_SWEEPS_FOR the name
// of the function that makes them. Everything that is compiled here carries the type of the lanes in its name, so that
// no part of it can stand in for another unit's (a test looks).
#include "solver/sweeps/compiled_sweeps.hpp"

#include <algorithm>
#include <cmath>

#include "particles/kernels.hpp"
#include "solver/sweeps/density_sweep.hpp"
#include "solver/sweeps/force_sweep.hpp"
#include "solver/sweeps/lanes.hpp"
#include "solver/sweeps/near_sweep.hpp"

namespace dmp {

namespace {

/// Calls then(std::bool_constant<flag>), so that a run-time switch picks a compiled variant.
template <class Then>
void with_flag(bool flag, const Then& then) {
    if (flag) {
        then(std::true_type{});
    } else {
        then(std::false_type{});
    }
}

template <class L, int D, class Kernel>
class Sweeps final : public PairSweeps {
  public:
    explicit Sweeps(const PairSettings& settings)
        : settings_(settings),
          kernel_(settings.support),
          diffusion_(settings.density_diffusion, settings.support, settings.sound_speed),
          shifting_(settings.shifting, settings.support, settings.spacing, kernel_),
          repulsion_{settings.repulsion_strength},
          force_rounding_(largest_force()),
          density_rounding_{OrderFree(settings.density * volume() * steepest() * settings.sound_speed),
                            OrderFree(1.2 * volume() * steepest())} {}

    void forces(ParticleStore& particles, const ClusterList& list, const std::array<double, 3>& body_acceleration,
                ClusterChoice choice) const override {
        with_flag(settings_.repulsion_strength > 0, [&](auto contact) {
            const auto run = [&](const auto& solid) {
                ForceSweep<L, D, Kernel, std::decay_t<decltype(solid)>, decltype(contact)::value>(
                    particles, list, kernel_, solid, repulsion_, force_rounding_, settings_.threads)
                    .run(choice);
            };
            if (settings_.walls == WallModel::plain) {
                run(PlainSolid<D>{});
            } else {
                with_flag(settings_.slip_walls || settings_.moving_walls, [&](auto motion) {
                    ExtrapolatedSolid<D, decltype(motion)::value> solid{{}, 0.5 * settings_.spacing};
                    for (int axis = 0; axis < D; ++axis) {
                        solid.acceleration[axis] = body_acceleration[axis];
                        solid.driven[axis] = settings_.periodic[axis] ? body_acceleration[axis] : 0;
                    }
                    run(solid);
                });
            }
        });
    }

    void density_rates(ParticleStore& particles, const ClusterList& list, ClusterChoice choice) const override {
        if (settings_.slip_walls) {  // rare: one variant with diffusion, of whatever strength
            with_flag(settings_.shifting > 0, [&](auto shifting) {
                DensitySweep<L, D, Kernel, ExtrapolatedSolid<D, true>, true, decltype(shifting)::value>(
                    particles, list, kernel_, diffusion_, shifting_, density_rounding_, settings_.threads)
                    .run(choice);
            });
            return;
        }
        with_flag(settings_.density_diffusion > 0, [&](auto diffusion) {
            with_flag(settings_.shifting > 0, [&](auto shifting) {
                with_flag(settings_.walls == WallModel::plain, [&](auto plain) {
                    using Solid = std::conditional_t<decltype(plain)::value, PlainSolid<D>, ExtrapolatedSolid<D>>;
                    DensitySweep<L, D, Kernel, Solid, decltype(diffusion)::value, decltype(shifting)::value>(
                        particles, list, kernel_, diffusion_, shifting_, density_rounding_, settings_.threads)
                        .run(choice);
                });
            });
        });
    }

    void keep_near(const ParticleStore& particles, ClusterList& list, double reach) const override {
        NearSweep<L, D>(particles, list, reach, settings_.threads).run();
    }

    [[nodiscard]] double sound_limit() const override { return Kernel::sound_limit; }
    [[nodiscard]] double viscous_limit() const override { return Kernel::viscous_limit; }
    [[nodiscard]] double kernel_value(double r) const override { return kernel_.value(r); }
    [[nodiscard]] double kernel_slope(double r) const override { return kernel_.slope(r); }
    [[nodiscard]] double shift_step(double largest_speed, double dt) const override {
        return shifting_.step(largest_speed, dt);
    }
    [[nodiscard]] double longest_shift() const override { return shifting_.longest(); }

  private:
    [[nodiscard]] double volume() const { return std::pow(settings_.spacing, D); }
    /// Largest |dW/dr| [1/m^(D+1)].
    [[nodiscard]] double steepest() const {
        double largest = 0;
        for (int k = 1; k < 100; ++k) {
            const double r = 0.01 * k * settings_.support;
            largest = std::max(largest, -kernel_.slope(r) * r);
        }
        return largest;
    }
    /// Of one pair: by a pressure that compresses the liquid by a tenth, by viscosity at a tenth of the sound speed
    /// between neighbours, or in contact [N].
    [[nodiscard]] double largest_force() const {
        const double c0 = settings_.sound_speed;
        const double pressure = 0.1 * settings_.density * c0 * c0;
        const double viscous = settings_.viscosity * 0.1 * c0 / settings_.spacing;
        return std::max(2 * (pressure + viscous) * volume() * volume() * steepest(),
                        10 * settings_.repulsion_strength / settings_.spacing);
    }

    PairSettings settings_;
    Kernel kernel_;
    DensityDiffusion diffusion_;
    Shifting<Kernel> shifting_;
    Repulsion repulsion_;
    OrderFree force_rounding_;
    DensityRounding density_rounding_;
};

template <class L, int D>
std::unique_ptr<PairSweeps> sweeps_in(const PairSettings& settings) {
    if (settings.kernel == KernelKind::lucy) return std::make_unique<Sweeps<L, D, Lucy<D>>>(settings);
    return std::make_unique<Sweeps<L, D, WendlandC2<D>>>(settings);
}

}  // namespace

std::unique_ptr<PairSweeps> DMP_SWEEPS_FOR(const PairSettings& settings, int dimension) {
    return dimension == 3 ? sweeps_in<Lanes, 3>(settings) : sweeps_in<Lanes, 2>(settings);
}

}  // namespace dmp
