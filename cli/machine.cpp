// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/machine.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include <sched.h>
#include <unistd.h>

#include "base/errors.hpp"
#include "cli/uses.hpp"
#include "solver/parallel/resources.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

/// Value of "MemTotal:" and the like [bytes]; 0 when there is none.
double meminfo(const std::string& wanted) {
    std::ifstream file("/proc/meminfo");
    std::string line;
    while (std::getline(file, line)) {
        std::istringstream words(line);
        std::string key;
        double kibibytes = 0;
        if (words >> key >> kibibytes && key == wanted) return kibibytes * 1024;
    }
    return 0;
}

/// The number a control-group file holds; 0 for "max" or no such file.
double group_number(const char* path) {
    std::ifstream file(path);
    double number = 0;
    return file >> number ? number : 0;
}

double processor_quota() {
    std::ifstream file("/sys/fs/cgroup/cpu.max");
    double quota = 0;
    double period = 0;
    return file >> quota >> period && period > 0 ? quota / period : 0;
}

int processors_allowed() {
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) return CPU_COUNT(&allowed);
    return static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
}

std::string find_program(const char* name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    std::string folder;
    while (std::getline(folders, folder, ':')) {
        const fs::path candidate = fs::path(folder) / name;
        if (access(candidate.c_str(), X_OK) == 0) return candidate.string();
    }
    return "";
}

/// Why no file can be written into the folder; empty when one can.
std::string try_to_write(const fs::path& folder) {
    std::string name = (folder / ".dmp-doctor-XXXXXX").string();
    const int file = mkstemp(name.data());
    if (file < 0) return std::strerror(errno);
    const std::string block(1 << 20, 'x');
    std::string error;
    if (write(file, block.data(), block.size()) != static_cast<ssize_t>(block.size()) || fsync(file) != 0) {
        error = std::strerror(errno);
    }
    close(file);
    unlink(name.c_str());
    return error;
}

std::vector<std::string> vector_unit_names() {
    std::vector<std::string> words;
    try {
        for (const VectorUnit unit : available_vector_units()) words.emplace_back(to_string(unit));
    } catch (const ResourceError&) {
        words.clear();  // none: the diagnosis says so
    }
    return words;
}

}  // namespace

MachineMemory machine_memory() {
    MachineMemory memory{meminfo("MemTotal:"), meminfo("MemAvailable:")};
    if (const double limit = group_number("/sys/fs/cgroup/memory.max"); limit > 0 && limit < memory.all) {
        memory.all = limit;
        memory.free = std::min(memory.free, limit - group_number("/sys/fs/cgroup/memory.current"));
    }
    return memory;
}

Machine inspect_machine(const fs::path& folder) {
    Machine machine;
    machine.processors = processors_allowed();
    machine.processor_quota = processor_quota();
    const MachineMemory memory = machine_memory();
    machine.memory = memory.all;
    machine.memory_free = memory.free;
    std::error_code error;
    const fs::space_info space = fs::space(folder, error);
    if (!error) machine.disk_free = static_cast<double>(space.available);
    machine.write_error = try_to_write(folder);
    const char* display = std::getenv("DISPLAY");
    machine.display = display == nullptr ? "" : display;
    machine.xvfb = find_program("Xvfb");
    machine.vector_units = vector_unit_names();
    return machine;
}

int runs_at_a_time(int asked, int threads) {
    if (asked > 0) return asked;
    const Machine machine = inspect_machine(fs::current_path());
    double processors = machine.processors;
    if (machine.processor_quota > 0) processors = std::min(processors, machine.processor_quota);
    return std::max(1, static_cast<int>(std::floor(processors / threads)));
}

}  // namespace dmp::cli
