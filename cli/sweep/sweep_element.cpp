// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep_element.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/folder_lock.hpp"
#include "base/safe_file.hpp"
#include "base/wall_clock.hpp"
#include "cli/exit_codes.hpp"
#include "cli/output_folder.hpp"
#include "cli/stop_signals.hpp"
#include "cli/sweep/child_process.hpp"
#include "cli/sweep/other_program.hpp"
#include "cli/sweep/run_words.hpp"
#include "cli/sweep/slurm_folder.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "cli/sweep/sweep_table.hpp"
#include "cli/terminal.hpp"
#include "solver/state/checkpoint_folder.hpp"
#include "study/read_study.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

constexpr int look_again_ms = 200;

/// "123_4"; "": this is no job of Slurm.
std::string job_here() {
    const char* job = std::getenv("SLURM_ARRAY_JOB_ID");
    const char* element = std::getenv("SLURM_ARRAY_TASK_ID");
    return job == nullptr || element == nullptr ? "" : std::string(job) + "_" + element;
}

/// The index of a run given by its name, or its number, from 1 on.
std::size_t run_called(const std::string& name, const study::Points& points) {
    const SourceLocation location{"--run " + name, 0, 0};
    const std::string number = name.substr(0, name.find('_'));
    if (number.empty() || number.size() > 9 || number.find_first_not_of("0123456789") != std::string::npos)
        throw InputError(
            location, "this is no run",
            "Give its name, such as 0001_1234abcd, or its number; 'dmp sweep STUDY --dry-run' lists them.");
    const std::size_t index = std::stoul(number);
    if (index < 1 || index > points.size())
        throw InputError(location, fmt::format("the study has the runs 1 to {}", points.size()),
                         "Was the study changed since the job was handed in?");
    if (name != number && points.at(index - 1).name != name)
        throw InputError(location, "run " + number + " of the study is " + points.at(index - 1).name,
                         "The study or its scene was changed since the job was handed in: put it back, or start the "
                         "changed study in another folder.");
    return index - 1;
}

long newest_checkpoint(const fs::path& run) {
    try {
        const auto found = CheckpointFolder(run).newest_good();
        return found ? found->step : -1;
    } catch (const Error&) {  // all are damaged
        return -1;
    }
}

/// What starts the ranks of a run: nothing for one of them.
std::vector<std::string> launcher_words(const SlurmOptions& options) {
    if (options.ranks <= 1) return {};
    const std::string ranks = std::to_string(options.ranks), threads = std::to_string(std::max(1, options.threads));
    if (options.launcher == study::Launcher::srun)
        return {"srun", "--ntasks=" + ranks, "--cpus-per-task=" + threads, "--kill-on-bad-exit=1"};
    // Open MPI would keep all threads of a rank on one core.
    if (options.threads > 1) return {"mpirun", "-n", ranks, "--bind-to", "none"};
    return {"mpirun", "-n", ranks};
}

class Element {
  public:
    Element(const SweepCommand& command, const study::Study& study, study::LeftOut left_out, fs::path folder)
        : command_(command),
          study_(study),
          left_out_(std::move(left_out)),
          folder_(std::move(folder)),
          ends_(folder_) {}

    /// Returns the run's exit code.
    int run(const study::Point& point) {
        const fs::path run = run_folder(folder_, point.name);
        if (!is_free(run)) return signals_.exit_code();
        JobEnd end;
        end.job = job_here();
        if (contents_of(run).kind != FolderContents::Kind::finished) end = done(point, run);
        ends_.add_end(point.name, end);
        return end.is_unfinished() ? signals_.exit_code() : end.exit_code;
    }
    [[nodiscard]] bool is_stopping() const { return signals_.flag(); }

  private:
    /// Waits for another dmp that writes there: one that is being killed, or whose node is gone. False: asked to stop.
    bool is_free(const fs::path& run) const {
        bool told = false;
        while (!signals_.flag()) {
            if (!fs::exists(run / lock_file_name)) return true;
            const auto holder = FolderLock::take(run).holder;
            if (!holder) return true;
            if (!told)
                print_error("run " + run.filename().string() +
                            " waits for the end of another dmp that writes there: " + holder->text() + "\n");
            told = true;
            std::this_thread::sleep_for(std::chrono::milliseconds(look_again_ms));
        }
        return false;
    }

    JobEnd done(const study::Point& point, const fs::path& run) {
        const RunWords start = words_for_run(study_, point, folder_, command_.typed.program(),
                                             std::max(1, command_.slurm_options.threads), left_out_);
        if (!start.note.empty()) print_error(start.note + "\n");
        const fs::path output = run_output(folder_, point.name);
        const WallClock::time_point began = WallClock::now();
        const ChildEnd child = ended(start.words, output);
        JobEnd end{child.exit_code,
                   seconds_since(began),
                   child.processor_s,
                   child.peak_memory,
                   job_here(),
                   newest_checkpoint(run),
                   ""};
        if (end.exit_code == exit_done) {
            fs::remove(output);  // run.log has it
        } else if (signals_.flag() && end.is_unfinished()) {
            end.exit_code = signals_.exit_code();
            note_standstill(point, end);
        } else {
            end.error =
                failed_row(point, end.exit_code, child.signal != 0 ? killed_text(child.signal) : read_file(output))
                    .error;
        }
        return end;
    }

    ChildEnd ended(const std::vector<std::string>& run, const fs::path& output) {
        std::vector<std::string> words = launcher_words(command_.slurm_options);
        std::string program;
        if (!words.empty()) {
            program = program_path(words.front());
            if (program.empty())
                throw InputError("there is no '" + words.front() + "' on this machine, which is to start the ranks",
                                 "Load the module of Open MPI before the command that hands the jobs in.");
            words.insert(words.end(), {fs::read_symlink("/proc/self/exe").string()});
            words.insert(words.end(), run.begin() + 1, run.end());
        } else {
            words = run;
        }
        ChildProcess process(std::move(words), output, program);
        while (!process.end()) {
            // mpirun hands on SIGUSR1, and ends ranks that have not ended a second after SIGTERM.
            if (signals_.flag()) process.stop(SIGUSR1);
            wait_for_any({&process}, look_again_ms);
        }
        return *process.end();
    }

    /// A run that comes to its time limit twice without a newer checkpoint would do so for ever.
    void note_standstill(const study::Point& point, JobEnd& end) const {
        const std::vector<JobEnd> earlier = ends_.ends_of(point.name);
        if (end.exit_code != exit_user_signal || earlier.empty() || earlier.back().exit_code != exit_user_signal ||
            earlier.back().checkpoint != end.checkpoint)
            return;
        end.exit_code = exit_out_of_time;
        end.error = "it came to the time limit of its job twice without a newer checkpoint: give more time";
    }

    const SweepCommand& command_;
    const study::Study& study_;
    study::LeftOut left_out_;
    fs::path folder_;
    SlurmFolder ends_;
    StopSignals signals_;
};

/// An error before its runs were begun is theirs, where their folder is a study's.
void note_error(const SweepCommand& command, const Error& error, int exit_code) {
    const fs::path folder = command.out;
    if (command.out.empty() || !fs::is_regular_file(folder / sweep_file_name)) return;
    JobEnd end;
    end.exit_code = exit_code;
    end.job = job_here();
    end.error = one_line(error);
    for (const std::string& name : command.runs)
        if (is_run_name(name) && contents_of(run_folder(folder, name)).kind != FolderContents::Kind::finished)
            SlurmFolder(folder).add_end(name, end);
}

int do_runs_of_study(const SweepCommand& command) {
    const study::Study study = study::read_study(command.study, command.overrides);
    const study::Points points(study);
    std::vector<study::Point> runs;
    for (const std::string& name : command.runs) runs.push_back(points.at(run_called(name, points)));
    const fs::path folder = output_folder(command.out, study.name);
    join_sweep_folder(folder, {study, points.size(), true, false}, command.typed);
    Element element(command, study, left_out_of(study, points.size()), folder);
    int first_failure = exit_done;
    for (const study::Point& point : runs) {
        const int code = element.run(point);
        if (element.is_stopping() && is_stopped(code)) return code;
        if (first_failure == exit_done) first_failure = code;
    }
    return first_failure;
}

}  // namespace

int do_runs(const SweepCommand& command) {
    try {
        return do_runs_of_study(command);
    } catch (const InputError& error) {
        note_error(command, error, exit_bad_input);
        throw;
    } catch (const Error& error) {
        note_error(command, error, exit_out_of_resource);
        throw;
    }
}

}  // namespace dmp::cli
