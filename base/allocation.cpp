// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/allocation.hpp"

#include <cstdlib>  // says which C library this is

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace dmp {

void return_large_arrays() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 4 << 20);
    // Else 128 KiB from here on: smaller arrays that come and go would be the system's each time.
    mallopt(M_TRIM_THRESHOLD, 8 << 20);
#endif
}

}  // namespace dmp
