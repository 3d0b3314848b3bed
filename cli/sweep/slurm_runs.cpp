// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/slurm_runs.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <utility>

#include <fmt/format.h>
#include <poll.h>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "cli/exit_codes.hpp"
#include "cli/output_folder.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

constexpr int look_at_ends_ms = 1000;
/// Between calls of squeue [s]: few a minute, as it asks the one controller of the whole cluster.
constexpr double look_at_queue_s = 10, look_again_s = 4;
/// A run is lost when squeue has not had it so many times: a job that goes back into the queue may be between states.
constexpr int most_missing = 2;

/// Reasons to wait that do not pass by themselves.
bool needs_help(const std::string& reason) {
    constexpr std::array<std::string_view, 8> marks{
        "Held",           "held",         "Invalid", "NotAllowed", "PartitionTimeLimit", "PartitionNodeLimit",
        "BadConstraints", "PartitionDown"};
    return std::ranges::any_of(marks, [&](std::string_view mark) { return reason.find(mark) != std::string::npos; });
}

/// Of a job that has ended without a word of its run.
int exit_code_of_state(const std::string& state) {
    if (state.starts_with("CANCELLED")) return exit_terminated;
    if (state == "TIMEOUT") return exit_out_of_time;
    if (state == "OUT_OF_MEMORY") return exit_out_of_resource;
    return 128 + SIGKILL;
}

bool is_in_queue(const std::string& state) {
    constexpr std::array<std::string_view, 5> states{"PENDING", "RUNNING", "REQUEUED", "CONFIGURING", "SUSPENDED"};
    return std::ranges::find(states, state) != states.end();
}

/// The newest job that was to do a run, and which of its elements.
std::pair<const SubmittedJob*, long> job_with(const std::vector<SubmittedJob>& jobs, const std::string& run) {
    for (auto job = jobs.rbegin(); job != jobs.rend(); ++job)
        for (std::size_t k = 0; k < job->elements.size(); ++k)
            if (std::ranges::find(job->elements[k], run) != job->elements[k].end())
                return {&*job, static_cast<long>(k) + 1};
    return {nullptr, 0};
}

}  // namespace

SlurmJob job_of(const SlurmSettings& settings, const std::string& study, const fs::path& folder, std::size_t elements) {
    SlurmJob job;
    job.study = study;
    job.directory = fs::current_path();
    job.folder = fs::absolute(folder);
    job.elements = elements;
    job.at_a_time = settings.at_a_time;
    job.slurm = settings.slurm;
    job.command = {settings.program,
                   "sweep",
                   settings.study,
                   "--out",
                   settings.out.string(),
                   "--threads",
                   std::to_string(*settings.slurm.threads)};
    for (const std::string& each : settings.overrides) job.command.insert(job.command.end(), {"--set", each});
    if (*settings.slurm.ranks > 1)
        job.command.insert(job.command.end(), {"--ranks", std::to_string(*settings.slurm.ranks), "--launcher",
                                               std::string(to_string(*settings.slurm.launcher))});
    return job;
}

SlurmRuns::SlurmRuns(SweepRows& rows, SlurmQueue queue, SlurmSettings settings)
    : rows_(rows),
      queue_(std::move(queue)),
      settings_(std::move(settings)),
      folder_(rows.folder().path()),
      jobs_(folder_.jobs()) {}

void SlurmRuns::run(const StopSignals& signals) {
    take_earlier();
    while (!signals.flag()) {
        submit_some();
        if (pending_.empty() && unsubmitted_.empty()) break;
        show_progress();
        poll(nullptr, 0, look_at_ends_ms);  // a signal ends it
        rows_.folder().check();
        take_ends();
        if (!pending_.empty()) look_at_queue();
        rows_.write(false);
    }
    line_.clear();
    rows_.write(true);
    rows_.count_other_units();
}

void SlurmRuns::take_earlier() {
    std::string problem;
    const auto queue = queue_.elements(problem);
    if (!queue)
        throw ResourceError("squeue does not say what is in the queue: " + problem,
                            "Nothing was handed in. Try again when Slurm answers.");
    const std::map<std::string, QueuedElement> queued = queued_runs(jobs_, *queue);
    const std::vector<std::size_t> unfinished = rows_.take_earlier_ends([](auto, const auto&) { return false; });
    std::vector<std::string> taken;
    for (const std::size_t index : unfinished) {
        const study::Point point = rows_.points().at(index);
        const std::vector<JobEnd> ends = folder_.ends_of(point.name);
        if (const auto found = queued.find(point.name); found != queued.end()) {
            pending_[point.name] = index;
            queued_[point.name] = found->second;
            continue;
        }
        if (!ends.empty()) taken.push_back(point.name);
        if (ends.empty() || ends.back().is_unfinished() || ends.back().exit_code == exit_done)
            unsubmitted_.push_back(index);
        else
            add(index, failed_row(point, ends.back().exit_code, ends.back().error));
    }
    for (const std::size_t index : rows_.chosen())
        if (const std::string name = rows_.points().at(index).name; rows_.table().row(index)) taken.push_back(name);
    rows_.write(true);
    remove_ends(taken);
    if (!pending_.empty()) say(fmt::format("{} in the queue already.", count_text(pending_.size(), "run")));
}

void SlurmRuns::remove_ends(const std::vector<std::string>& runs) {
    for (const std::string& run : runs) {
        const std::vector<JobEnd> ends = folder_.ends_of(run);
        if (ends.empty()) continue;
        for (const JobEnd& end : ends)
            rows_.note_time(run, end.wall_s, end.processor_s, end.peak_memory, end.exit_code);
        folder_.remove_ends(run);
    }
}

void SlurmRuns::submit_some() {
    while (!unsubmitted_.empty() && pending_.size() < refused_with_) {
        const auto each = static_cast<std::size_t>(*settings_.slurm.runs_per_job);
        if (most_elements_ == 0) most_elements_ = queue_.most_elements();
        std::vector<std::vector<std::string>> elements;
        std::map<std::string, std::size_t> runs;
        std::size_t taken = 0;
        for (; taken < unsubmitted_.size(); ++taken) {
            if (elements.empty() || elements.back().size() == each) {
                if (elements.size() == most_elements_) break;
                elements.emplace_back();
            }
            const std::string& name = elements.back().emplace_back(rows_.points().at(unsubmitted_[taken]).name);
            runs[name] = unsubmitted_[taken];
        }
        if (!submit(elements)) return;
        pending_.merge(runs);
        unsubmitted_.erase(unsubmitted_.begin(), unsubmitted_.begin() + static_cast<std::ptrdiff_t>(taken));
    }
}

bool SlurmRuns::submit(const std::vector<std::vector<std::string>>& elements) {
    const fs::path folder = folder_.add_job(elements);
    const fs::path script = fs::absolute(folder) / job_script_name;
    write_file(script, job_script(job_of(settings_, rows_.study().name, folder, elements.size()), settings_.form));
    const SlurmQueue::Answer answer = queue_.submit(script);
    if (answer.job.empty()) {
        SlurmFolder::remove_job(folder);
        if (pending_.empty())
            throw InputError("sbatch refuses the job: " + answer.refusal,
                             "Give a partition, an account and a time that Slurm takes, in [slurm] of " +
                                 rows_.study().file +
                                 " or with --partition, --account, --time; 'sinfo' lists "
                                 "partitions and their limits. --slurm --dry-run shows the whole script.");
        refused_with_ = pending_.size();
        say(fmt::format("sbatch takes no more now; {} will be handed in as others end: {}",
                        count_text(unsubmitted_.size(), "run"), answer.refusal));
        return false;
    }
    refused_with_ = std::numeric_limits<std::size_t>::max();
    SlurmFolder::note_number(folder, answer.job);
    jobs_.push_back({folder, answer.job, elements});
    std::size_t runs = 0;
    for (const auto& element : elements) runs += element.size();
    say(fmt::format("Job {}: {}", answer.job, count_text(runs, "run")) +
        (runs == elements.size() ? "" : " in " + count_text(elements.size(), "element")));
    look_after_s_ = look_again_s;
    return true;
}

void SlurmRuns::take_ends() {
    std::vector<std::string> taken;
    for (const std::string& run : folder_.ended_runs()) {
        const auto found = pending_.find(run);
        if (found == pending_.end()) continue;
        const std::vector<JobEnd> ends = folder_.ends_of(run);
        if (ends.empty() || ends.back().is_unfinished()) continue;
        const std::size_t index = found->second;
        const study::Point point = rows_.points().at(index);
        const fs::path results = run_folder(rows_.folder().path(), run);
        if (ends.back().exit_code != exit_done)
            add(index, failed_row(point, ends.back().exit_code, ends.back().error));
        else if (contents_of(results).kind == FolderContents::Kind::finished)
            add(index, finished_row(rows_.study(), point, results));
        else
            continue;  // a file system that another machine writes to shows it later
        taken.push_back(run);
        pending_.erase(found);
    }
    if (taken.empty()) return;
    rows_.write(true);
    remove_ends(taken);
}

void SlurmRuns::look_at_queue() {
    if (seconds_since(looked_) < look_after_s_) return;
    std::string problem;
    const auto queue = queue_.elements(problem);
    looked_ = WallClock::now();
    look_after_s_ = look_at_queue_s;
    if (!queue) {
        tell_once("squeue gives no answer, dmp asks again: " + problem);
        return;
    }
    queued_ = queued_runs(jobs_, *queue);
    std::vector<std::string> lost;
    for (const auto& [run, index] : pending_) {
        if (queued_.contains(run)) {
            missing_.erase(run);
            continue;
        }
        look_after_s_ = look_again_s;
        if (++missing_[run] >= most_missing) lost.push_back(run);
    }
    for (const auto& [run, element] : queued_)
        if (element.is_waiting() && needs_help(element.reason))
            tell_once(fmt::format("job {} waits for something that does not come by itself: {}", element.job,
                                  element.reason));
    if (lost.empty()) return;
    take_ends();  // they may have come just now
    std::erase_if(lost, [&](const std::string& run) { return !pending_.contains(run) || !is_lost(run); });
    rows_.write(true);
    remove_ends(lost);
}

bool SlurmRuns::is_lost(const std::string& run) {
    const std::size_t index = pending_.at(run);
    const auto [job, element] = job_with(jobs_, run);
    const std::string name = job == nullptr ? "" : fmt::format("{}_{}", job->job, element);
    const JobState state = job == nullptr ? JobState{} : queue_.state_of(job->job, element);
    missing_.erase(run);
    if (is_in_queue(state.state)) return false;
    pending_.erase(run);
    const std::vector<JobEnd> ends = folder_.ends_of(run);
    int exit_code = exit_code_of_state(state.state);
    if (!ends.empty() && ends.back().is_unfinished()) exit_code = ends.back().exit_code;
    std::string said = job == nullptr ? "" : SlurmFolder::last_words(*job, element);
    if (said.empty()) said = state.state.empty() ? "Slurm no longer knows why" : state.state;
    add(index, failed_row(rows_.points().at(index), exit_code,
                          fmt::format("its job {} ended before the run did: {}", name, said)));
    return true;
}

void SlurmRuns::add(std::size_t index, SweepRow row) {
    if (const std::string text = rows_.add(index, std::move(row)); !text.empty()) say(text);
}

void SlurmRuns::say(const std::string& text) {
    line_.clear();
    print_error(text + "\n");
}

void SlurmRuns::tell_once(const std::string& text) {
    if (told_.insert(text).second) say(text);
}

void SlurmRuns::show_progress() {
    std::set<std::pair<std::string, long>> running;
    std::map<std::string, std::size_t> reasons;
    for (const auto& [run, element] : queued_) {
        if (!pending_.contains(run)) continue;
        if (element.is_waiting())
            ++reasons[element.reason];
        else
            running.insert({element.job, element.element});
    }
    SweepCounts& counts = rows_.counts();
    counts.running = running.size();
    std::string text = progress_text(counts, std::numeric_limits<double>::infinity());
    if (const std::size_t left = counts.left(); left > counts.running) {
        text += fmt::format(", {} waiting", count_text(left - counts.running));
        const auto most = std::ranges::max_element(reasons, {}, [](const auto& each) { return each.second; });
        if (most != reasons.end() && most->first != "None") text += " (" + most->first + ")";
    }
    line_.show(text);
    if (!is_terminal(Stream::error) && lines_.is_due(seconds_since(started_))) print_error(text + "\n");
}

std::string SlurmRuns::left_text() const {
    std::set<std::string> numbers;
    for (const auto& [run, index] : pending_)
        if (const auto [job, element] = job_with(jobs_, run); job != nullptr) numbers.insert(job->job);
    if (numbers.empty()) return "";
    std::string jobs;
    for (const std::string& number : numbers) jobs += " " + number;
    return fmt::format("The jobs stay in the queue, and their runs go on: {}. To end them:\n  scancel{}\n",
                       count_text(pending_.size(), "run"), jobs);
}

}  // namespace dmp::cli
