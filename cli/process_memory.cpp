// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/process_memory.hpp"

#include <fstream>
#include <limits>
#include <string>

#include <unistd.h>

namespace dmp::cli {

ProcessMemory memory_of(pid_t process) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    ProcessMemory memory;
    std::string key;
    while (status >> key) {
        double kibibytes = 0;
        if ((key == "VmHWM:" || key == "VmRSS:") && status >> kibibytes)
            (key == "VmHWM:" ? memory.most : memory.now) = 1024 * kibibytes;
        status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return memory;
}

ProcessMemory own_memory() { return memory_of(getpid()); }

}  // namespace dmp::cli
