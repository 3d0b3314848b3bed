// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "geometry/geometry.hpp"

namespace dmp::geometry {

/// The program that reads geometries beside this one, and what it may take.
struct GeometryProcess {
    /// The program and its arguments; it calls answer_geometry_request.
    std::vector<std::string> command;
    double seconds = 600;        ///< after which it is ended
    double silent_seconds = 10;  ///< from one call of still_reading to the next
    /// Called while it goes on: the time so far [s] and what it does, "it was reading the file". None: nobody is told.
    std::function<void(double, const std::string&)> still_reading{};
    std::size_t largest_answer = 4ULL << 30U;  ///< [bytes]
};

/// read_geometry in a process of its own, where gmsh and OpenCASCADE parse what strangers wrote: a crash of theirs, a
/// hang or a want of memory there is an error here, with the file and what happened. What our own readers read (files
/// of triangles) is read in this process. The geometry and the errors are the same, bit for bit and word for word.
///
/// The process is started by posix_spawn, not by fork: handlers that MPI has for forks do not run, and locks that other
/// threads hold do not matter. It inherits the working folder and the environment.
///
/// Throws InputError as read_geometry does, and for a child that crashed or took too long; ResourceError where no
/// process can be started.
Geometry read_geometry_in_process(const GeometryOptions& options, const GeometryProcess& child);

/// The child's side: reads the request from stdin, answers on descriptor 3 and returns the exit code. It limits its own
/// memory to that of the machine, and ends with its parent.
int answer_geometry_request();

}  // namespace dmp::geometry
