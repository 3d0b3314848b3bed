// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/commands.hpp"

namespace dmp::cli {

/// `dmp sweep STUDY --run NAME`: does runs of a study one after another, in a job of a queueing system. It takes no
/// lock on the study's folder, where many such jobs are at work, and leaves the end of each run below slurm/ends, for
/// the sweep to take. Returns the run's exit code; 128 and the signal's number where it was asked to stop. Throws
/// InputError where the study or its scene is not the one that the folder has.
int do_runs(const SweepCommand& command);

}  // namespace dmp::cli
