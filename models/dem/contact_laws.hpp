// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "models/dem/bradley.hpp"
#include "models/dem/contact_law_list.hpp"
#include "models/dem/dmt.hpp"
#include "models/dem/hertz.hpp"
#include "models/dem/jkr.hpp"
#include "models/dem/mindlin.hpp"
#include "models/dem/no_adhesion.hpp"
#include "models/dem/rolling_friction.hpp"

namespace dmp::models {

struct ContactModel {
    NormalLaw normal;
    TangentialLaw tangential;
    RollingLaw rolling;
    AdhesionLaw adhesion;

    /// Whether the laws can be combined: an adhesive normal law cannot be combined with an adhesion law.
    [[nodiscard]] constexpr bool is_consistent() const {
        return !(normal.visit([]<class Law>() { return Law::adhesive; }) &&
                 adhesion.visit([]<class Law>() { return Law::adhesive; }));
    }
    /// Whether bodies attract each other.
    [[nodiscard]] constexpr bool is_adhesive() const {
        return normal.visit([]<class Law>() { return Law::adhesive; }) ||
               adhesion.visit([]<class Law>() { return Law::adhesive; });
    }
    friend constexpr bool operator==(const ContactModel&, const ContactModel&) = default;
};

/// The model with these laws.
template <class Normal = HertzContact, class Tangential = RescaledHistory, class Rolling = NoRolling,
          class Adhesion = NoAdhesion>
inline constexpr ContactModel model_of{NormalLaw::of<Normal>(), TangentialLaw::of<Tangential>(),
                                       RollingLaw::of<Rolling>(), AdhesionLaw::of<Adhesion>()};

/// Returns visit.template operator()<Law>() for the adhesive one of the two laws, or `none` if there is none.
template <class Result, class Visit>
Result visit_adhesive_law(NormalLaw normal, AdhesionLaw adhesion, Result none, const Visit& visit) {
    const auto of = [&]<class Law>() -> Result {
        if constexpr (Law::adhesive) return visit.template operator()<Law>();
        return none;
    };
    const bool by_normal = normal.visit([]<class Law>() { return Law::adhesive; });
    return by_normal ? normal.visit(of) : adhesion.visit(of);
}

/// All combinations by number, inconsistent ones included.
inline constexpr std::size_t contact_models =
    NormalLaws::size * TangentialLaws::size * RollingLaws::size * AdhesionLaws::size;

constexpr ContactModel contact_model(std::size_t number) {
    const std::size_t tangential = number / NormalLaws::size, rolling = tangential / TangentialLaws::size,
                      adhesion = rolling / RollingLaws::size;
    return {NormalLaw(number % NormalLaws::size), TangentialLaw(tangential % TangentialLaws::size),
            RollingLaw(rolling % RollingLaws::size), AdhesionLaw(adhesion)};
}

constexpr std::size_t number_of(const ContactModel& model) {
    return model.normal.number() +
           NormalLaws::size *
               (model.tangential.number() +
                TangentialLaws::size * (model.rolling.number() + RollingLaws::size * model.adhesion.number()));
}

}  // namespace dmp::models
