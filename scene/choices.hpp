// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "base/enum_names.hpp"
#include "base/part_kind.hpp"
#include "models/dem/contact_law_list.hpp"
#include "models/elastic/elastic_law_list.hpp"
#include "models/solidify/activity.hpp"
#include "models/sph/fluid_law_list.hpp"
#include "scene/uses.hpp"

namespace dmp::scene {

/// Trades accuracy for speed: sets the defaults of several keys together (docs/accuracy.md).
enum class Quality { draft, standard, fine };
/// Whether a force acts on a part as a whole or on each of its particles.
enum class ForceAmount { total, per_particle };
enum class ShapeKind { parabola, circle };
/// Side of a moving shape on which particles belong.
enum class PushedSide { both, inside, outside };
/// In 3-D these are cubic, hexagonal close-packed and face-centred cubic lattices.
enum class Arrangement { square, hexagonal, fcc };
/// Largest repair allowed for a surface that is not closed; each level includes the previous ones (docs/repair.md).
enum class RepairKind { none, weld, fill, vote, wrap };
/// Whether particles stay on the lattice or are moved until they follow the surfaces (docs/meshing.md).
enum class FillKind { lattice, relaxed, sampled };
enum class KernelKind { wendland_c2, wendland_c4, lucy, cubic_spline, quintic_spline };
/// A side of the box around the fluid.
enum class BoxSide { x_low, x_high, y_low, y_high, z_low, z_high };
/// Axis perpendicular to a side of the box, and whether it is the side at the axis' high end.
[[nodiscard]] inline int axis_of(BoxSide side) { return static_cast<int>(side) / 2; }
[[nodiscard]] inline bool is_high(BoxSide side) { return static_cast<int>(side) % 2 != 0; }
enum class WallModel { extrapolated, plain };
/// How density rates follow from velocities, and when in a step (docs/accuracy.md).
enum class FluidScheme { corrected, plain };
enum class DensityModel { continuity, summation };
enum class ViscosityMean { harmonic, arithmetic };
/// What an elastic area or volume is made of (docs/elastic.md).
enum class ElasticModel { cells, springs };
enum class SpringStepping { implicit, subcycled };
/// What elastic bodies and walls touch with (docs/contact.md).
enum class ContactBetween { automatic, surfaces, particles };
enum class ViscosityStepping { explicitly, implicitly };
enum class SpeciesStepping { explicitly, implicitly };
/// Unit of the amount of a species per volume: mass, moles, or none (a marker).
enum class SpeciesUnit { mass, moles, none };
enum class MeasureKind {
    flux,
    gap,
    largest_speed,
    density,
    kinetic_energy,
    probe,
    line,
    mode,
    amount,
    mean_concentration,
    profile,
    spread,
    wall_flux,
    peclet,
    velocity,  // this and the next three are of spheres
    spin,
    wall_force,
    detached,
    aggregate,
    uptake,
    displacement,
    body,
    field,        // of the fluid, in a region
    solid_field,  // of an elastic solid
    contact
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
/// What the random trials of an event are made for (docs/solidify.md).
enum class SolidifyRule { per_pair, per_candidate, mutually_closest };
/// What a solidifying particle is bonded to: its seed, or all particles of the aggregate within reach.
enum class BondTo { seed, neighbours };
enum class SolidField {
    velocity,
    displacement,
    mean_displacement,
    stress,
    von_mises,
    strain,
    force,
    surface_stress,
    principal_stretches,
    traction
};
/// Between what of two solids a gap is measured.
enum class GapBetween { surfaces, middles, particles };

}  // namespace dmp::scene

/// Names of the enumerators in scene files, in the order of their values.
namespace dmp {

template <>
inline constexpr auto enum_names<scene::Quality> = std::to_array<std::string_view>({"draft", "standard", "fine"});
template <>
inline constexpr auto enum_names<scene::ForceAmount> = std::to_array<std::string_view>({"total", "per_particle"});
template <>
inline constexpr auto enum_names<scene::ShapeKind> = std::to_array<std::string_view>({"parabola", "circle"});
template <>
inline constexpr auto enum_names<scene::PushedSide> = std::to_array<std::string_view>({"both", "inside", "outside"});
template <>
inline constexpr auto enum_names<scene::Arrangement> = std::to_array<std::string_view>({"square", "hexagonal", "fcc"});
template <>
inline constexpr auto enum_names<scene::RepairKind> = std::to_array<std::string_view>({"none", "weld", "fill", "vote",
                                                                                       "wrap"});
template <>
inline constexpr auto enum_names<scene::FillKind> = std::to_array<std::string_view>({"lattice", "relaxed", "sampled"});
template <>
inline constexpr auto enum_names<scene::KernelKind> =
    std::to_array<std::string_view>({"wendland_c2", "wendland_c4", "lucy", "cubic_spline", "quintic_spline"});
template <>
inline constexpr auto enum_names<scene::BoxSide> = std::to_array<std::string_view>({"x_low", "x_high", "y_low",
                                                                                    "y_high", "z_low", "z_high"});
template <>
inline constexpr auto enum_names<scene::WallModel> = std::to_array<std::string_view>({"extrapolated", "plain"});
template <>
inline constexpr auto enum_names<scene::FluidScheme> = std::to_array<std::string_view>({"corrected", "plain"});
template <>
inline constexpr auto enum_names<scene::DensityModel> = std::to_array<std::string_view>({"continuity", "summation"});
template <>
inline constexpr auto enum_names<scene::ViscosityMean> = std::to_array<std::string_view>({"harmonic", "arithmetic"});
template <>
inline constexpr auto enum_names<scene::ElasticModel> = std::to_array<std::string_view>({"cells", "springs"});
template <>
inline constexpr auto enum_names<scene::SpringStepping> = std::to_array<std::string_view>({"implicit", "subcycled"});
template <>
inline constexpr auto enum_names<scene::ContactBetween> = std::to_array<std::string_view>({"auto", "surfaces",
                                                                                           "particles"});
template <>
inline constexpr auto enum_names<scene::ViscosityStepping> = std::to_array<std::string_view>({"explicit", "implicit"});
template <>
inline constexpr auto enum_names<scene::SpeciesStepping> = std::to_array<std::string_view>({"explicit", "implicit"});
template <>
inline constexpr auto enum_names<scene::SpeciesUnit> = std::to_array<std::string_view>({"kg/m^3", "mol/m^3", "1"});
template <>
inline constexpr auto enum_names<scene::Axis> = std::to_array<std::string_view>({"x", "y", "z"});
template <>
inline constexpr auto enum_names<scene::MeasureKind> = std::to_array<std::string_view>(
    {"flux",     "gap",    "largest_speed",      "density",  "kinetic_energy", "probe",     "line",
     "mode",     "amount", "mean_concentration", "profile",  "spread",         "wall_flux", "peclet",
     "velocity", "spin",   "wall_force",         "detached", "aggregate",      "uptake",    "displacement",
     "body",     "field",  "solid_field",        "contact"});
template <>
inline constexpr auto enum_names<scene::SolidifyRule> = std::to_array<std::string_view>({"per_pair", "per_candidate",
                                                                                         "mutually_closest"});
template <>
inline constexpr auto enum_names<scene::BondTo> = std::to_array<std::string_view>({"seed", "neighbours"});
template <>
inline constexpr auto enum_names<scene::FluidField> =
    std::to_array<std::string_view>({"velocity", "pressure", "density", "shear_stress", "stress", "von_mises",
                                     "vorticity", "residence_time", "concentration"});
template <>
inline constexpr auto enum_names<scene::GapBetween> = std::to_array<std::string_view>({"surfaces", "middles",
                                                                                       "particles"});
template <>
inline constexpr auto enum_names<scene::SolidField> =
    std::to_array<std::string_view>({"velocity", "displacement", "mean_displacement", "stress", "von_mises", "strain",
                                     "force", "surface_stress", "principal_stretches", "traction"});

}  // namespace dmp
