// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/allocation.hpp"

#include <cstdlib>  // says which C library this is

#include <sys/mman.h>
#include <sys/resource.h>

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

bool may_allocate(std::size_t bytes) {
    rlimit addresses{};
    if (getrlimit(RLIMIT_AS, &addresses) != 0 || addresses.rlim_cur == RLIM_INFINITY) return true;
    // Reserved, not used: takes no memory.
    void* const at = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (at == MAP_FAILED) return false;
    munmap(at, bytes);
    return true;
}

}  // namespace dmp
