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

/// [[part]]: one named region, curve or group of the geometry and what it is made of.
/// 2-D scenes are 1 m deep: masses in kg, forces in N, energies in J.
struct Part {
    Value<std::string> name;
    Value<PartKind> kind;
    Value<bool> enabled = true;  ///< false leaves the part out; its name in the geometry stays known

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
    Value<double> shear_stiffness;             ///< GA [N]; 0: as the lattice gives
    Value<double> youngs_modulus;              ///< E [Pa]; 0: from the stiffnesses
    Value<double> thickness;                   ///< with youngs_modulus [m]
    Value<double> poisson_ratio = 0.0;         ///< with youngs_modulus: that of a strip held in its depth; 0: not held
    Value<bool> lower_axial_stiffness = true;  ///< change EA where the lattice cannot hold EI and EA at this spacing
    Value<bool> cross_bonds = false;           ///< both diagonals of each cell instead of hinges at its corners
    Value<double> bonds_within;                ///< of a solid: bonds of all particles so near, not cells [m]
    Value<double> mass_per_length;             ///< [kg/m]
    Value<std::string> anchor;                 ///< named points of the geometry where the part is clamped; empty: free
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
    Value<bool> enabled = true;  ///< false: they pass through each other
    Value<NormalLaw> normal;
    Value<TangentialLaw> tangential;
    Value<double> normal_stiffness_factor = 1.0;      ///< of k_n = 4/3 E* [-]
    Value<double> tangential_stiffness_factor = 1.0;  ///< of k_t = 8 G* [-]
    Value<double> restitution = 0.0;         ///< normal coefficient of restitution [-]; 0: not given, see the dampings
    Value<double> normal_damping = 0.0;      ///< gamma_n, in place of the restitution [1/(m s)]
    Value<double> tangential_damping = 0.0;  ///< gamma_t [1/(m s)]
    Value<double> friction;                  ///< Coulomb's coefficient mu [-]; 0: none
    Value<bool> dashpot_may_pull = true;     ///< whether damping may hold the two together as they part
    Value<double> rolling_friction = 0.0;    ///< coefficient mu_r of the rolling torque mu_r R_eff F_n [-]
    Value<RollingLaw> rolling = RollingLaw::of<ConstantRolling>();
    Value<double> rolling_damping = 0.3;  ///< of the rolling spring, fraction of critical [-]
    Value<AdhesionLaw> adhesion;
    Value<double> work_of_adhesion = 0.0;      ///< W, of both surfaces together [J/m^2]; or
    Value<double> pull_off_force = 0.0;        ///< F_c [N]
    Value<double> equilibrium_distance = 0.0;  ///< z0 of Bradley's law [m]
    Value<double> adhesion_cutoff = 0.0;       ///< gap beyond which Bradley's law is cut off [m]
};

}  // namespace dmp::scene
