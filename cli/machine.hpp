// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dmp::cli {

/// What a machine offers; numbers are 0 where the system does not say.
struct Machine {
    int processors = 0;                     ///< this process may run on
    double processor_quota = 0;             ///< of its control group [processors]; 0: no limit
    double memory = 0, memory_free = 0;     ///< [bytes], a control group's limit taken into account
    double disk_free = 0;                   ///< for the current folder [bytes]
    std::string write_error;                ///< why no file can be written here; empty: it can
    std::string display;                    ///< $DISPLAY
    std::string xvfb;                       ///< path of Xvfb; empty: there is none
    std::vector<std::string> vector_units;  ///< of the processor, that dmp has code for; the widest last
};

/// Of a machine, a control group's limit taken into account [bytes]; 0 where the system does not say.
struct MachineMemory {
    double all = 0, free = 0;
};
[[nodiscard]] MachineMemory machine_memory();

[[nodiscard]] Machine inspect_machine(const std::filesystem::path& folder);

/// Runs at a time: `asked`; where that is 0, as many of so many threads each as there are processors for.
[[nodiscard]] int runs_at_a_time(int asked, int threads);

}  // namespace dmp::cli
