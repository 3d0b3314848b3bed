// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cli/sweep/child_process.hpp"

namespace dmp::cli {

/// How a run that RunStarter has started came to its end.
struct RunEnd {
    std::size_t id = 0;
    bool lost = false;  ///< how is not known: the process that starts the runs has ended, and they stop with it
    ChildEnd how;
    std::string problem;  ///< why no process could be made for it; "": one was made
};

/// Starts runs, each in a process of its own that is a copy of a process that waits with all of dmp's libraries loaded.
/// Loading them takes a fifth of a second, which is more than many a short run takes; a copy is made in a few
/// milliseconds. What happens to a run is its own affair, as of any process. The process that waits does nothing but
/// make copies, and has one thread only: what copies of a process lack are its other threads.
class RunStarter {
  public:
    /// `program`: the name that it is called by.
    explicit RunStarter(std::string program);
    /// Stops what still runs, and waits for its end.
    ~RunStarter();
    RunStarter(const RunStarter&) = delete;
    RunStarter& operator=(const RunStarter&) = delete;

    /// `words`: the command line of the run; `output`: a file for what it says. Throws ResourceError where the process
    /// that starts the runs cannot be started.
    void start(std::size_t id, const std::vector<std::string>& words, const std::filesystem::path& output);
    /// Sends SIGTERM to all that run; to each once only.
    void stop_all();
    /// Those that have ended, as soon as there is one or after this time [ms].
    [[nodiscard]] std::vector<RunEnd> ends(int most_ms);
    /// The process of a run; 0: not known (yet).
    [[nodiscard]] pid_t process_of(std::size_t id) const;
    /// How often the process that starts the runs was started.
    [[nodiscard]] std::size_t program_starts() const { return program_starts_; }

  private:
    void start_process();
    void take(const std::vector<std::string>& message, std::vector<RunEnd>& ends);
    /// All that run are lost.
    void take_loss(std::vector<RunEnd>& ends);

    std::string program_;
    int channel_ = -1;  ///< to the process; -1: there is none
    std::unique_ptr<ChildProcess> process_;
    std::map<std::size_t, pid_t> running_;
    std::size_t program_starts_ = 0;
};

}  // namespace dmp::cli
