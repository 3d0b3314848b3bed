// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "scene/choices.hpp"
#include "scene/expression.hpp"
#include "scene/value.hpp"

namespace dmp::scene {

/// [[part]]: one named region, curve or group of the geometry, with its kind and material.
/// 2-D scenes are 1 m deep: masses are in kg, forces in N, energies in J.
struct Part {
    Value<std::string> name;
    Value<PartKind> kind;
    Value<bool> enabled = true;  ///< false leaves the part out; the geometry may contain it

    // fluid
    Value<double> density;    ///< rest density [kg/m^3]
    Value<double> viscosity;  ///< dynamic viscosity [Pa s]

    // rigid and elastic
    Value<int> layers;  ///< rows of particles; default 3 for rigid, 2 for elastic

    // rigid
    /// Velocity of the wall's surface along itself, as of a lid or a belt, as functions of t, x, y, z [m/s].
    Value<std::array<Expression, 3>> surface_velocity;
    Value<bool> slip = false;                   ///< true: no shear stress between fluid and wall
    Value<std::array<Expression, 3>> velocity;  ///< of the part, as functions of t [m/s]
    Value<Expression> spin;                     ///< angular velocity about `centre`, as a function of t [rad/s]
    Value<Vec> centre{Vec::Zero()};             ///< initially; it moves with the part's velocity [m]
    [[nodiscard]] bool slides() const;          ///< whether the surface has a velocity along itself
    [[nodiscard]] bool moves() const;           ///< whether the part has a velocity or spin

    // elastic
    Value<ElasticModel> model = ElasticModel::cells;  ///< of an area in 2-D and a volume in 3-D (Scene::is_of_cells)
    Value<ElasticLaw> elastic_law = ElasticLaw::of<models::SaintVenantKirchhoff>();  ///< of cells
    Value<double> bending_stiffness;           ///< EI [N m^2]; 0: from youngs_modulus
    Value<double> axial_stiffness;             ///< EA [N]; 0: from youngs_modulus
    Value<double> shear_stiffness;             ///< GA [N]; 0: follows from the lattice
    Value<double> youngs_modulus;              ///< E [Pa]; 0: from the stiffnesses
    Value<double> thickness;                   ///< with youngs_modulus [m]
    Value<double> poisson_ratio = 0.0;         ///< with youngs_modulus; strips: in plane strain; 0: depth may change
    Value<bool> lower_axial_stiffness = true;  ///< change EA if the lattice cannot provide EI and EA
    Value<bool> cross_bonds = false;           ///< both diagonals of each cell instead of hinges at its corners
    Value<double> bonds_within;                ///< solid: bonds up to this length, instead of cells [m]
    Value<double> mass_per_length;             ///< [kg/m]
    Value<std::string> anchor;                 ///< name in the geometry of what the part is clamped to; empty: free
    /// Dashpot of each bond and hinge, or viscosity of cells, fraction of critical damping [-].
    Value<double> bond_damping = 0.01;
    /// Of cells, instead of bond_damping: fraction of critical damping [-] of a mode of this frequency [Hz].
    Value<double> damping_ratio, damping_frequency;
    Value<double> drag = 0.0;          ///< lab-frame drag per particle, F = -drag v [kg/s] (as in the thesis)
    Value<double> mass_damping = 0.0;  ///< lab-frame drag per mass, F = -mass_damping m v [1/s]

    // spheres (3-D only); also density, youngs_modulus and poisson_ratio above
    Value<std::vector<double>> radius;  ///< one for all, or one for each of `centres`; empty: in `positions` [m]
    Value<double> mass;                 ///< of each sphere; 0: from the density [kg]
    Value<bool> fixed = false;          ///< neither move nor rotate
    Value<std::vector<Vec>> centres;    ///< of the spheres [m]; or one of the next three
    Value<std::string> positions;       ///< CSV file (docs/spheres.md), absolute or relative to `directory`
    Value<std::string> around;          ///< part of one sphere, on whose surface they sit
    Value<Vec> fill_from{Vec::Zero()};  ///< one corner of a box that they fill at random [m]
    Value<Vec> fill_to{Vec::Zero()};    ///< the opposite one [m]
    Value<int> count = 0;               ///< spheres around the sphere or in the box; 0: from the next two
    Value<double> coverage = 0.0;       ///< around: covered fraction of the sphere's surface, N r^2 / (4 (R + r)^2) [-]
    Value<double> volume_fraction = 0.0;  ///< of the box [-]
    /// Also of elastic solids. As functions of x, y, z [m/s]; with `around`, default: motion of the sphere on which
    /// they sit, with its spin.
    Value<std::array<Expression, 3>> initial_velocity;
    Value<std::array<Expression, 3>> initial_spin;  ///< initial angular velocity, as functions of x, y, z [rad/s]

    // plane and surface; also velocity above; without youngs_modulus the wall is rigid
    Value<Vec> point{Vec::Zero()};   ///< plane: a point on it, initially [m]
    Value<Vec> normal{Vec::Zero()};  ///< plane: to the side of the spheres, of any length [-]
    Value<std::string> file;         ///< surface: STL file, absolute or relative to `directory`
    Value<double> unit = 1.0;        ///< surface: one unit of the file [m]
    [[nodiscard]] bool is_wall_for_spheres() const { return *kind == PartKind::plane || *kind == PartKind::surface; }
};

/// [[contact_pair]]: contact of the spheres of two parts, or of a part and a wall. "any" stands for all parts.
struct ContactPair {
    Value<std::string> name;  ///< may be empty
    Value<std::array<std::string, 2>> parts;
    Value<bool> enabled = true;  ///< false: they pass through each other
    Value<NormalLaw> normal;
    Value<TangentialLaw> tangential;
    Value<double> normal_stiffness_factor = 1.0;      ///< of k_n = 4/3 E* [-]
    Value<double> tangential_stiffness_factor = 1.0;  ///< of k_t = 8 G* [-]
    Value<double> restitution = 0.0;         ///< normal coefficient of restitution [-]; 0: not given, see dampings
    Value<double> normal_damping = 0.0;      ///< gamma_n, instead of the restitution [1/(m s)]
    Value<double> tangential_damping = 0.0;  ///< gamma_t [1/(m s)]
    Value<double> friction;                  ///< Coulomb's coefficient mu [-]; 0: none
    Value<bool> dashpot_may_pull = true;     ///< whether damping may pull the two together as they separate
    Value<double> rolling_friction = 0.0;    ///< coefficient mu_r of the rolling torque mu_r R_eff F_n [-]
    Value<RollingLaw> rolling = RollingLaw::of<ConstantRolling>();
    Value<double> rolling_damping = 0.3;  ///< of the rolling spring, fraction of critical damping [-]
    Value<AdhesionLaw> adhesion;
    Value<double> work_of_adhesion = 0.0;      ///< W, of both surfaces together [J/m^2]; or
    Value<double> pull_off_force = 0.0;        ///< F_c [N]
    Value<double> equilibrium_distance = 0.0;  ///< z0 of Bradley's law [m]
    Value<double> adhesion_cutoff = 0.0;       ///< gap beyond which Bradley's law is cut off [m]
};

}  // namespace dmp::scene
