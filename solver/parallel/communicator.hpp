// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// MPI's C++ classes are no longer part of its standard.
#define OMPI_SKIP_MPICXX 1
#include <mpi.h>

namespace dmp::solver {

/// Wraps MPI's communicator, so that headers can refer to it without including MPI.
struct Communicator {
    MPI_Comm handle = MPI_COMM_NULL;
};

}  // namespace dmp::solver
