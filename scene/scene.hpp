// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/vec.hpp"
#include "scene/expression.hpp"

namespace dmp {

/// A scene value with the place it came from. Defaults have no place.
template <class T>
struct Value {
    T value{};
    Place place;

    Value() = default;
    Value(T v) : value(std::move(v)) {}  // NOLINT(google-explicit-constructor): defaults read as plain values
    Value(T v, Place p) : value(std::move(v)), place(std::move(p)) {}

    operator const T&() const { return value; }  // NOLINT(google-explicit-constructor): reads as the value itself
    [[nodiscard]] const T& operator*() const { return value; }
    [[nodiscard]] const T* operator->() const { return &value; }
    [[nodiscard]] bool given() const { return place.known(); }
};

/// Sets what trades accuracy for speed together, where the scene does not say otherwise (docs/accuracy.md).
enum class Quality { draft, standard, fine };
enum class PartKind { fluid, rigid, springs };
enum class Arrangement { square, hexagonal };
enum class KernelKind { wendland_c2, wendland_c4, lucy, cubic_spline, quintic_spline };
/// A side of the box around the fluid.
enum class BoxSide { x_low, x_high, y_low, y_high };
enum class WallModel { extrapolated, plain };
enum class EquationOfState { tait, linear };
enum class DensityModel { continuity, summation };
enum class ViscousLaw { morris, monaghan, monaghan_approaching };
enum class ViscosityMean { harmonic, arithmetic };
enum class SpringStepping { implicit, subcycled };
enum class ViscosityStepping { explicitly, implicitly };
enum class MeasureKind { flux, gap, largest_speed, density, kinetic_energy, probe, aggregate };
/// Which liquid within reach of a seed turns solid, and when a seed looks for it (solver/models/solidify/).
enum class SolidifyRule { per_pair, per_candidate, mutually_closest };
enum class SeedActivity { always, once, one_in };
/// What a particle that turns solid is bonded to: the seed that turned it, or all of the aggregate within reach.
enum class BondTo { seed, neighbours };
enum class FluidField { velocity, pressure, density, shear_stress, stress, von_mises, vorticity, residence_time };
enum class SolidField { velocity, displacement, mean_displacement, stress, von_mises, strain, force };

/// [[part]]: one named region, curve or group of the drawing and what it is made of.
/// 2-D scenes are 1 m deep: masses in kg, forces in N, energies in J.
struct Part {
    Value<std::string> name;
    Value<PartKind> kind;
    Value<bool> enabled = true;  ///< false leaves the part out; its name in the drawing stays known

    // fluid
    Value<double> density;    ///< rest density [kg/m^3]
    Value<double> viscosity;  ///< dynamic viscosity [Pa s]

    // rigid and springs
    Value<int> layers;  ///< rows of particles; default 3 for rigid, 2 for springs

    // rigid
    /// Velocity of the wall's surface in itself, of a lid or a belt, as functions of t, x, y, z [m/s].
    Value<std::array<Expression, 3>> surface_velocity;
    Value<bool> slip = false;                   ///< the fluid slides along the wall: no shear stress
    Value<std::array<Expression, 3>> velocity;  ///< with which the part moves, as functions of t [m/s]
    Value<Expression> spin;                     ///< with which it turns about `centre`, as a function of t [rad/s]
    Value<Vec> centre{Vec::Zero()};             ///< at the start; it moves with the part's velocity [m]
    [[nodiscard]] bool slides() const;          ///< whether the surface has a velocity of its own
    [[nodiscard]] bool moves() const;           ///< whether the part moves or turns

    // springs
    Value<double> bending_stiffness;           ///< EI [N m^2]; 0: from youngs_modulus
    Value<double> axial_stiffness;             ///< EA [N]; 0: from youngs_modulus
    Value<double> youngs_modulus;              ///< E [Pa]; 0: from the stiffnesses
    Value<double> thickness;                   ///< with youngs_modulus [m]
    Value<double> poisson_ratio = 0.0;         ///< with youngs_modulus: that of a strip held in its depth; 0: not held
    Value<bool> lower_axial_stiffness = true;  ///< change EA where the lattice cannot hold EI and EA at this spacing
    Value<bool> cross_bonds = false;           ///< both diagonals of each cell instead of hinges at its corners
    Value<double> mass_per_length;             ///< [kg/m]
    Value<std::string> anchor;                 ///< named points of the drawing where the part is clamped; empty: free
    Value<double> bond_damping = 0.01;         ///< dashpot of each bond and hinge, fraction of critical [-]
    Value<double> drag = 0.0;                  ///< lab-frame drag per particle, F = -drag v [kg/s] (thesis' form)
};

/// [[measure]]: one number followed over time.
struct Measure {
    Value<std::string> name;
    Value<MeasureKind> kind;
    Value<Vec> from{Vec::Zero()};                    ///< flux: the line's start [m]
    Value<Vec> to{Vec::Zero()};                      ///< flux: the line's end [m]
    Value<Vec> point{Vec::Zero()};                   ///< probe: where [m]
    Value<FluidField> field = FluidField::velocity;  ///< probe: what
    /// gap: smallest distance between the pieces of this springs part; aggregate: of this [[solidify]] or springs part
    Value<std::string> part;
};

/// [[solidify]]: liquid that turns solid near seeds, and its bonds (docs/solidify.md).
struct Solidify {
    Value<std::string> name;    ///< of what comes into being
    Value<std::string> liquid;  ///< the fluid part that turns solid

    Value<std::string> seed_part;           ///< all particles of this rigid or springs part are seeds; empty: none
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
    Value<std::string> part;           ///< whose bonds: a springs part's or a [[solidify]]'s
    Value<double> force_above = 0.0;   ///< [N]; 0: not by force
    Value<double> strain_above = 0.0;  ///< [-]; 0: not by strain
    Value<double> interval = 0.0;      ///< between looks [s]; 0: every step
};

/// [[region]]: a box along the axes, whose residence time is followed.
struct ResidenceRegion {
    Value<std::string> name;
    Value<Vec> from{Vec::Zero()};  ///< one corner [m]
    Value<Vec> to{Vec::Zero()};    ///< the opposite one [m]
};

struct Scene {
    std::string file;       ///< path of the scene file as given
    std::string directory;  ///< its folder; relative paths in the scene start here
    std::string hash;       ///< of the resolved scene (all defaults, SI), 16 hex digits

    Value<int> schema = 1;  ///< version of the scene's keys
    Value<std::string> title;
    Value<int> dimension = 2;
    Value<Quality> quality = Quality::standard;

    struct {
        Value<std::string> file;   ///< the drawing, absolute or relative to `directory`
        Value<double> unit = 1.0;  ///< one unit of the drawing [m]
        /// DefineConstant names -> values in the drawing's own units (lengths already divided by `unit`).
        std::map<std::string, Value<double>> parameters;
    } geometry;

    struct {
        Value<double> spacing;  ///< particle spacing [m]
        Value<Arrangement> arrangement = Arrangement::square;
        Value<double> disorder = 0.0;  ///< largest random displacement of fluid particles along an axis [spacings]
        Value<int> seed = 1;           ///< of the disorder
    } particles;

    std::vector<Part> parts;  ///< in the order written, disabled ones included

    struct {
        std::array<Expression, 3> acceleration;  ///< body acceleration of the fluid [m/s^2] as functions of t, x, y, z
        std::array<Value<bool>, 3> periodic;     ///< by axis
        Value<std::vector<BoxSide>> symmetry;    ///< sides on which the scene is mirrored
        Value<double> largest_speed;             ///< largest speed expected [m/s]; 0 = not given
        Value<std::array<Expression, 3>> initial_velocity;  ///< of the fluid [m/s] as functions of x, y, z
        Value<Expression> initial_pressure;                 ///< of the fluid [Pa] as a function of x, y, z
        Value<double> largest_pressure;                     ///< largest pressure expected [Pa]; 0 = not given
    } flow;

    struct {
        Value<double> range = 1.0;     ///< r*, cut-off of the short-range repulsion [spacings]; 0 switches it off
        Value<double> strength = 0.0;  ///< K [J]; 0 = "auto"
    } contact;

    struct {
        Value<KernelKind> kernel = KernelKind::wendland_c2;
        Value<double> support = 3.0;      ///< support radius [spacings]
        Value<double> sound_speed = 0.0;  ///< [m/s]; 0 = "auto": flow.largest_speed / mach_number
        Value<double> mach_number = 0.1;  ///< largest speed over sound speed, where that is "auto" [-]
        Value<WallModel> walls = WallModel::extrapolated;
        Value<EquationOfState> equation_of_state = EquationOfState::tait;
        Value<double> background_pressure = 0.0;  ///< added to the equation of state [Pa]
        Value<DensityModel> density = DensityModel::continuity;
        Value<bool> gradient_correction = false;  ///< Bonet & Lok 1999
        Value<ViscousLaw> viscous_law = ViscousLaw::morris;
        Value<ViscosityMean> viscosity_mean = ViscosityMean::harmonic;  ///< between fluids of unlike viscosity
        Value<double> density_diffusion = 0.1;   ///< delta of Molteni & Colagrossi [-]; 0 switches it off
        Value<double> shifting = 4.0;            ///< strength s of the particle shifting [-]; 0 switches it off
        Value<bool> transport_velocity = false;  ///< Adami, Hu & Adams 2013, instead of shifting
        Value<double> step_factor = 0.3;         ///< c0 dt / support radius [-]
        Value<ViscosityStepping> viscosity_stepping = ViscosityStepping::explicitly;
        Value<double> viscosity_tolerance = 1e-6;  ///< of implicit viscosity: the velocities' relative error [-]
        Value<SpringStepping> spring_stepping = SpringStepping::implicit;
        Value<double> spring_step_factor = 0.5;  ///< fraction of the springs' largest stable step [-]
    } accuracy;

    struct {
        Value<double> duration;  ///< [s]
        Value<int> threads = 0;  ///< 0 = all the machine has
    } run;

    struct {
        Value<double> every;                ///< time between frames [s]
        std::vector<FluidField> fields;     ///< per-particle fields in the frames
        Value<double> measure_every = 0.0;  ///< time between rows of measures.csv [s]; 0 = every / 4
        Value<bool> pictures = true;
        Value<FluidField> picture_field = FluidField::velocity;
        /// Fields of solids in the frames; strain and force are the bonds'.
        std::vector<SolidField> solid_fields{SolidField::velocity, SolidField::displacement, SolidField::strain,
                                             SolidField::force};
        Value<double> average_from = 0.0;  ///< when time averages begin [s]
    } output;

    std::vector<ResidenceRegion> regions;
    std::vector<Measure> measures;
    std::vector<Solidify> solidify;
    std::vector<Breaking> breaking;

    /// Whether spring bodies may change while the scene runs.
    [[nodiscard]] bool changes_bodies() const { return !solidify.empty() || !breaking.empty(); }
    /// Whether there may be spring bodies at some time.
    [[nodiscard]] bool may_have_springs() const { return !solidify.empty() || !parts_of(PartKind::springs).empty(); }
    /// The enabled parts of one kind, in order.
    [[nodiscard]] std::vector<const Part*> parts_of(PartKind kind) const;
    /// Whether frames or a probe need this field.
    [[nodiscard]] bool asks_for(FluidField field) const;
    [[nodiscard]] bool asks_for(SolidField field) const;
};

/// The word a scene uses for it: "fluid", "wendland_c2", ...
std::string word(Quality quality);
std::string word(PartKind kind);
std::string word(Arrangement arrangement);
std::string word(BoxSide side);
std::string word(WallModel walls);
std::string word(EquationOfState equation);
std::string word(DensityModel density);
std::string word(ViscousLaw law);
std::string word(ViscosityMean mean);
std::string word(SpringStepping stepping);
std::string word(ViscosityStepping stepping);
std::string word(FluidField field);
std::string word(SolidField field);
std::string word(KernelKind kernel);
std::string word(MeasureKind kind);
std::string word(SolidifyRule rule);
std::string word(SeedActivity activity);
std::string word(BondTo bonds);

}  // namespace dmp
