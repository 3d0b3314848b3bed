// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep_runs.hpp"

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
#include "cli/sweep/run_words.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "scene/read_scene.hpp"
#include "solver/state/checkpoints.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

constexpr int look_again_ms = 200;
/// The process that starts the runs is killed by somebody, not by itself.
constexpr int most_losses = 3;

/// Whether a run that ends so can be gone on with: at a signal, or at its wall-time limit.
bool is_unfinished(int exit_code) { return exit_code == exit_out_of_time || exit_code > 128; }

}  // namespace

SweepRuns::SweepRuns(SweepRows& rows, SweepSettings settings)
    : rows_(rows),
      study_(rows.study()),
      points_(rows.points()),
      folder_(rows.folder()),
      settings_(std::move(settings)),
      scene_text_(read_file(study_.scene.file)),
      starter_(settings_.program),
      memory_(study_, own_memory().most) {
    const std::vector<std::size_t> unfinished =
        rows_.take_earlier_ends([&](std::size_t index, const fs::path& run) { return is_held(index, run); });
    waiting_.assign(unfinished.begin(), unfinished.end());
}

bool SweepRuns::is_to_stop(const StopSignals& signals) const {
    return signals.flag() || WallClock::now() >= settings_.stop_at;
}

void SweepRuns::run(const StopSignals& signals) {
    bool stopping = false;
    learn_memory(signals);
    while (true) {
        if (is_to_stop(signals) && !stopping) {
            stopping = true;
            starter_.stop_all();
            if (!running_.empty()) say("Stopping: the runs write their checkpoints.");
        }
        if (!stopping) start_some(signals);
        if (running_.empty() && (stopping || (waiting_.empty() && put_off_.empty()))) break;
        show_progress();
        collect(stopping);
        folder_.check();
        rows_.write(false);
    }
    line_.clear();
    rows_.write(true);
    rows_.count_other_units();
}

void SweepRuns::start_some(const StopSignals& signals) {
    waiting_.insert(waiting_.begin(), put_off_.begin(), put_off_.end());
    put_off_.clear();
    while (!waiting_.empty() && running_.size() < static_cast<std::size_t>(settings_.jobs) && !is_to_stop(signals)) {
        const std::size_t index = waiting_.front();
        waiting_.pop_front();
        study::Point point = points_.at(index);
        const fs::path run = run_folder(folder_.path(), point.name);
        if (is_held(index, run)) {
            put_off_.push_back(index);
        } else if (contents_of(run).kind == FolderContents::Kind::finished) {
            add(index, finished_row(study_, point, run));
        } else if (settings_.may_start && !settings_.may_start(index)) {
            refused_.push_back(index);
        } else if (!has_room(point)) {
            waiting_.push_front(index);
            return;
        } else {
            start(index, std::move(point));
        }
    }
}

void SweepRuns::learn_memory(const StopSignals& signals) {
    if (waiting_.empty() || is_to_stop(signals)) return;
    const std::size_t index = waiting_.front();
    const study::Point point = points_.at(index);
    const fs::path output = run_output(folder_.path(), point.name);
    std::vector<std::string> words =
        run_line(study_, point, folder_.path(), settings_.program, settings_.threads, settings_.left_out);
    words.insert(words.end(), {"--dry-run", "--trial", "0 s"});
    starter_.start(index, words, output);
    std::vector<RunEnd> ends;
    for (bool stopping = false; ends.empty();) {
        if (is_to_stop(signals) && !std::exchange(stopping, true)) starter_.stop_all();
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

void SweepRuns::check_scene() {
    const std::string text = read_file(study_.scene.file);
    if (text == scene_text_) return;
    const auto refuse = [&](const std::string& why) {
        throw InputError({study_.scene.file, 0, 0}, "the scene was changed while its study ran" + why,
                         "Put it back and go on with --resume, or start the changed study in another folder.");
    };
    study::Study now = study_;
    try {
        now.scene = read_scene(study_.scene.file, study_.overrides);
    } catch (const InputError& error) {
        refuse(std::string(", and cannot be read: ") + error.problem());
    }
    if (study::identity_of(now) != study::identity_of(study_)) refuse("");
    scene_text_ = text;  // the runs are the same: what changed is a comment, the title or the number of threads
}

void SweepRuns::start(std::size_t index, study::Point point) {
    check_scene();
    const RunWords words =
        words_for_run(study_, point, folder_.path(), settings_.program, settings_.threads, settings_.left_out);
    if (!words.note.empty()) say(words.note);
    starter_.start(index, words.words, run_output(folder_.path(), point.name));
    running_.push_back({index, std::move(point), WallClock::now()});
    ++rows_.counts().running;
}

void SweepRuns::collect(bool stopping) {
    const std::vector<RunEnd> ends = starter_.ends(look_again_ms);
    put_off_lost(ends);
    // What was learnt from those that have ended may let others start.
    if (!ends.empty()) waiting_.insert(waiting_.begin(), refused_.begin(), refused_.end());
    if (!ends.empty()) refused_.clear();
    for (const RunEnd& end : ends) {
        const auto run = std::ranges::find(running_, end.id, &Running::index);
        --rows_.counts().running;
        if (!end.lost) {
            losses_ = 0;
            rows_.note_time(run->point.name, seconds_since(run->start), end.how.processor_s, end.how.peak_memory,
                            end.how.exit_code);
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
    if (const std::string text = rows_.add(index, std::move(row)); !text.empty()) say(text);
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
        progress_text(rows_.counts(), seconds_left(mean, running, waiting_.size() + put_off_.size(), settings_.jobs));
    line_.show(text);
    if (!is_terminal(Stream::error) && lines_.is_due(wall)) print_error(text + "\n");
}

}  // namespace dmp::cli
