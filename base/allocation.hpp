// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace dmp {

/// From here on, arrays of more than 4 MiB that are given up go back to the system at once. By itself the C library
/// comes to keep blocks of up to 32 MiB for later: of 10^6 particles, a quarter of the resident set.
void return_large_arrays();

/// Whether so many bytes more can be had under the limit of this process' addresses (ulimit -v); true where there is
/// none. For libraries that crash, rather than say so, when they are refused memory.
[[nodiscard]] bool may_allocate(std::size_t bytes);

}  // namespace dmp
