// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace dmp {

/// Tells one process from all others: on other machines, before a reboot, and after its number went to another.
struct ProcessIdentity {
    std::string host;     ///< the machine's name, for people: two machines may have the same
    std::string machine;  ///< this start of the machine and its space of process numbers; "": not known
    long pid = 0;
    long long started = 0;  ///< clock ticks after the start of the machine

    bool operator==(const ProcessIdentity&) const = default;
};

[[nodiscard]] ProcessIdentity this_process();

/// What can be found out about a process from here.
enum class ProcessState { running, ended, unknown };

/// unknown: of another machine, or of another space of process numbers (a container).
[[nodiscard]] ProcessState state_of(const ProcessIdentity& process);

}  // namespace dmp
