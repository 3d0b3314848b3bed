// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// MPI's C++ classes are no part of its standard any more.
#define OMPI_SKIP_MPICXX 1
#include <mpi.h>

namespace dmp::solver {

/// MPI's communicator behind a name that headers can use without MPI's own.
struct Communicator {
    MPI_Comm handle = MPI_COMM_NULL;
};

}  // namespace dmp::solver
