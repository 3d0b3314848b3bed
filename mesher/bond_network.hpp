// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vec.hpp"
#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"

namespace dmp::mesher {

/// A solid of bonds between all that is near each other, of energy U = SUM k_ij (|r_ij| - r0_ij)^2. Of a uniform strain
/// e that is V e : M : e, with the fourth moment M = SUM k_ij r0^2 n n n n / V of the bonds; where M is isotropic,
/// lambda = mu = 2 SUM k_ij r0^2 / (d (d + 2) V) with d dimensions (in 2-D of a material held in its depth, 1 m
/// deep), so that nu = 1/4 and E = 5/2 mu (Cauchy; Love 1927, note B).
struct NetworkConstants {
    double youngs_modulus = 0;         ///< that uniform strain meets [Pa]
    double anisotropy = 0;             ///< |M - its isotropic part| / |M| [-]
    double softest = 0, stiffest = 0;  ///< of the k_ij [N/m]

    static constexpr double poisson_ratio = 0.25;
};

/// Gives bonds of these rest lengths their stiffness: for E [Pa] of a body of this volume [m^3], in the plane of this
/// area [m^2]. k_ij = k_0 (1 + T :: n n n n) with the least tensor T that makes M isotropic: 0 on a hexagonal lattice;
/// on a square one with edges and diagonals it makes the diagonals half as stiff. A factor stays above 0.1, also where
/// that leaves M with an anisotropy, as do directions that no bond has.
NetworkConstants set_stiffness(std::vector<Bond>& bonds, const std::vector<Vec>& position, double youngs_modulus,
                               double volume, int dimension);

}  // namespace dmp::mesher
