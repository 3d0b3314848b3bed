// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/sweeps/pair_sweeps.hpp"

#include "particles/kernels.hpp"
#include "solver/sweeps/density_sweep.hpp"
#include "solver/sweeps/force_sweep.hpp"

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

template <int D, class Kernel>
class Sweeps final : public PairSweeps {
  public:
    explicit Sweeps(const PairSettings& settings)
        : settings_(settings),
          kernel_(settings.support),
          diffusion_(settings.density_diffusion, settings.support, settings.sound_speed),
          shifting_(settings.shifting, settings.support, settings.spacing, kernel_),
          repulsion_{settings.repulsion_strength} {}

    void forces(ParticleStore& particles, const ClusterList& list,
                const std::array<double, 3>& body_acceleration) const override {
        if (settings_.walls == WallModel::plain) {
            ForceSweep<D, Kernel, PlainSolid<D>>(particles, list, kernel_, {}, repulsion_, settings_.threads).run();
        } else {
            ExtrapolatedSolid<D> solid{{}, 0.5 * settings_.spacing};
            for (int axis = 0; axis < D; ++axis) solid.acceleration[axis] = body_acceleration[axis];
            ForceSweep<D, Kernel, ExtrapolatedSolid<D>>(particles, list, kernel_, solid, repulsion_, settings_.threads)
                .run();
        }
    }

    void density_rates(ParticleStore& particles, const ClusterList& list) const override {
        with_flag(settings_.density_diffusion > 0, [&](auto diffusion) {
            with_flag(settings_.shifting > 0, [&](auto shifting) {
                const bool plain = settings_.walls == WallModel::plain;
                const double solid_weight =
                    plain ? PlainSolid<D>::approach_weight : ExtrapolatedSolid<D>::approach_weight;
                DensitySweep<D, Kernel, decltype(diffusion)::value, decltype(shifting)::value> sweep(
                    particles, list, kernel_, diffusion_, shifting_, solid_weight, settings_.threads);
                sweep.fluid();
                if (plain) sweep.solids();
            });
        });
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
    PairSettings settings_;
    Kernel kernel_;
    DensityDiffusion diffusion_;
    Shifting<Kernel> shifting_;
    Repulsion repulsion_;
};

}  // namespace

std::unique_ptr<PairSweeps> make_pair_sweeps(const PairSettings& settings, ParticleStore& particles) {
    particles.declare({Field::density, Field::density_rate, Field::pressure, Field::viscosity, Field::contact_range,
                       Field::wall_contact_range});
    if (settings.shifting > 0) particles.declare({Field::shift});
    if (settings.walls == WallModel::extrapolated) particles.declare({Field::wall_normal, Field::wall_distance});
    if (settings.kernel == KernelKind::lucy) return std::make_unique<Sweeps<2, Lucy<2>>>(settings);
    return std::make_unique<Sweeps<2, WendlandC2<2>>>(settings);
}

}  // namespace dmp
