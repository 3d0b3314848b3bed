// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dmp::geometry {

/// What the kernel offers to confine a process with.
struct Confinement {
    bool system_calls = false;  ///< seccomp: which system calls a process may make
    int files = 0;              ///< Landlock's version: which files a process may open; 0: there is none
};

/// What confine() uses on this machine. None in a build with the address sanitizer, which needs what it forbids.
[[nodiscard]] Confinement confinement_offered();

/// Confines this process and the threads that it starts from now on, for good, as far as the kernel offers it:
///
/// - limits: no bytes into files, 256 open files, the machine's memory, no core dumps;
/// - seccomp: no other process or program, no network, no opening of files for writing, no change of any folder, no
///   signals or looks into other processes; a process that starts a program ends with SIGSYS;
/// - Landlock: no file can be opened but the one that is open as `readable` (-1: none at all), and no TCP port.
///
/// Files that are open stay so, whatever they are. Call it before there are other threads.
void confine(int readable);

}  // namespace dmp::geometry
