// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/diagnosis.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/text.hpp"

namespace dmp::cli {

namespace {

constexpr double gibibyte = 1024.0 * 1024 * 1024;

Finding inspect_build(const BuildFacts& build) {
    Finding finding{Health::ok, "build", fmt::format("{}, {}", build.build_type, build.compiler)};
    if (!build.sanitizers.empty()) {
        finding.health = Health::warn;
        finding.found += ", with the sanitizers " + build.sanitizers;
        finding.to_do = "Runs are many times slower. For speed: cmake --preset release && cmake --build build";
    } else if (build.build_type != "Release" && build.build_type != "RelWithDebInfo") {
        finding.health = Health::warn;
        finding.to_do = "Runs are many times slower. For speed: cmake --preset release && cmake --build build";
    }
    return finding;
}

Finding inspect_vector_units(const Machine& machine) {
    const auto& units = machine.vector_units;
    if (units.empty()) {
        return {Health::bad, "vector unit", "this processor has none of those that dmp is built for",
                "Use a processor of 2013 or later (Intel Haswell, AMD Excavator)."};
    }
    Finding finding{Health::ok, "vector unit", fmt::format("{} is used, the widest there is", units.back())};
    if (units.size() > 1) finding.found += fmt::format(" ({})", fmt::join(units, ", "));
    return finding;
}

Finding inspect_processors(const Machine& machine) {
    Finding finding{Health::ok, "processors", fmt::format("{} for threads", machine.processors)};
    if (machine.processor_quota > 0 && machine.processor_quota < machine.processors) {
        finding.health = Health::warn;
        finding.found += fmt::format(", but the time of only {:.3g} of them", machine.processor_quota);
        finding.to_do = fmt::format("Run with --threads {}.", std::max(1, static_cast<int>(machine.processor_quota)));
    }
    return finding;
}

Finding inspect_memory(const Machine& machine) {
    if (machine.memory <= 0) return {Health::warn, "memory", "the system does not say how much there is"};
    Finding finding{Health::ok, "memory",
                    fmt::format("{}, {} free", bytes_text(machine.memory), bytes_text(machine.memory_free))};
    if (machine.memory_free < 1 * gibibyte) {
        finding.health = Health::warn;
        finding.to_do =
            "Close other programs, or use fewer particles; 'dmp run SCENE --dry-run' says what a scene needs.";
    }
    return finding;
}

Finding inspect_disk(const Machine& machine) {
    Finding finding{Health::ok, "disk", bytes_text(machine.disk_free) + " free here"};
    if (machine.disk_free < 1 * gibibyte) {
        finding.health = Health::warn;
        finding.to_do = "A run may fill it. Make room, or send results elsewhere with --out DIR.";
    }
    return finding;
}

Finding inspect_writing(const Machine& machine) {
    if (machine.write_error.empty()) return {Health::ok, "writing", "a file was written into this folder and removed"};
    return {Health::bad, "writing", "no file can be written into this folder: " + machine.write_error,
            "Go to a folder of yours, make room, or use --out DIR."};
}

Finding inspect_pictures(const Machine& machine) {
    if (!machine.xvfb.empty()) return {Health::ok, "pictures", "drawn on a screen of " + machine.xvfb};
    if (!machine.display.empty()) return {Health::ok, "pictures", "drawn on display " + machine.display};
    return {Health::warn, "pictures", "neither a display nor Xvfb: runs leave no pictures",
            "apt-get install xvfb xauth"};
}

}  // namespace

std::vector<Finding> diagnose(const BuildFacts& build, const Machine& machine) {
    std::vector<Finding> findings{
        {Health::ok, "dmp", build.version}, inspect_build(build),    inspect_vector_units(machine),
        inspect_processors(machine),        inspect_memory(machine), inspect_disk(machine),
        inspect_writing(machine),
    };
    if (build.libraries.empty()) {
        findings.push_back({Health::ok, "for clusters", "particles come from a file, frames are written in HDF5"});
        return findings;
    }
    findings.push_back(inspect_pictures(machine));
    findings.push_back({Health::ok, "libraries", build.libraries});
    findings.push_back(
        {Health::ok, "ParaView", "Debian's 5.11 fails on appended VTK XML; dmp writes inline binary, which it reads"});
    return findings;
}

}  // namespace dmp::cli
