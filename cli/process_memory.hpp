// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

namespace dmp::cli {

/// What a process holds of the machine's memory [bytes]; 0 where the system does not say.
struct ProcessMemory {
    double now = 0;
    double most = 0;  ///< that it ever held
};

[[nodiscard]] ProcessMemory memory_of(pid_t process);
[[nodiscard]] ProcessMemory own_memory();

}  // namespace dmp::cli
