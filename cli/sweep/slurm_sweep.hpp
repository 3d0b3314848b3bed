// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "cli/commands.hpp"
#include "cli/sweep/slurm_runs.hpp"
#include "study/study.hpp"

namespace dmp::cli {

/// What the study and the command line say of its jobs. Throws InputError for an option that needs --slurm or cannot
/// have its value, or a form that cannot be read.
[[nodiscard]] SlurmSettings slurm_settings(const SweepCommand& command, const study::Study& study,
                                           const std::filesystem::path& folder);

/// Whether jobs of the study in this folder wait or run; false where there is no Slurm.
[[nodiscard]] bool has_queued_jobs(const std::filesystem::path& folder);

/// Throws InputError where they do: they would write into a folder that is to be removed.
void need_no_queued_jobs(const std::filesystem::path& folder);

/// The script of the job that would do these runs, for a dry run.
[[nodiscard]] std::string script_text(const SlurmSettings& settings, const study::Study& study, std::size_t runs);

}  // namespace dmp::cli
