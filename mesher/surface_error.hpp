// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesher/cad_surface.hpp"
#include "mesher/mesh.hpp"
#include "mesher/searchable_particles.hpp"

namespace dmp::mesher {

/// How far searches for the nearest particle of a place on the surface go [spacings].
inline constexpr double surface_search = 3;

/// How well one fluid's particles follow its drawn surface, both ways [spacings]. A particle stands for a cell about
/// it, so that one next to a surface is half a spacing from it:
///   from particles: distance to the drawn surface less 1/2, of each particle nearer to it than one spacing;
///   from the geometry: depth below the surface, along its normal, of the particle nearest to a place on it, less 1/2.
/// Both are 0 where a lattice runs along the surface. Where it is cut at any angle the first is spread evenly between
/// -1/2 and 1/2: RMS 12^(-1/2) = 0.289.
/// @param search knows images within surface_search spacings
/// @param error takes each particle's deviation; those further from the surface keep what they have
MeshReport::SurfaceLine surface_error(const ParticleSet& set, const SearchableParticles& search,
                                      const CadSurface& surface, int part, std::vector<float>& error);

}  // namespace dmp::mesher
