// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dmp {

/// From here on, arrays of more than 4 MiB that are given up go back to the system at once. By itself the C library
/// comes to keep blocks of up to 32 MiB for later: of 10^6 particles, a quarter of the resident set.
void return_large_arrays();

}  // namespace dmp
