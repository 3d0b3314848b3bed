// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep_runs.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/folder_lock.hpp"
#include "base/safe_file.hpp"
#include "cli/exit_codes.hpp"
#include "cli/machine.hpp"
#include "cli/output_folder.hpp"
#include "cli/process_memory.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "scene/read_scene.hpp"
#include "solver/state/checkpoints.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

constexpr int look_again_ms = 200;
/// A table of thousands of rows is not written anew for each run that takes less than this [s].
constexpr double seconds_between_tables = 1;
constexpr std::size_t most_failures_told = 10;
/// The process that starts the runs is killed by somebody, not by itself.
constexpr int most_losses = 3;

/// Whether a run that ends so can be gone on with: at a signal, or at its wall-time limit.
bool is_unfinished(int exit_code) { return exit_code == exit_out_of_time || exit_code > 128; }

std::string killed_text(int signal) {
    const char* name = strsignal(signal);
    return fmt::format("it was ended by signal {} ({}){}", signal, name == nullptr ? "" : name,
                       signal == SIGKILL ? ", perhaps for lack of memory" : "");
}

/// Why a run that was begun cannot go on from any of its checkpoints; "": it can. What else stands against it, such as
/// another geometry, is the run's error.
std::string refused_checkpoint(const std::string& scene_file, const std::vector<std::string>& overrides,
                               const fs::path& run) {
    const Scene scene = read_scene(scene_file, overrides);
    try {
        static_cast<void>(checkpoint_to_resume(run, resolved_scene(scene), *scene.run.duration));
    } catch (const InputError& error) {
        return one_line(error);
    }
    return "";
}

}  // namespace

SweepRuns::SweepRuns(const study::Study& study, const study::Points& points, const SweepFolder& folder,
                     SweepSettings settings)
    : study_(study),
      points_(points),
      folder_(folder),
      settings_(std::move(settings)),
      scene_text_(read_file(study.scene.file)),
      table_(study, points.size()),
      waiting_(settings_.chosen.begin(), settings_.chosen.end()),
      starter_(settings_.program),
      memory_(study, own_memory().most) {
    counts_.runs = waiting_.size();
    take_earlier_ends();
    if (const fs::path timing = folder.path() / sweep_timing_name; !fs::exists(timing))
        write_file(timing, "run,wall_time [s],processor_time [s],peak_memory [B],exit_code\n");
}

void SweepRuns::take_earlier_ends() {
    const std::map<std::string, EarlierFailure> failures = earlier_failures(folder_.path() / sweep_results_name);
    std::vector<bool> chosen(points_.size(), false);
    for (const std::size_t index : waiting_) chosen[index] = true;
    waiting_.clear();
    for (std::size_t index = 0; index < points_.size(); ++index) {
        const study::Point point = points_.at(index);
        const fs::path run = run_folder(folder_.path(), point.name);
        const bool finished = contents_of(run).kind == FolderContents::Kind::finished;
        if (!chosen[index]) {
            // The table has also the runs that were not asked for now.
            if (finished)
                table_.set(index, finished_row(study_, point, run));
            else if (const auto failure = failures.find(point.name); failure != failures.end())
                table_.set(index, failed_row(point, failure->second.exit_code, failure->second.error));
        } else if (finished && !is_held(index, run)) {
            add(index, finished_row(study_, point, run));
        } else {
            waiting_.push_back(index);
        }
    }
}

void SweepRuns::run(const StopSignals& signals) {
    bool stopping = false;
    learn_memory(signals);
    while (true) {
        if (signals.flag() && !stopping) {
            stopping = true;
            starter_.stop_all();
            if (!running_.empty()) say("Stopping: the runs write their checkpoints.");
        }
        if (!stopping) start_some(signals);
        if (running_.empty() && (stopping || (waiting_.empty() && put_off_.empty()))) break;
        show_progress();
        collect(stopping);
        folder_.check();
        write_table(false);
    }
    line_.clear();
    write_table(true);
    count_other_units();
}

void SweepRuns::count_other_units() {
    const auto rows = table_.rows();
    for (const std::size_t index : settings_.chosen) {
        if (!rows[index] || rows[index]->failed() == table_.row(index)->failed()) continue;
        ++counts_.failed;
        --counts_.done;
    }
}

void SweepRuns::start_some(const StopSignals& signals) {
    waiting_.insert(waiting_.begin(), put_off_.begin(), put_off_.end());
    put_off_.clear();
    while (!waiting_.empty() && running_.size() < static_cast<std::size_t>(settings_.jobs) && !signals.flag()) {
        const std::size_t index = waiting_.front();
        waiting_.pop_front();
        study::Point point = points_.at(index);
        const fs::path run = run_folder(folder_.path(), point.name);
        if (is_held(index, run)) {
            put_off_.push_back(index);
        } else if (contents_of(run).kind == FolderContents::Kind::finished) {
            add(index, finished_row(study_, point, run));
        } else if (!has_room(point)) {
            waiting_.push_front(index);
            return;
        } else {
            start(index, std::move(point));
        }
    }
}

void SweepRuns::learn_memory(const StopSignals& signals) {
    if (waiting_.empty() || signals.flag()) return;
    const std::size_t index = waiting_.front();
    const study::Point point = points_.at(index);
    const fs::path output = run_output(folder_.path(), point.name);
    std::vector<std::string> words = run_words(point);
    words.insert(words.end(), {"--dry-run", "--trial", "0 s"});
    starter_.start(index, words, output);
    std::vector<RunEnd> ends;
    for (bool stopping = false; ends.empty();) {
        if (signals.flag() && !std::exchange(stopping, true)) starter_.stop_all();
        line_.show("making particles, to learn what memory a run takes");
        ends = starter_.ends(look_again_ms);
        folder_.check();
    }
    line_.clear();
    fs::remove(output);
    // What is wrong with a run, it says itself.
    if (ends.front().lost || ends.front().how.exit_code != exit_done) return;
    memory_.take_trial(point, ends.front().how.peak_memory);
    const double expected = memory_.expected(point), all = machine_memory().all;
    if (all > 0 && expected > all)
        throw ResourceError("run " + point.name + " takes about " + bytes_text(expected) +
                                " of memory, and this machine has " + bytes_text(all),
                            "Choose fewer particles, or a machine with more memory.");
}

bool SweepRuns::has_room(const study::Point& point) {
    const double expected = memory_.expected(point), free = machine_memory().free;
    if (running_.empty() || expected == 0 || free == 0) return true;
    std::vector<SweepMemory::Running> running;
    for (const Running& each : running_)
        running.push_back({memory_.expected(each.point), memory_of(starter_.process_of(each.index)).now});
    if (SweepMemory::fits(expected, free, running)) return true;
    if (!std::exchange(told_memory_, true))
        say("run " + point.name + " waits for memory: it takes about " + bytes_text(expected) + ", " +
            bytes_text(free) + " is free, and those that run may grow. Others wait likewise.");
    return false;
}

bool SweepRuns::is_held(std::size_t index, const fs::path& run) {
    // A run of a sweep that was killed may still write its checkpoint.
    if (!fs::exists(run / lock_file_name)) return false;
    const auto holder = FolderLock::take(run).holder;
    if (!holder) return false;
    if (told_held_.insert(index).second)
        say("run " + run.filename().string() +
            " waits for the end of another dmp that writes there: " + holder->text());
    return true;
}

void SweepRuns::start(std::size_t index, study::Point point) {
    if (read_file(study_.scene.file) != scene_text_)
        throw InputError({study_.scene.file, 0, 0}, "the scene was changed while its study ran",
                         "Put it back and go on with --resume, or start the changed study in another folder.");
    const fs::path folder = run_folder(folder_.path(), point.name);
    std::vector<std::string> words = run_words(point);
    const FolderContents contents = contents_of(folder);
    bool resumed = contents.kind == FolderContents::Kind::unfinished && contents.has_checkpoint;
    if (resumed) {
        const std::string refused =
            refused_checkpoint(study_.scene.file, study::overrides(study_.keys(), point), folder);
        if (!refused.empty())
            say("run " + point.name + " cannot go on from its checkpoint, and starts anew: " + refused);
        resumed = refused.empty();
    }
    if (resumed)
        words.emplace_back("--resume");
    else if (contents.kind != FolderContents::Kind::nothing)
        words.emplace_back("--overwrite");
    starter_.start(index, words, run_output(folder_.path(), point.name));
    running_.push_back({index, std::move(point), WallClock::now()});
    ++counts_.running;
}

std::vector<std::string> SweepRuns::run_words(const study::Point& point) const {
    std::vector<std::string> words{settings_.program,
                                   "run",
                                   study_.scene.file,
                                   "--out",
                                   run_folder(folder_.path(), point.name).string(),
                                   "--threads",
                                   std::to_string(settings_.threads)};
    for (const std::string& each : study::overrides(study_.keys(), point)) words.insert(words.end(), {"--set", each});
    for (const study::RunOutput each : settings_.left_out) words.insert(words.end(), {"--leave-out", to_string(each)});
    return words;
}

void SweepRuns::collect(bool stopping) {
    const std::vector<RunEnd> ends = starter_.ends(look_again_ms);
    put_off_lost(ends);
    for (const RunEnd& end : ends) {
        const auto run = std::ranges::find(running_, end.id, &Running::index);
        --counts_.running;
        if (!end.lost) {
            losses_ = 0;
            note_time(*run, end.how);
            ended_s_ += seconds_since(run->start);
            ++ended_;
            take_end(*run, end, stopping);
        }
        running_.erase(run);
    }
}

void SweepRuns::put_off_lost(const std::vector<RunEnd>& ends) {
    const std::size_t before = put_off_.size();
    for (const RunEnd& end : ends)
        if (end.lost) put_off_.push_back(end.id);
    if (put_off_.size() == before) return;
    if (++losses_ == most_losses)
        throw ResourceError("the process that starts the runs was ended from outside, again and again",
                            "Find out what ends it, perhaps for lack of memory, then go on with --resume.");
    say("The process that starts the runs was ended from outside. Those that ran go on from their checkpoints.");
}

void SweepRuns::take_end(const Running& running, const RunEnd& end, bool stopping) {
    const fs::path folder = run_folder(folder_.path(), running.point.name);
    const fs::path output = run_output(folder_.path(), running.point.name);
    const ChildEnd& how = end.how;
    if (how.exit_code == exit_done) {
        memory_.take_end(running.point, how.peak_memory);
        add(running.index, finished_row(study_, running.point, folder));
        fs::remove(output);  // run.log has it
        return;
    }
    if (stopping && is_unfinished(how.exit_code)) return;
    const std::string said = !end.problem.empty() ? end.problem
                             : how.signal != 0    ? killed_text(how.signal)
                                                  : read_file(output);
    add(running.index, failed_row(running.point, how.exit_code, said));
}

void SweepRuns::add(std::size_t index, SweepRow row) {
    if (row.failed()) {
        ++counts_.failed;
        if (counts_.failed <= most_failures_told) say("run " + row.run + " failed: " + row.error);
        if (counts_.failed == most_failures_told)
            say(fmt::format("More of them are told in {} only.", sweep_results_name));
    } else {
        ++counts_.done;
    }
    table_.set(index, std::move(row));
    changed_ = true;
}

void SweepRuns::write_table(bool at_once) {
    if (!changed_ || (!at_once && seconds_since(written_) < seconds_between_tables)) return;
    write_file(folder_.path() / sweep_results_name, table_.text());
    written_ = WallClock::now();
    changed_ = false;
}

void SweepRuns::note_time(const Running& running, const ChildEnd& end) const {
    append_to_file(folder_.path() / sweep_timing_name,
                   fmt::format("{},{:.3f},{:.3f},{:.0f},{}\n", running.point.name, seconds_since(running.start),
                               end.processor_s, end.peak_memory, end.exit_code));
}

void SweepRuns::say(const std::string& line) {
    line_.clear();
    print_error(line + "\n");
}

void SweepRuns::show_progress() {
    const double wall = seconds_since(started_);
    std::vector<double> running;
    for (const Running& each : running_) running.push_back(seconds_since(each.start));
    const double mean = ended_ == 0 ? 0 : ended_s_ / static_cast<double>(ended_);
    const std::string text =
        progress_text(counts_, seconds_left(mean, running, waiting_.size() + put_off_.size(), settings_.jobs));
    line_.show(text);
    if (!is_terminal(Stream::error) && lines_.is_due(wall)) print_error(text + "\n");
}

}  // namespace dmp::cli
