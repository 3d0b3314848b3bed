// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// All sweeps for one vector unit, with the default kernel or with any. Compiled once for each combination, with the
// unit's instructions enabled and DMP_VECTOR_UNIT and DMP_KERNEL_LOOPS as their names. Every symbol compiled here has
// the type of the lanes or the unit in its name, so that the linker cannot replace it by another unit's (a test checks
// this).
#include "solver/sweeps/compiled_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "base/simd/lanes.hpp"
#include "models/sph/kernels.hpp"
#include "models/sph/no_viscosity.hpp"
#include "models/sph/viscous_laws.hpp"
#include "scene/corrected_kernels.hpp"
#include "solver/sweeps/any_kernel.hpp"
#include "solver/sweeps/correction_sweep.hpp"
#include "solver/sweeps/density_sweep.hpp"
#include "solver/sweeps/force_sweep.hpp"
#include "solver/sweeps/fused_diffusion.hpp"
#include "solver/sweeps/gradient_sweep.hpp"
#include "solver/sweeps/level_sweep.hpp"
#include "solver/sweeps/prune_sweep.hpp"
#include "solver/sweeps/species_sweep.hpp"
#include "solver/sweeps/summation_sweep.hpp"
#include "solver/sweeps/transport_sweep.hpp"
#include "solver/sweeps/viscous_sweep.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

/// Calls then(std::bool_constant<flag>), so that a run-time flag selects a compiled variant.
template <class Then>
void with_flag(bool flag, const Then& then) {
    if (flag) {
        then(std::true_type{});
    } else {
        then(std::false_type{});
    }
}

template <class Kernel>
Kernel kernel_for(const PairSettings& settings) {
    if constexpr (std::is_constructible_v<Kernel, double>) {
        return Kernel(settings.support);
    } else {
        return Kernel(settings.kernel, settings.support);
    }
}

/// `Corrected`: the corrected scheme can be chosen.
template <class L, int D, class Kernel, bool Corrected>
class Sweeps final : public PairSweeps {
  public:
    explicit Sweeps(const PairSettings& settings)
        : settings_(settings),
          kernel_(kernel_for<Kernel>(settings)),
          scales_(models::viscous_scales(D, settings.spacing, settings.support,
                                         [this](double r) { return kernel_.slope(r); })),
          steepest_(steepest()),
          diffusion_(settings.density.diffusion, settings.support, settings.sound_speed),
          shifting_(settings.shifting, settings.support, settings.spacing, kernel_),
          repulsion_{settings.repulsion_strength},
          force_rounding_(largest_force()),
          density_rounding_{ReproducibleSum(settings.density.largest * volume() * steepest_ * settings.sound_speed),
                            ReproducibleSum(1.2 * volume() * steepest_),
                            ReproducibleSum(volume() * steepest_ * settings.support)},
          summation_rounding_(settings.density.largest * volume() * kernel_.value(0.0)),
          correction_rounding_{density_rounding_.divergence, force_rounding_, density_rounding_.rate},
          gradient_rounding_{density_rounding_.divergence, ReproducibleSum(volume() * steepest_ * settings.sound_speed),
                             ReproducibleSum(settings.density.largest * volume() * steepest_),
                             // 1/r dW/dr at r = 0 is 3.2 times the steepest dW/dr over dx (WendlandC2).
                             ReproducibleSum(4 * settings.density.largest * volume() * steepest_ / settings.spacing),
                             density_rounding_.shift} {}

    void forces(ParticleStore& particles, const ClusterList& list, const ForceSums& sums,
                ClusterChoice choice) const override {
        const auto sweep_with = [&](const auto& viscosity) {
            const auto run = [&](const auto& solid) {
                ForceSweep<L, D, Kernel, std::decay_t<decltype(solid)>, std::decay_t<decltype(viscosity)>>(
                    particles, list, kernel_, solid, viscosity, repulsion_, !settings_.surface_contact, force_rounding_,
                    settings_.threads)
                    .run(choice);
            };
            with_solid(sums.body_acceleration, sums.subtracted, run);
        };
        const bool newtonian = is_newtonian();
        if (newtonian && settings_.viscosity.implicit) {
            with_newtonian_mean([&]<class Mean>() { sweep_with(NewtonianGradientTerm<Mean>{{sums.dt}}); });
        } else if (newtonian) {
            with_newtonian_mean([&]<class Mean>() { sweep_with(NewtonianTerm<Mean>{{sums.dt}}); });
        } else if (settings_.viscosity.implicit) {
            sweep_with(NoViscosity{});
        } else {
            with_published_viscosity(sweep_with);
        }
        if (settings_.gradient_correction) {
            const auto solid = extrapolated(sums.body_acceleration);
            corrected(particles, list, solid).forces(choice);
        }
        if (settings_.transport_velocity)
            TransportSweep<L, D, Kernel>(particles, list, kernel_, force_rounding_, density_rounding_.shift,
                                         settings_.threads)
                .run(choice);
    }

    void level_forces(ParticleStore& particles, const ClusterList& list, const ReferencePressure& reference,
                      ClusterChoice choice) const override {
        LevelSweep<L, D, Kernel>(particles, list, kernel_, reference, force_rounding_, settings_.threads).run(choice);
    }

    void density_rates(ParticleStore& particles, const ClusterList& list,
                       const std::array<double, 3>& body_acceleration, ClusterChoice choice,
                       const SpeciesSums* along) const override {
        const HydrostaticDiffusion<D> hydrostatic_diffusion(settings_.density.diffusion, settings_.support,
                                                            settings_.sound_speed, narrowed(body_acceleration));
        const auto run_with = [&]<class Solid, DensityTerms with>(const auto& species) {
            DensitySweep<L, D, Kernel, Solid, with, std::decay_t<decltype(species)>>(
                particles, list, kernel_, diffusion_, hydrostatic_diffusion, shifting_, density_rounding_, species,
                settings_.threads)
                .run(choice);
        };
        const auto run = [&]<class Solid, DensityTerms with>() {
            run_with.template operator()<Solid, with>(NoSpecies{});
        };
        if (along != nullptr) {  // always with diffusion, even of strength 0
            with_flag(settings_.shifting > 0, [&](auto shifting) {
                with_flag(settings_.hydrostatic, [&](auto hydrostatic) {
                    constexpr DensityTerms with{.diffusion = true,
                                                .shifting = decltype(shifting)::value,
                                                .hydrostatic = decltype(hydrostatic)::value,
                                                .species = true};
                    const FusedDiffusion<L, D, with.shifting> species(particles, *along, volume(), steepest_);
                    with_solid_at_rest([&]<class Solid>() { run_with.template operator()<Solid, with>(species); });
                });
            });
        } else {
            with_density_terms(run);
        }
        if (settings_.gradient_correction && !settings_.density.by_summation) {
            const auto solid = extrapolated(body_acceleration);
            corrected(particles, list, solid).rates(choice);
        }
    }

    void gradients(ParticleStore& particles, const ClusterList& list, const std::array<double, 3>& body_acceleration,
                   ClusterChoice choice) const override {
        if constexpr (Corrected) {
            with_flag(settings_.several_fluids, [&](auto several) {
                with_flag(!settings_.walls.at_rest(), [&](auto motion) {
                    const auto solid = extrapolated<decltype(motion)::value>(body_acceleration);
                    GradientSweep<L, D, Kernel, std::decay_t<decltype(solid)>, decltype(several)::value>(
                        particles, list, kernel_, solid, shifting_, gradient_rounding_,
                        {diffusion_.coefficient, settings_.sound_speed, settings_.shifting > 0, settings_.free_surface},
                        settings_.threads)
                        .run(choice);
                });
            });
        } else {
            not_for_this_kernel();
        }
    }

    [[nodiscard]] bool can_fuse(const SpeciesSums& sums) const override {
        return !settings_.corrected && sums.diffusivity >= 0 && !sums.with_rigid && !sums.with_elastic &&
               (settings_.shifting > 0) == (sums.shift_per_sum != 0) && !settings_.walls.slip &&
               !settings_.density.by_summation && !settings_.transport_velocity;
    }

    void densities(ParticleStore& particles, const ClusterList& list, std::span<const double> rest_density,
                   ClusterChoice choice) const override {
        SummationSweep<L, D, Kernel>(particles, list, kernel_, summation_rounding_, rest_density, settings_.threads)
            .run(choice);
    }

    void corrections(ParticleStore& particles, const ClusterList& list, ClusterChoice choice) const override {
        const auto solid = extrapolated({});
        corrected(particles, list, solid).matrices(choice);
    }

    void viscous_forces(ParticleStore& particles, const ClusterList& list, const ViscousMotion& motion,
                        ClusterChoice choice) const override {
        const ReproducibleSum rounding(motion.largest_term);
        with_viscous_sweep(particles, list, rounding, motion.velocity, motion.of_walls,
                           [&](auto sweep) { sweep.forces(choice); });
    }

    void viscous_diagonal(ParticleStore& particles, const ClusterList& list, ClusterChoice choice) const override {
        const ReproducibleSum rounding(2 * settings_.viscosity.largest * volume() * volume() * steepest_ /
                                       settings_.spacing);
        with_viscous_sweep(particles, list, rounding, Field::velocity, 0, [&](auto sweep) { sweep.diagonal(choice); });
    }

    void species(ParticleStore& particles, const SpeciesPairs& pairs, const SpeciesSums& sums) const override {
        const SpeciesDiffusion diffusion{0.5 * settings_.spacing};
        with_flag(sums.diffusivity >= 0, [&](auto alike) {
            SpeciesSweep<L, D, Kernel, decltype(alike)::value>(particles, pairs, kernel_, sums, diffusion,
                                                               settings_.threads)
                .run();
        });
    }

    void prune(const ParticleStore& particles, ClusterList& list, double reach) const override {
        PruneSweep<L, D>(particles, list, reach, settings_.threads).run();
    }

    [[nodiscard]] double sound_limit() const override { return kernel_.sound_limit; }
    [[nodiscard]] double viscous_limit() const override {
        const auto share = [&]<class Law>() { return Law(scales_).step_share(); };
        return settings_.viscosity.law.visit(share) * kernel_.viscous_limit;
    }
    [[nodiscard]] ViscousScales viscous_scales() const override { return scales_; }
    [[nodiscard]] double diffusion_limit() const override { return kernel_.viscous_limit; }
    [[nodiscard]] double kernel_value(double r) const override { return kernel_.value(r); }
    [[nodiscard]] double kernel_slope(double r) const override { return kernel_.slope(r); }
    [[nodiscard]] double shift_step(double quartic_mean_speed, double largest_speed, double dt) const override {
        if (settings_.transport_velocity) return TransportVelocity::step(settings_.sound_speed, dt);
        if (settings_.shifting == 0) return 0;
        const double speed = shifting_.speed(quartic_mean_speed, largest_speed);
        if (!settings_.corrected) return shifting_.step(speed, dt);
        const double c0 = settings_.sound_speed;
        return shifting_.step_by_sound(settings_.free_surface ? std::min(c0, 20 * speed) : c0, dt);
    }
    [[nodiscard]] double longest_shift() const override { return shifting_.longest(); }

  private:
    /// Calls then(term) with the viscous term of these settings, a law that needs no velocity gradient. Morris' law has
    /// its own loops, for fluids of like and of unlike viscosity; all others share one loop that selects the law at run
    /// time.
    template <class Then>
    void with_published_viscosity(const Then& then) const {
        const bool arithmetic = has_arithmetic_mean();
        if (!settings_.viscosity.law.is<MorrisViscosity>()) {
            then(AnyViscousTerm(settings_.viscosity.law, scales_, arithmetic));
        } else if (settings_.viscosity.unlike && !arithmetic) {
            then(ViscousTerm<MorrisViscosity, HarmonicMean>{MorrisViscosity(scales_)});
        } else {
            then(ViscousTerm<MorrisViscosity, ArithmeticMean>{MorrisViscosity(scales_)});
        }
    }

    [[nodiscard]] bool has_arithmetic_mean() const {
        switch (settings_.viscosity.mean) {
            case ViscosityMean::harmonic:
                return false;
            case ViscosityMean::arithmetic:
                return true;
        }
        __builtin_unreachable();  // no unlisted_value, as in AnyKernel
    }
    [[nodiscard]] bool is_newtonian() const { return settings_.viscosity.law.is<NewtonianViscosity>(); }
    [[noreturn]] static void not_for_this_kernel() {
        throw std::logic_error("the corrected scheme is not compiled for this kernel");
    }

    /// Calls then<Mean>() with the mean of unlike viscosities, for the law of the corrected scheme; the cheaper one
    /// where all are alike.
    template <class Then>
    void with_newtonian_mean(const Then& then) const {
        if constexpr (!Corrected) {
            not_for_this_kernel();
        } else if (settings_.viscosity.unlike && !has_arithmetic_mean()) {
            then.template operator()<HarmonicMean>();
        } else {
            then.template operator()<ArithmeticMean>();
        }
    }

    /// Calls run<Solid, terms>() with the wall model and the terms of the density rates for these settings.
    template <class Run>
    void with_density_terms(const Run& run) const {
        if (settings_.density.by_summation) {
            constexpr DensityTerms shifts{.rate = false, .shifting = true, .hydrostatic = true};
            if (settings_.shifting > 0) run.template operator()<ExtrapolatedSolid<D>, shifts>();
            return;
        }
        if (settings_.walls.slip) {  // rare: always with diffusion, even of strength 0
            with_flag(settings_.shifting > 0, [&](auto shifting) {
                with_flag(settings_.hydrostatic, [&](auto hydrostatic) {
                    constexpr DensityTerms with{.diffusion = true,
                                                .shifting = decltype(shifting)::value,
                                                .hydrostatic = decltype(hydrostatic)::value};
                    run.template operator()<ExtrapolatedSolid<D, true>, with>();
                });
            });
            return;
        }
        with_flag(settings_.density.diffusion > 0 || settings_.hydrostatic, [&](auto diffusion) {
            with_flag(settings_.shifting > 0, [&](auto shifting) {
                with_flag(settings_.hydrostatic, [&](auto hydrostatic) {
                    with_solid_at_rest([&]<class Solid>() {
                        constexpr DensityTerms with{.diffusion = decltype(diffusion)::value,
                                                    .shifting = decltype(shifting)::value,
                                                    .hydrostatic = decltype(hydrostatic)::value};
                        // The hydrostatic correction always includes diffusion, if need be of strength 0.
                        if constexpr (with.diffusion || !with.hydrostatic) run.template operator()<Solid, with>();
                    });
                });
            });
        });
    }

    template <class Run>
    void with_viscous_sweep(ParticleStore& particles, const ClusterList& list, const ReproducibleSum& rounding,
                            Field velocity, double wall_motion, const Run& run) const {
        const auto with_term = [&](const auto& then) {
            if (is_newtonian()) {
                with_newtonian_mean([&]<class Mean>() { then(NewtonianVelocityTerm<Mean>{}); });
            } else {
                with_published_viscosity(then);
            }
        };
        with_term([&](const auto& viscosity) {
            const auto run_with = [&](const auto& solid) {
                run(ViscousSweep<L, D, Kernel, std::decay_t<decltype(solid)>, std::decay_t<decltype(viscosity)>>(
                    particles, list, kernel_, solid, viscosity, {rounding, velocity, wall_motion}, settings_.threads));
            };
            with_solid({}, {}, run_with);
        });
    }

    /// Calls then(solid) with the wall model of these settings.
    template <class Then>
    void with_solid(const std::array<double, 3>& body_acceleration, const std::array<double, 3>& subtracted,
                    const Then& then) const {
        switch (settings_.walls.model) {
            case WallModel::plain:
                then(PlainSolid<D>{});
                return;
            case WallModel::extrapolated:
                with_flag(!settings_.walls.at_rest(), [&](auto motion) {
                    then(extrapolated<decltype(motion)::value>(body_acceleration, subtracted));
                });
                return;
        }
    }
    /// Calls then<Solid>() with the wall model's type where no wall moves or lets the fluid slip.
    template <class Then>
    void with_solid_at_rest(const Then& then) const {
        switch (settings_.walls.model) {
            case WallModel::plain:
                then.template operator()<PlainSolid<D>>();
                return;
            case WallModel::extrapolated:
                then.template operator()<ExtrapolatedSolid<D>>();
                return;
        }
    }

    static Vector<double, D> narrowed(const std::array<double, 3>& v) {
        Vector<double, D> narrow;
        for (int axis = 0; axis < D; ++axis) narrow[axis] = v[axis];
        return narrow;
    }
    template <bool Motion = false>
    [[nodiscard]] ExtrapolatedSolid<D, Motion> extrapolated(const std::array<double, 3>& body_acceleration,
                                                            const std::array<double, 3>& subtracted = {}) const {
        ExtrapolatedSolid<D, Motion> solid{narrowed(body_acceleration), 0.5 * settings_.spacing};
        solid.subtracted = narrowed(subtracted);
        if constexpr (Motion)
            for (int axis = 0; axis < D; ++axis)
                solid.driven[axis] = settings_.periodic[axis] ? body_acceleration[axis] : 0;
        return solid;
    }
    [[nodiscard]] auto corrected(ParticleStore& particles, const ClusterList& list,
                                 const ExtrapolatedSolid<D>& solid) const {
        return CorrectionSweep<L, D, Kernel, ExtrapolatedSolid<D>>(particles, list, kernel_, solid,
                                                                   correction_rounding_, settings_.threads);
    }

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
    /// Largest expected force of one pair [N]: by a pressure that compresses the fluid by a tenth, by viscosity at a
    /// tenth of the sound speed between neighbours, or by contact.
    [[nodiscard]] double largest_force() const {
        const double c0 = settings_.sound_speed;
        const double pressure = 0.1 * settings_.density.largest * c0 * c0 + settings_.background_pressure;
        // Where viscosity is solved for, the Newtonian law's part in the gradients stays among the forces.
        const bool elsewhere = settings_.viscosity.implicit && !settings_.viscosity.law.is<NewtonianViscosity>();
        const double viscous = elsewhere ? 0 : settings_.viscosity.largest * 0.1 * c0 / settings_.spacing;
        return std::max(2 * (pressure + viscous) * volume() * volume() * steepest_,
                        10 * settings_.repulsion_strength / settings_.spacing);
    }

    PairSettings settings_;
    Kernel kernel_;
    ViscousScales scales_;
    double steepest_;  ///< largest |dW/dr| [1/m^(D+1)]
    DensityDiffusion diffusion_;
    Shifting<Kernel> shifting_;
    Repulsion repulsion_;
    ReproducibleSum force_rounding_;
    DensityRounding density_rounding_;
    ReproducibleSum summation_rounding_;
    CorrectionRounding correction_rounding_;
    GradientRounding gradient_rounding_;
};

template <class L, KernelLoops loops, int D>
std::unique_ptr<PairSweeps> sweeps_with(const PairSettings& settings) {
    if constexpr (loops == KernelLoops::wendland_c2) {
        return std::make_unique<Sweeps<L, D, WendlandC2<D>, has_corrected_scheme(KernelKind::wendland_c2)>>(settings);
    } else {
        static_assert(loops == KernelLoops::any);
        return std::make_unique<Sweeps<L, D, AnyKernel<L, D>, false>>(settings);
    }
}

}  // namespace

template <VectorUnit unit, KernelLoops loops>
std::unique_ptr<PairSweeps> compiled_sweeps(const PairSettings& settings, int dimension) {
    return dimension == 3 ? sweeps_with<Lanes, loops, 3>(settings) : sweeps_with<Lanes, loops, 2>(settings);
}

template std::unique_ptr<PairSweeps> compiled_sweeps<VectorUnit::DMP_VECTOR_UNIT, KernelLoops::DMP_KERNEL_LOOPS>(
    const PairSettings& settings, int dimension);

}  // namespace dmp::solver
