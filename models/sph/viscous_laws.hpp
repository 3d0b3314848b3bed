// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tuple>

#include "models/sph/cleary_viscosity.hpp"
#include "models/sph/fluid_law_list.hpp"
#include "models/sph/monaghan_viscosity.hpp"
#include "models/sph/morris_viscosity.hpp"
#include "models/sph/newtonian_viscosity.hpp"
#include "models/sph/viscosity_in_tension.hpp"
#include "models/sph/viscosity_means.hpp"

namespace dmp::models {

// A law of ViscousLaws is constructed from ViscousScales and has
//   law(pair, twice_mean)   the force on particle i [N], twice_mean: twice the mean of both viscosities [Pa s]
//   step_share()            largest stable explicit step divided by kernel.viscous_limit support^2 / nu [-]
//   on_lattice(scales)      ratio of effective to specified viscosity on the undisturbed lattice [-]
//   detail(nu, c0)          added text of `dmp explain` for a fluid of kinematic viscosity nu [m^2/s]; may be empty
//   linear                  whether the force is linear in the velocities, as implicit stepping requires
//   needs_gradient          whether it reads the corrected velocity gradient (left out: false)

template <class Law>
constexpr bool needs_gradient() {
    if constexpr (requires { Law::needs_gradient; }) {
        return Law::needs_gradient;
    } else {
        return false;
    }
}

/// A law combined with a mean, as the sweeps apply it.
template <class Law, class Mean>
struct ViscousTerm {
    static constexpr bool needs_gradient = models::needs_gradient<Law>();
    Law law_of_pair;

    template <class P>
    [[nodiscard]] auto law(const P& p) const {
        return law_of_pair.law(p, Mean::twice(p.i.viscosity, p.j.viscosity));
    }
};

/// The Newtonian law of the corrected scheme.
template <class Mean>
struct NewtonianTerm {
    static constexpr bool needs_gradient = true;
    ViscosityInTension tension;

    template <class P>
    [[nodiscard]] auto law(const P& p) const {
        return NewtonianViscosity::law(p, tension.at_least(p, Mean::twice(p.i.viscosity, p.j.viscosity)));
    }
};

/// The two parts of the Newtonian law, where the first is solved for implicitly. What tension adds to the viscosity is
/// explicit, as part of the second.
template <class Mean>
struct NewtonianVelocityTerm {
    static constexpr bool needs_gradient = true;
    template <class P>
    [[nodiscard]] auto law(const P& p) const {
        return NewtonianViscosity::law_of_velocities(p, Mean::twice(p.i.viscosity, p.j.viscosity));
    }
};
template <class Mean>
struct NewtonianGradientTerm {
    static constexpr bool needs_gradient = true;
    ViscosityInTension tension;

    template <class P>
    [[nodiscard]] auto law(const P& p) const {
        const auto own = Mean::twice(p.i.viscosity, p.j.viscosity);
        const auto all = tension.at_least(p, own);
        return NewtonianViscosity::law_of_gradients(p, all) + NewtonianViscosity::law_of_velocities(p, all - own);
    }
};

/// Any law of the registry with either mean, chosen at run time: one compiled loop for all combinations but the
/// default.
class AnyViscousTerm {
  public:
    static constexpr bool needs_gradient = false;

    AnyViscousTerm(ViscousLaw choice, const ViscousScales& scales, bool arithmetic_mean)
        : AnyViscousTerm(choice, scales, arithmetic_mean, std::make_index_sequence<ViscousLaws::size>{}) {}

    template <class P>
    [[nodiscard, gnu::always_inline]] auto law(const P& p) const {
        const auto harmonic = HarmonicMean::twice(p.i.viscosity, p.j.viscosity);
        const auto twice_mean =
            harmonic + arithmetic_ * (ArithmeticMean::twice(p.i.viscosity, p.j.viscosity) - harmonic);
        return choice_.visit([&]<class Law>() { return std::get<Law>(laws_).law(p, twice_mean); });
    }

  private:
    template <std::size_t... k>
    AnyViscousTerm(ViscousLaw choice, const ViscousScales& scales, bool arithmetic_mean, std::index_sequence<k...>)
        : choice_(choice), laws_(ViscousLaws::Law<k>(scales)...), arithmetic_(arithmetic_mean ? 1.0 : 0.0) {}

    template <class>
    struct Tuple;
    template <class... Laws>
    struct Tuple<Registry<Laws...>> {
        using Type = std::tuple<Laws...>;
    };

    ViscousLaw choice_;
    Tuple<ViscousLaws>::Type laws_;
    double arithmetic_;  ///< weight of the arithmetic mean relative to the harmonic mean: 1 or 0 [-]
};

}  // namespace dmp::models
