// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "study/slurm.hpp"

namespace dmp::cli {

/// A job of Slurm that does runs of a study: an array, whose element N does the runs in line N of a file.
struct SlurmJob {
    std::string study;                 ///< its name
    std::filesystem::path directory;   ///< the current one when it was asked for, absolute
    std::filesystem::path folder;      ///< of the job's files, absolute
    std::size_t elements = 1;          ///< of the array, from 1 on
    int at_a_time = 0;                 ///< most elements that run at a time; 0: no limit
    std::vector<std::string> command;  ///< that does runs, to which "--run NAME ..." is added
    study::Slurm slurm;                ///< what to ask for
};

/// Names of a job's files in its folder.
inline constexpr const char* job_script_name = "job.sh";
inline constexpr const char* job_runs_name = "runs.txt";

/// The job's script, for a person to read. `form`: the text that its lines stand in, with the words @options@, @runs@
/// and @command@ where dmp puts them; job_form() is dmp's own.
[[nodiscard]] std::string job_script(const SlurmJob& job, const std::string& form);

/// dmp's own form.
[[nodiscard]] const std::string& job_form();

/// The form in a file. Throws InputError where it lacks one of the words, or has another one.
[[nodiscard]] std::string read_job_form(const std::filesystem::path& file);

/// A time as Slurm has it, rounded up to a minute: "1-02:30:00".
[[nodiscard]] std::string slurm_time(double seconds);

}  // namespace dmp::cli
