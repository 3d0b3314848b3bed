// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "scene/choices.hpp"
#include "scene/expression.hpp"
#include "scene/part.hpp"
#include "scene/value.hpp"

namespace dmp::scene {

/// [[force]]: a force on a part, while its schedule lasts.
struct ForceOnPart {
    Value<std::string> name;
    Value<std::string> part;                 ///< of fluid, springs or spheres
    Value<std::array<Expression, 3>> force;  ///< as functions of t, x, y, z [N]
    Value<ForceAmount> amount;               ///< total: spread evenly over the part's particles
    Value<double> from = 0.0;                ///< when it starts [s]
    Value<double> until;                     ///< when it ends [s]; not given: never
    Value<double> period = 0.0;              ///< of a schedule that begins anew [s]; 0: once
};

/// [[moving_shape]]: a curve that moves through the scene and softly pushes the parts that feel it, and no others.
struct MovingShape {
    Value<std::string> name;
    Value<ShapeKind> kind;
    Value<std::vector<std::string>> parts;      ///< that feel it: of fluid, springs or spheres
    Value<std::array<Expression, 3>> position;  ///< of the vertex or centre, as functions of t [m]
    Value<double> half_width;                   ///< parabola: from its axis to its ends [m]
    Value<double> height;    ///< parabola: of its ends above the vertex; below 0: it opens downward [m]
    Value<double> radius;    ///< circle [m]
    Value<double> strength;  ///< K of f = K (1 + cos(pi d / r*)) on each particle [N]
    Value<double> range;     ///< r* [m]
    Value<PushedSide> side = PushedSide::both;
    Value<double> from = 0.0;    ///< when it comes [s]
    Value<double> until;         ///< when it goes [s]; not given: never
    Value<double> period = 0.0;  ///< of a schedule that begins anew [s]; 0: once
};

/// One value for all parts, or values by the names of parts.
template <class T>
struct ByPart {
    std::optional<Value<T>> all;
    std::map<std::string, Value<T>> parts;

    [[nodiscard]] bool empty() const { return !all && parts.empty(); }
    /// Null where the part has none.
    [[nodiscard]] const Value<T>* of(const std::string& part) const {
        const auto found = parts.find(part);
        return found != parts.end() ? &found->second : all ? &*all : nullptr;
    }
};

/// [[species]]: something dissolved that diffuses, and goes along with the fluid. Concentrations are per volume of the
/// liquid at rest, in the species' unit.
struct Species {
    Value<std::string> name;
    Value<SpeciesUnit> unit = SpeciesUnit::mass;
    ByPart<double> diffusivity;             ///< of the fluids, or by part, solids that conduct included [m^2/s]
    ByPart<Expression> concentration;       ///< at the start, as functions of x, y, z
    ByPart<Expression> wall_concentration;  ///< at the surface of rigid parts, as functions of t, x, y, z
    ByPart<Expression> wall_flux;           ///< out of rigid parts into the fluid, per area, as functions of t, x, y, z

    /// "kg", "mol" or "m^3": of an amount.
    [[nodiscard]] std::string amount_unit() const;
    /// "kg/m^3", "mol/m^3" or "1"
    [[nodiscard]] std::string concentration_unit() const;
    /// Of a part, null where it does not carry the species.
    [[nodiscard]] const Value<double>* diffusivity_in(const Part& part) const;
};

/// [[measure]]: one number followed over time.
struct Measure {
    Value<std::string> name;
    Value<MeasureKind> kind;
    Value<Vec> from{Vec::Zero()};                    ///< flux: the line's start [m]
    Value<Vec> to{Vec::Zero()};                      ///< flux: the line's end [m]
    Value<Vec> point{Vec::Zero()};                   ///< probe: where [m]
    Value<FluidField> field = FluidField::velocity;  ///< probe: what
    Value<std::string>
        part;  ///< gap: between the pieces of this elastic solid; wall_flux: into this rigid part;
               ///< velocity, spin, detached: the spheres; aggregate: of this [[solidify]] or elastic solid
    Value<std::string> species;          ///< of measures of a species; empty: the only one
    Value<Axis> axis = Axis::x;          ///< profile, spread: along which
    Value<int> bins = 20;                ///< profile: how many
    Value<double> about = 0.0;           ///< spread: where the variance is taken about, if given; else the mean [m]
    Value<double> length = 0.0;          ///< peclet, wall_flux: of the Peclet and Sherwood numbers [m]; 0: not given
    Value<double> area = 0.0;            ///< wall_flux: of the wall, for the Sherwood number [m^2]
    Value<Vec> direction{Vec::UnitZ()};  ///< detached: to the upper half
};

/// [[solidify]]: liquid that turns solid near seeds, and its bonds (docs/solidify.md).
struct Solidify {
    Value<std::string> name;    ///< of what comes into being
    Value<std::string> liquid;  ///< the fluid part that turns solid

    Value<std::string> seed_part;           ///< all particles of this rigid or elastic solid are seeds; empty: none
    Value<std::string> seed_region;         ///< liquid in this region becomes seeds; empty: anywhere
    Value<double> seed_stress_above = 0.0;  ///< liquid with more shear stress becomes a seed [Pa]; 0: not asked
    Value<double> seed_residence_above =
        0.0;  ///< liquid that was longer in seed_region becomes a seed [s]; 0: not asked

    Value<std::string> region;            ///< only liquid in this region turns solid; empty: anywhere
    Value<double> stress_above = 0.0;     ///< only liquid with more shear stress [Pa]; 0: any
    Value<double> residence_above = 0.0;  ///< only liquid that was longer in the region [s]; 0: any

    Value<SolidifyRule> rule = SolidifyRule::per_candidate;
    Value<double> reach;        ///< R_max, from a seed [m]
    Value<double> probability;  ///< of the rule, in one event [-]
    Value<double> from = 0.0;   ///< time of the first event [s]
    Value<double> interval;     ///< between events [s]
    Value<SeedActivity> active = SeedActivity::always;
    Value<int> one_in = 0;              ///< with active = one_in: N
    Value<bool> spreads = true;         ///< particles that turned solid become seeds
    Value<int> most_bonds = 0;          ///< of one particle, of this rule; 0: any number
    Value<double> bond_stiffness;       ///< k_b [N/m]
    Value<double> rest_length = 0.0;    ///< r0 [m]; 0 = "auto": the distance when the bond is made
    Value<double> bond_damping = 0.01;  ///< dashpot, fraction of critical [-]
    Value<BondTo> bond_to = BondTo::seed;
    Value<int> seed = 1;  ///< of the random numbers
};

/// [[break]]: bonds that break under tension.
struct Breaking {
    Value<std::string> name;
    Value<std::string> part;           ///< whose bonds: an elastic solid's, a [[solidify]]'s or a [[join]]'s
    Value<double> force_above = 0.0;   ///< [N]; 0: not by force
    Value<double> strain_above = 0.0;  ///< [-]; 0: not by strain
    Value<double> interval = 0.0;      ///< between looks [s]; 0: every step
};

/// [[join]]: bonds between the particles of two parts, or between pieces of one, as they are drawn (docs/elastic.md).
struct Join {
    Value<std::string> name;
    Value<std::array<std::string, 2>> parts;  ///< two elastic solids, the same twice, or a springs and a rigid part
    Value<double> within;                     ///< longest bond [m]; not given: 1.5 spacings
    Value<double> stiffness = 0.0;            ///< k_b [N/m]; 0 = "auto": as stiff as the parts' own bonds, in series
    Value<double> damping = 0.01;             ///< dashpot, fraction of critical [-]
};

/// [[select]]: faces of a geometry in 3-D by where they lie, for what the geometry gives no name. All that is given
/// must hold at once.
struct Selection {
    Value<std::string> name;                 ///< of the surface that they make up
    Value<std::string> of;                   ///< the geometry's volume or surface whose faces they are
    Value<double> x, y, z;                   ///< if given: they lie in this plane [m]
    Value<Vec> from{Vec::Zero()};            ///< if given: they lie in a box with this corner [m]
    Value<Vec> to{Vec::Zero()};              ///< and the opposite one [m]
    Value<Vec> normal{Vec::Zero()};          ///< if given: where they face, any length
    Value<double> angle = 0.0;               ///< largest one between `normal` and where a face faces [rad]
    Value<std::vector<std::string>> except;  ///< if given: they are in none of these selections
};

/// [[region]]: a box along the axes, whose residence time is followed.
struct ResidenceRegion {
    Value<std::string> name;
    Value<Vec> from{Vec::Zero()};  ///< one corner [m]
    Value<Vec> to{Vec::Zero()};    ///< the opposite one [m]
};

}  // namespace dmp::scene
