// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "scene/choices.hpp"
#include "scene/expression.hpp"
#include "scene/items.hpp"
#include "scene/part.hpp"
#include "scene/value.hpp"

namespace dmp::scene {

/// The contents of a scene file: the values of all keys in SI units, with defaults filled in.
struct Scene {
    std::string file;       ///< path of the scene file as given
    std::string directory;  ///< its folder; relative paths in the scene refer to it
    std::string hash;       ///< of the resolved scene (all defaults, SI), 16 hex digits

    Value<int> schema = 1;  ///< version of the scene's keys
    Value<std::string> title;
    Value<int> dimension = 2;
    Value<Quality> quality = Quality::standard;

    struct {
        Value<std::string> file;   ///< CAD file, absolute or relative to `directory`
        Value<double> unit = 1.0;  ///< one unit of the CAD file [m]; required if the file does not state it
        /// Values by DefineConstant name, in the CAD file's units (lengths are divided by `unit`).
        std::map<std::string, Value<double>> parameters;
        Value<RepairKind> repair = RepairKind::wrap;
        Value<double> largest_hole = 8.0;  ///< largest perimeter of holes that are filled [spacings]
    } geometry;
    std::vector<Selection> selections;

    struct {
        Value<double> spacing;  ///< particle spacing [m]
        Value<Arrangement> arrangement = Arrangement::square;
        Value<FillKind> fill = FillKind::lattice;
        Value<double> disorder = 0.0;  ///< largest random displacement of fluid particles along an axis [spacings]
        Value<int> seed = 1;           ///< of the random numbers
    } particles;

    std::vector<Part> parts;  ///< in the order of the file, including disabled ones

    struct {
        /// Body acceleration of all that moves [m/s^2] as functions of t, x, y, z.
        std::array<Expression, 3> acceleration;
        /// Mean gradient of the pressure along periodic axes [Pa/m] as functions of t.
        Value<std::array<Expression, 3>> pressure_gradient;
        std::array<Value<bool>, 3> periodic;                ///< by axis
        Value<std::vector<BoxSide>> symmetry;               ///< sides of the fluid's box that are planes of symmetry
        Value<double> largest_speed;                        ///< largest speed expected [m/s]; 0 = not given
        Value<std::array<Expression, 3>> initial_velocity;  ///< of the fluid [m/s] as functions of x, y, z
        Value<Expression> initial_pressure;                 ///< of the fluid [Pa] as a function of x, y, z
        Value<double> largest_pressure;                     ///< largest pressure expected [Pa]; 0 = not given
    } flow;

    struct {
        Value<double> range = 0.7;     ///< r*, cut-off of the short-range repulsion [spacings]; 0 turns it off
        Value<double> strength = 0.0;  ///< K [J]; 0 = "auto"
        Value<ContactBetween> between = ContactBetween::automatic;  ///< surfaces or particles, once it is read
        Value<double> stiffness = 0.0;  ///< of surfaces, pressure per depth [Pa/m]; 0 = "auto"
        Value<double> friction = 0.0;   ///< of surfaces, Coulomb's [-]
        Value<double> damping = 0.0;    ///< of surfaces, fraction of critical [-]
    } contact;

    struct {
        Value<FluidScheme> scheme = FluidScheme::corrected;
        Value<KernelKind> kernel = KernelKind::wendland_c2;
        Value<double> support = 3.0;      ///< support radius [spacings]
        Value<double> sound_speed = 0.0;  ///< [m/s]; 0 = "auto": flow.largest_speed / mach_number
        Value<double> mach_number = 0.1;  ///< largest speed / sound speed, if that is "auto" [-]
        Value<WallModel> walls = WallModel::extrapolated;
        Value<EquationOfState> equation_of_state = EquationOfState::of<TaitEquation>();
        Value<double> background_pressure = 0.0;  ///< added to the equation of state [Pa]
        Value<DensityModel> density = DensityModel::continuity;
        Value<bool> gradient_correction = false;  ///< Bonet & Lok 1999
        Value<ViscousLaw> viscous_law = ViscousLaw::of<NewtonianViscosity>();
        Value<ViscosityMean> viscosity_mean = ViscosityMean::harmonic;  ///< between fluids of different viscosity
        Value<double> density_diffusion = 0.1;   ///< delta of Molteni & Colagrossi [-]; 0 turns it off
        Value<double> shifting = 0.2;            ///< coefficient s of particle shifting [-]; 0 turns it off
        Value<bool> transport_velocity = false;  ///< Adami, Hu & Adams 2013, instead of shifting
        Value<double> step_factor = 0.5;         ///< c0 dt / support radius [-]
        Value<ViscosityStepping> viscosity_stepping = ViscosityStepping::explicitly;
        Value<double> viscosity_tolerance = 1e-6;  ///< implicit viscosity: relative error of the velocities [-]
        Value<SpringStepping> spring_stepping = SpringStepping::implicit;
        Value<double> spring_step_factor = 0.5;   ///< fraction of the largest stable step of the springs [-]
        Value<double> viscous_step_factor = 0.5;  ///< fraction of the kernel's linear limit of nu dt / R^2 [-]
        Value<double> species_step_factor = 0.5;  ///< the same of D dt / R^2 [-]
        Value<double> contact_step_factor = 0.5;  ///< fraction of 2 / omega of the repulsion [-]
        /// dt (c0 + U) / R over sqrt(m / m_liquid) of the lightest elastic node [-]
        Value<double> light_solid_step_factor = 0.4;
        Value<double> density_diffusion_step_factor = 0.12;  ///< largest delta (c0 + U) dt / R [-]
        Value<double> shifting_step_factor = 1.2;            ///< plain scheme: largest s c0 dt / R [-]
        Value<SpeciesStepping> species_stepping = SpeciesStepping::explicitly;
        Value<double> species_tolerance = 1e-8;  ///< implicit diffusion: relative error of the concentrations [-]
        Value<double> steps_per_contact = 30.0;  ///< spheres: steps in the shortest elastic impact [-]
        Value<double> contact_step = 0.0;        ///< spheres: time step [s]; 0 = "auto": from steps_per_contact
    } numerics;

    struct {
        Value<double> duration;            ///< [s]
        Value<int> threads = 0;            ///< 0: all that the machine has
        Value<double> until_steady = 0.0;  ///< spheres: duration of the steady state that ends the run [s]; 0: never
    } run;

    struct {
        Value<double> every;                ///< time between frames [s]
        std::vector<FluidField> fields;     ///< fields of the fluid particles in the frames
        Value<double> measure_every = 0.0;  ///< time between rows of measures.csv [s]; 0 = every / 4
        Value<bool> pictures = true;
        Value<FluidField> picture_field = FluidField::velocity;
        /// Fields of elastic solids in the frames; strain and force are per bond.
        std::vector<SolidField> solid_fields{SolidField::velocity,  SolidField::displacement, SolidField::stress,
                                             SolidField::von_mises, SolidField::strain,       SolidField::force};
        Value<double> average_from = 0.0;  ///< when time averages begin [s]
    } output;

    std::vector<Species> species;
    /// Box of a scene of spheres, which has no geometry; required if an axis is periodic.
    struct {
        Value<Vec> from{Vec::Zero()};  ///< one corner [m]
        Value<Vec> to{Vec::Zero()};    ///< the opposite one [m]
    } box;

    std::vector<Join> joins;
    std::vector<ContactPair> contact_pairs;
    std::vector<ForceOnPart> forces;
    std::vector<MovingShape> moving_shapes;
    std::vector<ResidenceRegion> regions;
    std::vector<Measure> measures;
    std::vector<Reference> references;
    std::vector<Solidify> solidify;
    std::vector<Breaking> breaking;

    /// Index of the species of a measure; throws std::out_of_range if there is none.
    [[nodiscard]] std::size_t species_of(const Measure& measure) const;
    /// The enabled parts that take the species up.
    [[nodiscard]] std::vector<const Part*> takers_of(const Species& of) const;
    /// Whether an elastic part is a solid of cells: an area in 2-D, a volume in 3-D. A volume thinner than two spacings
    /// becomes a shell all the same, unless `model` is given.
    [[nodiscard]] bool is_of_cells(const Part& part) const;
    /// Whether elastic bodies may gain or lose bonds during the run.
    [[nodiscard]] bool changes_bodies() const { return !solidify.empty() || !breaking.empty(); }
    /// Whether there are elastic bodies at the start or later.
    [[nodiscard]] bool may_have_elastic() const { return !solidify.empty() || !parts_of(PartKind::elastic).empty(); }
    /// The joins whose parts are enabled, in order.
    [[nodiscard]] std::vector<const Join*> joins_of_enabled() const;
    /// The part with this name, enabled or not; null if there is none.
    [[nodiscard]] const Part* part_named(const std::string& name) const;
    /// The part with a name found in a particle file; throws InputError if there is none: the file is of another scene.
    [[nodiscard]] const Part& part_of_particles(const std::string& name) const;
    /// The enabled parts of one kind, in order.
    [[nodiscard]] std::vector<const Part*> parts_of(PartKind kind) const;
    /// Their names.
    [[nodiscard]] std::vector<std::string> names_of_parts(PartKind kind) const;
    /// Whether elastic bodies touch each other and walls as their drawn surfaces.
    [[nodiscard]] bool has_surface_contact() const {
        return *contact.between == ContactBetween::surfaces && contact.range > 0 &&
               !parts_of(PartKind::elastic).empty();
    }
    /// The contact pair of two parts, in either order: the pair that names both, else one that names one of them and
    /// "any", else "any" twice; null if there is none. The last pair of equal rank takes precedence.
    [[nodiscard]] const ContactPair* contact_between(const std::string& a, const std::string& b) const;
    /// Whether frames, probes or solidification rules need this field.
    [[nodiscard]] bool asks_for(FluidField field) const;
    [[nodiscard]] bool asks_for(SolidField field) const;
};

}  // namespace dmp::scene
