// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "models/solidify/activity.hpp"
#include "models/sph/liquid_state.hpp"
#include "scene/uses.hpp"

namespace dmp::scene {

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
/// How far up the ladder of repairs a surface that is not closed may be taken (docs/repair.md).
enum class RepairKind { none, weld, fill, vote, wrap };
/// Whether particles stay on the lattice or are moved until they follow the surfaces.
enum class FillKind { lattice, relaxed, sampled };
enum class KernelKind { wendland_c2, wendland_c4, lucy, cubic_spline, quintic_spline };
/// A side of the box around the fluid.
enum class BoxSide { x_low, x_high, y_low, y_high, z_low, z_high };
/// The axis that a side of the box lies across, and which of the two it is.
[[nodiscard]] inline int axis_of(BoxSide side) { return static_cast<int>(side) / 2; }
[[nodiscard]] inline bool is_high(BoxSide side) { return static_cast<int>(side) % 2 != 0; }
enum class WallModel { extrapolated, plain };
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
/// What a particle that turns solid is bonded to: the seed that turned it, or all of the aggregate within reach.
enum class BondTo { seed, neighbours };
enum class SolidField { velocity, displacement, mean_displacement, stress, von_mises, strain, force };

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
std::string word(RepairKind repair);
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

}  // namespace dmp::scene
