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
#endif
}

}  // namespace dmp
