// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/slurm_job.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "base/safe_file.hpp"
#include "base/shell_word.hpp"
#include "cli/uses.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> form_words{"@options@", "@runs@", "@command@"};

/// What stands in an #SBATCH line as one word.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + "\"";
}

/// A path in which Slurm puts nothing else for "%".
std::string without_patterns(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '%' ? "%%" : std::string(1, c);
    return result;
}

std::string options_text(const SlurmJob& job) {
    std::string text;
    const auto add = [&](const std::string& option) { text += "#SBATCH --" + option + "\n"; };
    const auto add_given = [&](const char* name, const Value<std::string>& value) {
        if (value.given()) add(std::string(name) + "=" + *value);
    };
    const study::Slurm& slurm = job.slurm;
    add("job-name=" + quoted(job.study));
    add(fmt::format("array=1-{}", job.elements) + (job.at_a_time > 0 ? fmt::format("%{}", job.at_a_time) : ""));
    add("output=" + quoted(without_patterns(job.folder.string()) + "/element_%a.log"));
    add("open-mode=append");
    add("chdir=" + quoted(job.directory.string()));
    add(fmt::format("ntasks={}", *slurm.ranks));
    add(fmt::format("cpus-per-task={}", *slurm.threads));
    add_given("mem", slurm.memory);
    if (slurm.time.given()) add("time=" + slurm_time(*slurm.time));
    add(fmt::format("signal=B:USR1@{:.0f}", std::ceil(slurm.seconds_before_limit())));
    add("requeue");
    add_given("partition", slurm.partition);
    add_given("account", slurm.account);
    add_given("qos", slurm.qos);
    add_given("constraint", slurm.constraint);
    return text;
}

std::string command_text(const SlurmJob& job) {
    std::string text;
    for (const std::string& word : job.command) text += shell_word(word) + " ";
    return text + "--run $runs";
}

}  // namespace

const std::string& job_form() {
    static const std::string form = R"(#!/bin/bash
# Written by 'dmp sweep --slurm'. Each element of this array does the runs that its line of a file names.
@options@
runs=$(sed -n "${SLURM_ARRAY_TASK_ID}p" @runs@)

@command@ &
dmp=$!
# Slurm sends SIGUSR1 before the time limit: the run writes a checkpoint, dmp ends with code 138, and the element goes
# back into the queue, to go on from there. SIGTERM comes with scancel: a checkpoint, and that was it.
trap 'kill -USR1 "$dmp" 2>/dev/null' USR1
trap 'kill -TERM "$dmp" 2>/dev/null' TERM
while wait "$dmp"; code=$?; kill -0 "$dmp" 2>/dev/null; do :; done # a signal ends a wait early
if [ "$code" -eq 138 ]; then scontrol requeue "$SLURM_JOB_ID"; fi
exit "$code"
)";
    return form;
}

std::string job_script(const SlurmJob& job, const std::string& form) {
    const std::array<std::string, 3> texts{options_text(job), shell_word((job.folder / job_runs_name).string()),
                                           command_text(job)};
    std::string script = form;
    for (std::size_t k = 0; k < form_words.size(); ++k)
        for (auto at = script.find(form_words[k]); at != std::string::npos;
             at = script.find(form_words[k], at + texts[k].size()))
            script.replace(at, form_words[k].size(), texts[k]);
    return script;
}

std::string read_job_form(const fs::path& file) {
    std::string form = read_file(file);
    const auto throw_wrong = [&](const std::string& what) {
        throw InputError({file.string(), 0, 0}, what,
                         "A job script has @options@ (the #SBATCH lines), @runs@ (the file with the runs) and "
                         "@command@ (what does them); docs/studies.md shows dmp's own.");
    };
    static const std::regex any_word("@[a-z_]+@");
    for (std::sregex_iterator word(form.begin(), form.end(), any_word); word != std::sregex_iterator(); ++word)
        if (std::ranges::find(form_words, word->str()) == form_words.end())
            throw_wrong("the job script has " + word->str() + ", which dmp knows nothing to put for");
    for (const std::string& word : form_words)
        if (form.find(word) == std::string::npos) throw_wrong("the job script has no " + word);
    return form;
}

std::string slurm_time(double seconds) {
    const auto minutes = static_cast<long>(std::ceil(seconds / 60));
    return fmt::format("{}-{:02}:{:02}:00", minutes / (24 * 60), minutes / 60 % 24, minutes % 60);
}

}  // namespace dmp::cli
