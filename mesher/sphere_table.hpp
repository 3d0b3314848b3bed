// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/vec.hpp"

namespace dmp::mesher {

/// Spheres as a table lists them; what it has no columns for is empty.
struct SphereTable {
    std::vector<Vec> centre;     ///< [m]
    std::vector<double> radius;  ///< [m]
    std::vector<Vec> velocity;   ///< [m/s]
    std::vector<Vec> spin;       ///< [rad/s]
};

/// Reads a table of spheres (docs/spheres.md): values separated by commas, or by semicolons if the heading is, in
/// quotes or not, with a byte-order mark or not. Lines that start with '#' are left out. The first line names the
/// columns with their units:
///
///     x [mm], y [mm], z [mm], radius [um], vx [m/s], vy [m/s], vz [m/s]
///
/// x, y and z must be there; radius, and vx, vy, vz and wx, wy, wz (all three) may be. `place` is where the scene names
/// the file. Throws InputError, with line and column of the table: a file that cannot be read, a column that is
/// unknown, doubled, missing or has no unit, a row of another length, what is no number.
SphereTable read_sphere_table(const std::string& file, const SourceLocation& location);

}  // namespace dmp::mesher
