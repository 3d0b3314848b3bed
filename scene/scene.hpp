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
/// The first four in the order of ParticleKind; planes and surfaces are walls for spheres, rigid parts without
/// particles.
enum class PartKind { fluid, rigid, springs, spheres, plane, surface };
/// How two spheres, or a sphere and a wall, press on each other.
enum class ContactLawKind { hertz_mindlin, hertz_history, thesis_eq_7_5, none };
enum class AdhesionKind { none, bradley, jkr };
enum class RollingKind { constant, spring };
/// Whether a force is that on a whole part or on each of its particles.
enum class ForceAmount { total, per_particle };
enum class ShapeKind { parabola, circle };
/// From which side of a shape it pushes particles away.
enum class PushedSide { both, inside, outside };
/// In space: cubic, hexagonal close-packed, face-centred cubic.
enum class Arrangement { square, hexagonal, fcc };
/// Whether particles stay on the lattice or are moved until they follow the surfaces.
enum class FillKind { lattice, relaxed };
enum class KernelKind { wendland_c2, wendland_c4, lucy, cubic_spline, quintic_spline };
/// A side of the box around the fluid.
enum class BoxSide { x_low, x_high, y_low, y_high, z_low, z_high };
/// The axis that a side of the box lies across, and which of the two it is.
[[nodiscard]] inline int axis_of(BoxSide side) { return static_cast<int>(side) / 2; }
[[nodiscard]] inline bool is_high(BoxSide side) { return static_cast<int>(side) % 2 != 0; }
enum class WallModel { extrapolated, plain };
enum class EquationOfState { tait, linear };
enum class DensityModel { continuity, summation };
enum class ViscousLaw { morris, monaghan, monaghan_approaching };
enum class ViscosityMean { harmonic, arithmetic };
enum class SpringStepping { implicit, subcycled };
enum class ViscosityStepping { explicitly, implicitly };
enum class SpeciesStepping { explicitly, implicitly };
/// What the amount of a species is counted in, per volume: mass, moles, or nothing (a marker).
enum class SpeciesUnit { mass, moles, none };
enum class MeasureKind {
    flux,
    gap,
    largest_speed,
    density,
    kinetic_energy,
    probe,
    amount,
    mean_concentration,
    profile,
    spread,
    wall_flux,
    peclet,
    velocity,  // of spheres, as the next three
    spin,
    wall_force,
    detached,
    aggregate
};
enum class FluidField {
    velocity,
    pressure,
    density,
    shear_stress,
    stress,
    von_mises,
    vorticity,
    residence_time,
    concentration
};
enum class Axis { x, y, z };
/// Which liquid within reach of a seed turns solid, and when a seed looks for it (solver/models/solidify/).
enum class SolidifyRule { per_pair, per_candidate, mutually_closest };
enum class SeedActivity { always, once, one_in };
/// What a particle that turns solid is bonded to: the seed that turned it, or all of the aggregate within reach.
enum class BondTo { seed, neighbours };
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

    // spheres (3-D only); density above, youngs_modulus and poisson_ratio too
    Value<std::vector<double>> radius;  ///< one for all, or one for each of `centres`; empty: from the file [m]
    Value<double> mass;                 ///< of each sphere; 0: from the density [kg]
    Value<bool> fixed = false;          ///< never move nor turn
    Value<std::vector<Vec>> centres;    ///< where they are [m]; or one of the next three
    Value<std::string> positions;       ///< a table of them (docs/spheres.md), absolute or relative to `directory`
    Value<std::string> around;          ///< a spheres part of one sphere, on whose surface they sit
    Value<Vec> fill_from{Vec::Zero()};  ///< one corner of a box that they fill at random [m]
    Value<Vec> fill_to{Vec::Zero()};    ///< the opposite one [m]
    Value<int> count = 0;               ///< of spheres around or in the box; 0: from the next two
    Value<double> coverage = 0.0;  ///< around: part of the sphere's surface that they hide, N r^2 / (4 (R + r)^2) [-]
    Value<double> volume_fraction = 0.0;  ///< of the box [-]
    /// At the start, as functions of x, y, z [m/s]; around: not given is that of the sphere they sit on, and its spin.
    Value<std::array<Expression, 3>> initial_velocity;
    Value<std::array<Expression, 3>> initial_spin;  ///< angular velocity at the start, as functions of x, y, z [rad/s]

    // plane and surface; velocity above; no youngs_modulus: a wall that does not yield
    Value<Vec> point{Vec::Zero()};   ///< plane: on it, at the start [m]
    Value<Vec> normal{Vec::Zero()};  ///< plane: into the side where spheres are, of any length [-]
    Value<std::string> file;         ///< surface: of triangles (STL), absolute or relative to `directory`
    Value<double> unit = 1.0;        ///< surface: one unit of the file [m]
    [[nodiscard]] bool is_wall_for_spheres() const { return *kind == PartKind::plane || *kind == PartKind::surface; }
};

/// [[contact_pair]]: what happens where spheres of two parts, or of a part and a wall, touch. "any" stands for all
/// parts.
struct ContactPair {
    Value<std::string> name;  ///< may be empty
    Value<std::array<std::string, 2>> parts;
    Value<ContactLawKind> law = ContactLawKind::hertz_mindlin;
    Value<double> restitution = 0.0;         ///< normal coefficient of restitution [-]; 0: not given, see the dampings
    Value<double> normal_damping = 0.0;      ///< gamma_n, in place of the restitution [1/(m s)]
    Value<double> tangential_damping = 0.0;  ///< gamma_t [1/(m s)]
    Value<double> friction;                  ///< Coulomb's coefficient mu [-]; 0: none
    Value<bool> dashpot_may_pull = true;     ///< whether damping may hold the two together as they part
    Value<double> rolling_friction = 0.0;    ///< coefficient mu_r of the rolling torque mu_r R_eff F_n [-]
    Value<RollingKind> rolling_law = RollingKind::constant;
    Value<double> rolling_damping = 0.3;  ///< of the rolling spring, fraction of critical [-]
    Value<AdhesionKind> adhesion = AdhesionKind::none;
    Value<double> work_of_adhesion = 0.0;      ///< W, of both surfaces together [J/m^2]; or
    Value<double> pull_off_force = 0.0;        ///< F_c [N]
    Value<double> equilibrium_distance = 0.0;  ///< z0 of Bradley's law [m]
    Value<double> adhesion_cutoff = 0.0;       ///< gap beyond which Bradley's law is cut off [m]
};

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
    Value<std::vector<std::string>> parts;   ///< that feel it: of fluid, springs or spheres
    Value<std::array<Expression, 3>> place;  ///< of the vertex or centre, as functions of t [m]
    Value<double> half_width;                ///< parabola: from its axis to its ends [m]
    Value<double> height;                    ///< parabola: of its ends above the vertex; below 0: it opens downward [m]
    Value<double> radius;                    ///< circle [m]
    Value<double> strength;                  ///< K of f = K (1 + cos(pi d / r*)) on each particle [N]
    Value<double> range;                     ///< r* [m]
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
        part;  ///< gap: between the pieces of this springs part; wall_flux: into this rigid part;
               ///< velocity, spin, detached: the spheres; aggregate: of this [[solidify]] or springs part
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

/// [[select]]: faces of a drawing in space by where they lie, for what the drawing gives no name. All that is given
/// must hold at once.
struct Selection {
    Value<std::string> name;                 ///< of the surface that they make up
    Value<std::string> of;                   ///< the drawing's volume or surface whose faces they are
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
        Value<double> unit = 1.0;  ///< one unit of the drawing [m]; drawings without a unit need it given
        /// DefineConstant names -> values in the drawing's own units (lengths already divided by `unit`).
        std::map<std::string, Value<double>> parameters;
    } geometry;
    std::vector<Selection> selections;

    struct {
        Value<double> spacing;  ///< particle spacing [m]
        Value<Arrangement> arrangement = Arrangement::square;
        Value<FillKind> fill = FillKind::lattice;
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
        Value<SpeciesStepping> species_stepping = SpeciesStepping::explicitly;
        Value<double> species_tolerance = 1e-8;  ///< of implicit diffusion: the concentrations' relative error [-]
        Value<double> steps_per_contact = 20.0;  ///< of spheres: steps in the shortest elastic impact [-]
        Value<double> contact_step = 0.0;        ///< the spheres' time step [s]; 0 = "auto": from steps_per_contact
    } accuracy;

    struct {
        Value<double> duration;           ///< [s]
        Value<int> threads = 0;           ///< 0 = all the machine has
        Value<double> until_still = 0.0;  ///< spheres: time without any change after which to end [s]; 0: do not
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

    std::vector<Species> species;
    /// Of a scene that has spheres and no drawing; given where an axis is periodic.
    struct {
        Value<Vec> from{Vec::Zero()};  ///< one corner [m]
        Value<Vec> to{Vec::Zero()};    ///< the opposite one [m]
    } box;

    std::vector<ContactPair> contact_pairs;
    std::vector<ForceOnPart> forces;
    std::vector<MovingShape> moving_shapes;
    std::vector<ResidenceRegion> regions;
    std::vector<Measure> measures;
    std::vector<Solidify> solidify;
    std::vector<Breaking> breaking;

    /// The number of the species that a measure is of; throws std::out_of_range where there is none.
    [[nodiscard]] std::size_t species_of(const Measure& measure) const;
    /// Whether spring bodies may change while the scene runs.
    [[nodiscard]] bool changes_bodies() const { return !solidify.empty() || !breaking.empty(); }
    /// Whether there may be spring bodies at some time.
    [[nodiscard]] bool may_have_springs() const { return !solidify.empty() || !parts_of(PartKind::springs).empty(); }
    /// The enabled parts of one kind, in order.
    [[nodiscard]] std::vector<const Part*> parts_of(PartKind kind) const;
    /// What happens where these two parts touch, in either order: the pair that names both, else one that names one of
    /// them and "any", else "any" twice; none where the scene does not say. The last pair of equal rank counts.
    [[nodiscard]] const ContactPair* contact_between(const std::string& a, const std::string& b) const;
    /// Whether frames or a probe need this field.
    [[nodiscard]] bool asks_for(FluidField field) const;
    [[nodiscard]] bool asks_for(SolidField field) const;
};

/// The word a scene uses for it: "fluid", "wendland_c2", ...
std::string word(Quality quality);
std::string word(PartKind kind);
std::string word(ContactLawKind law);
std::string word(AdhesionKind adhesion);
std::string word(RollingKind rolling);
std::string word(ForceAmount amount);
std::string word(ShapeKind kind);
std::string word(PushedSide side);
std::string word(Arrangement arrangement);
std::string word(FillKind fill);
std::string word(BoxSide side);
std::string word(WallModel walls);
std::string word(EquationOfState equation);
std::string word(DensityModel density);
std::string word(ViscousLaw law);
std::string word(ViscosityMean mean);
std::string word(SpringStepping stepping);
std::string word(ViscosityStepping stepping);
std::string word(SpeciesStepping stepping);
std::string word(SpeciesUnit unit);
std::string word(Axis axis);
std::string word(FluidField field);
std::string word(SolidField field);
std::string word(KernelKind kernel);
std::string word(MeasureKind kind);
std::string word(SolidifyRule rule);
std::string word(SeedActivity activity);
std::string word(BondTo bonds);

}  // namespace dmp
