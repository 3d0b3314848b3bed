// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/slurm_sweep.hpp"

#include <algorithm>
#include <set>

#include "base/errors.hpp"
#include "cli/terminal.hpp"
#include "study/read_slurm.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

void check_options(const SweepCommand& command) {
    const SlurmOptions& options = command.slurm_options;
    if (command.slurm || command.resume || !command.runs.empty()) return;
    const bool given = !options.partition.empty() || !options.account.empty() || !options.time.empty() ||
                       !options.form.empty() || options.ranks > 0 || options.threads > 0;
    if (given)
        throw InputError("--partition, --account, --time, --ranks, --threads and --job-template are of jobs of Slurm",
                         "Give --slurm, too. On this machine a run takes 'run.threads' of the scene.");
}

/// Numbers of the study's jobs that wait or run.
std::set<std::string> queued_jobs(const fs::path& folder) {
    std::set<std::string> numbers;
    const std::vector<SubmittedJob> jobs = SlurmFolder(folder).jobs();
    if (jobs.empty()) return numbers;
    const auto queue = SlurmQueue::if_there();
    if (!queue) return numbers;
    std::string problem;
    const auto elements = queue->elements(problem);
    if (!elements)
        throw ResourceError("jobs of this study may be in the queue, and squeue does not say: " + problem,
                            "Try again when Slurm answers.");
    for (const auto& [run, element] : queued_runs(jobs, *elements)) numbers.insert(element.job);
    return numbers;
}

}  // namespace

SlurmSettings slurm_settings(const SweepCommand& command, const study::Study& study, const fs::path& folder) {
    check_options(command);
    const SlurmOptions& options = command.slurm_options;
    const auto number = [](int value) { return value > 0 ? std::to_string(value) : ""; };
    SlurmSettings settings;
    settings.program = fs::read_symlink("/proc/self/exe").string();
    settings.study = command.study;
    settings.overrides = command.overrides;
    settings.out = folder;
    settings.slurm = study::with_options(study.slurm, {{"--partition", options.partition},
                                                       {"--account", options.account},
                                                       {"--time", options.time},
                                                       {"--ranks", number(options.ranks)},
                                                       {"--threads", number(options.threads)}});
    if (!settings.slurm.threads.given()) settings.slurm.threads = std::max(1, *study.scene.run.threads);
    settings.at_a_time = command.jobs;
    if (!options.form.empty()) settings.form = read_job_form(options.form);
    return settings;
}

bool has_queued_jobs(const fs::path& folder) { return !queued_jobs(folder).empty(); }

void need_no_queued_jobs(const fs::path& folder) {
    std::string jobs;
    for (const std::string& number : queued_jobs(folder)) jobs += " " + number;
    if (!jobs.empty())
        throw InputError({folder.string(), 0, 0}, "jobs of the study in it wait or run",
                         "Nothing was removed. End them first:\n  scancel" + jobs);
}

std::string script_text(const SlurmSettings& settings, const study::Study& study, std::size_t runs) {
    const auto each = static_cast<std::size_t>(*settings.slurm.runs_per_job);
    const SlurmJob job = job_of(settings, study.name, settings.out / "slurm" / "1", (runs + each - 1) / each);
    return Style(Stream::output).strong("Job") + "\n" + job_script(job, settings.form) + "\n";
}

}  // namespace dmp::cli
