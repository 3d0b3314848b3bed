// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
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

/// [[force]]: a force on a part, according to a schedule.
struct ForceOnPart {
    Value<std::string> name;
    Value<std::string> part;                 ///< a fluid, an elastic solid or spheres
    Value<std::array<Expression, 3>> force;  ///< as functions of t, x, y, z [N]
    Value<ForceAmount> amount;               ///< total: spread over the part's particles by their volumes
    Value<double> from = 0.0;                ///< when it starts [s]
    Value<double> until;                     ///< when it ends [s]; not given: never
    Value<double> period = 0.0;              ///< after which the schedule repeats [s]; 0: no repetition
};

/// [[moving_shape]]: a curve that moves through the scene and repels the particles of the parts that it names only.
struct MovingShape {
    Value<std::string> name;
    Value<ShapeKind> kind;
    Value<std::vector<std::string>> parts;      ///< that it pushes: fluids, elastic solids or spheres
    Value<std::array<Expression, 3>> position;  ///< of the vertex or centre, as functions of t [m]
    Value<double> half_width;                   ///< parabola: from its axis to its ends [m]
    Value<double> height;    ///< parabola: of its ends above the vertex; negative: it opens downward [m]
    Value<double> radius;    ///< circle [m]
    Value<double> strength;  ///< K of f = K (1 + cos(pi d / r*)) on each particle [N]
    Value<double> range;     ///< r* [m]
    Value<PushedSide> side = PushedSide::both;
    Value<double> from = 0.0;    ///< when it appears [s]
    Value<double> until;         ///< when it disappears [s]; not given: never
    Value<double> period = 0.0;  ///< after which the schedule repeats [s]; 0: no repetition
};

/// One value for all parts, or a value for each named part.
template <class T>
struct ByPart {
    std::optional<Value<T>> all;
    std::map<std::string, Value<T>> parts;

    [[nodiscard]] bool empty() const { return !all && parts.empty(); }
    /// The value for a part; null if it has none.
    [[nodiscard]] const Value<T>* of(const std::string& part) const {
        const auto found = parts.find(part);
        return found != parts.end() ? &found->second : all ? &*all : nullptr;
    }
};

/// [[species]]: a dissolved substance that diffuses and moves with the fluid. Concentrations are per volume of the
/// fluid at rest, in the species' unit.
struct Species {
    Value<std::string> name;
    Value<SpeciesUnit> unit = SpeciesUnit::mass;
    ByPart<double> diffusivity;             ///< in all fluids, or by part, with solids that conduct [m^2/s]
    ByPart<Expression> concentration;       ///< initially, as functions of x, y, z
    ByPart<Expression> wall_concentration;  ///< at the surface of rigid and elastic parts, of t, x, y, z
    ByPart<Expression> wall_flux;           ///< out of rigid parts into the fluid, per area, as functions of t, x, y, z
    ByPart<double> uptake;                  ///< k of dc/dt = -k c in what carries the species, or by part [1/s]

    /// Unit of an amount: "kg", "mol" or "m^3".
    [[nodiscard]] std::string amount_unit() const;
    /// "kg/m^3", "mol/m^3" or "1".
    [[nodiscard]] std::string concentration_unit() const;
    /// Diffusivity in a part; null if the part does not carry the species.
    [[nodiscard]] const Value<double>* diffusivity_in(const Part& part) const;
    /// Rate of uptake in a part [1/s]; null if there is none, or the part does not carry the species.
    [[nodiscard]] const Value<double>* uptake_in(const Part& part) const;
};

/// [[measure]]: a quantity that is recorded over time.
struct Measure {
    Value<std::string> name;
    Value<MeasureKind> kind;
    Value<Vec> from{Vec::Zero()};                              ///< flux, line: the line's start [m]
    Value<Vec> to{Vec::Zero()};                                ///< flux, line: the line's end [m]
    Value<Vec> point{Vec::Zero()};                             ///< probe: its position [m]
    Value<FluidField> field = FluidField::velocity;            ///< probe, line, mode, field: field to measure
    Value<SolidField> solid_field = SolidField::displacement;  ///< solid_field: field to measure
    Value<std::string> region;                                 ///< field: name of a region; not given: all of the fluid
    Value<int> points = 20;                                    ///< line: number of points along it, its ends among them
    Value<std::array<int, 3>> waves;                           ///< mode: number of waves in the period along each axis
    Value<std::string> part;  ///< gap: elastic solid; wall_flux: rigid or elastic part; uptake: what takes up, empty:
                              ///< all; velocity, spin, detached: spheres; aggregate: [[solidify]] or elastic solid
    Value<std::string> against;  ///< contact: elastic or rigid part that `part` touches; empty: all
    Value<GapBetween> between = GapBetween::surfaces;  ///< gap: what of the pieces
    Value<std::string> species;                        ///< measures of species: its name; empty: the only one
    Value<Axis> axis = Axis::x;                        ///< profile, spread: along this axis
    Value<int> bins = 20;                              ///< profile: number of bins
    Value<double> about = 0.0;                         ///< spread: centre of the variance; not given: the mean [m]
    Value<double> length = 0.0;          ///< peclet, wall_flux: of the Peclet or Sherwood number [m]; 0: not given
    Value<double> area = 0.0;            ///< wall_flux: of the wall, for the Sherwood number [m^2]
    Value<Vec> direction{Vec::UnitZ()};  ///< detached: direction to the upper half
};

/// [[reference]]: what a measure should be, where an exact answer or published data is known.
struct Reference {
    Value<std::string> name;  ///< may be empty
    Value<std::string> measure;
    Value<std::string> column;  ///< end of the column's name after the measure's and '_'; empty: it has the measure's
    Value<Expression> formula;  ///< of t, in the column's SI unit; or
    Value<std::string> file;    ///< CSV file, absolute or relative to the scene's folder
    Value<double> from = 0.0;   ///< when it begins [s]
    Value<double> until;        ///< when it ends [s]; not given: with what there is
    Value<std::string> source;  ///< a citation, or how it was found

    /// Of its column in measures.csv.
    [[nodiscard]] std::string column_name() const { return *measure + (column->empty() ? "" : "_" + *column); }
};

/// [[solidify]]: fluid that solidifies near seeds, and its bonds (docs/solidify.md).
struct Solidify {
    Value<std::string> name;    ///< of the resulting solid
    Value<std::string> liquid;  ///< the fluid part that solidifies

    Value<std::string> seed_part;              ///< all particles of this rigid or elastic part are seeds; empty: none
    Value<std::string> seed_region;            ///< fluid in this region becomes seeds; empty: anywhere
    Value<double> seed_stress_above = 0.0;     ///< fluid with more shear stress becomes a seed [Pa]; 0: not used
    Value<double> seed_residence_above = 0.0;  ///< fluid that was longer in seed_region becomes a seed [s]; 0: not used

    Value<std::string> region;            ///< only fluid in this region solidifies; empty: anywhere
    Value<double> stress_above = 0.0;     ///< only fluid with more shear stress [Pa]; 0: any
    Value<double> residence_above = 0.0;  ///< only fluid that was longer in the region [s]; 0: any

    Value<SolidifyRule> rule = SolidifyRule::per_candidate;
    Value<double> reach;        ///< R_max, largest distance from a seed [m]
    Value<double> probability;  ///< that a random trial succeeds [-]
    Value<double> from = 0.0;   ///< time of the first event [s]
    Value<double> until = 0.0;  ///< no event from this time on [s]; 0: not given, the run's end
    Value<double> interval;     ///< between events [s]
    Value<SeedActivity> active = SeedActivity::always;
    Value<int> one_in = 0;              ///< with active = one_in: N
    Value<bool> spreads = true;         ///< solidified particles become seeds
    Value<int> most_bonds = 0;          ///< largest number that a particle gets from this rule; 0: any
    Value<double> bond_stiffness;       ///< k_b [N/m]
    Value<double> rest_length = 0.0;    ///< r0 [m]; 0 = "auto": the distance when the bond is made
    Value<double> bond_damping = 0.01;  ///< dashpot, fraction of critical damping [-]
    Value<BondTo> bond_to = BondTo::seed;
    Value<int> seed = 1;  ///< of the random numbers
};

/// [[break]]: bonds, or faces between the cells of a solid, that break under tension.
struct Breaking {
    Value<std::string> name;
    Value<std::string> part;           ///< elastic solid, [[solidify]] or [[join]] whose bonds break
    Value<double> force_above = 0.0;   ///< of bonds [N]; 0: no limit by force
    Value<double> stress_above = 0.0;  ///< of solids of cells [Pa]; 0: no limit by stress
    Value<double> strain_above = 0.0;  ///< [-]; 0: no limit by strain
    Value<double> interval = 0.0;      ///< between checks [s]; 0: every step
};

/// [[join]]: bonds between the particles of two parts, or of one part, in their initial positions (docs/elastic.md).
struct Join {
    Value<std::string> name;
    Value<std::array<std::string, 2>> parts;  ///< two elastic solids, one twice, or an elastic and a rigid part
    Value<double> within;                     ///< longest bond [m]; not given: 1.5 spacings
    Value<double> stiffness = 0.0;            ///< k_b [N/m]; 0 = "auto": half bonds of both parts in series
    Value<double> damping = 0.01;             ///< dashpot, fraction of critical damping [-]
};

/// [[select]]: names faces of a geometry (in 2-D pieces of curves) by their position. A face must meet all criteria
/// that are given.
struct Selection {
    Value<std::string> name;                 ///< of the surface that the faces form
    Value<std::string> of;                   ///< volume or surface of the geometry whose faces are selected
    Value<double> x, y, z;                   ///< if given: faces in this plane [m]
    Value<Vec> from{Vec::Zero()};            ///< if given: faces in a box with this corner [m]
    Value<Vec> to{Vec::Zero()};              ///< and this opposite one [m]
    Value<Vec> normal{Vec::Zero()};          ///< if given: direction of the outward normal, any length
    Value<double> angle = 0.0;               ///< largest angle between `normal` and a face's normal [rad]
    Value<std::vector<std::string>> except;  ///< if given: faces in none of these selections
};

/// [[region]]: a box along the axes, for residence times and seeds.
struct ResidenceRegion {
    Value<std::string> name;
    Value<Vec> from{Vec::Zero()};  ///< one corner [m]
    Value<Vec> to{Vec::Zero()};    ///< the opposite one [m]

    /// Whether a place is in the box: of its sides the low ones are part of it.
    [[nodiscard]] bool contains(const Vec& place, int dimension) const {
        for (int axis = 0; axis < dimension; ++axis)
            if (!(place[axis] >= std::min((*from)[axis], (*to)[axis]) &&
                  place[axis] < std::max((*from)[axis], (*to)[axis])))
                return false;
        return true;
    }
};

}  // namespace dmp::scene
