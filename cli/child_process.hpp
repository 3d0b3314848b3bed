// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace dmp::cli {

/// How a process ended.
struct ChildEnd {
    int exit_code = 0;       ///< 128 and the signal's number where a signal ended it; 127: not started, or not known
    int signal = 0;          ///< 0: it ended by itself
    double processor_s = 0;  ///< of all its threads [s]
    double peak_memory = 0;  ///< [bytes]
};

/// This program, started once more in a process of its own: its output goes to a file, it reads nothing, and a Ctrl-C
/// at the terminal does not reach it. It gets SIGTERM when this process ends, in whatever way.
class ChildProcess {
  public:
    /// `words`: the name it is called by, and its arguments. To be called by the main thread: the process is told when
    /// the thread ends that has started it. Throws ResourceError when no process can be made.
    /// `program`: path of another one to start instead; "": this one.
    ChildProcess(std::vector<std::string> words, const std::filesystem::path& output, const std::string& program = "");
    /// Asks it to stop, and waits for its end.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// None while it runs.
    [[nodiscard]] std::optional<ChildEnd> end();
    /// Sends it a signal that asks it to stop; once only, as a second one would end a run before it has written its
    /// checkpoint.
    void stop(int signal = SIGTERM);

  private:
    friend void wait_for_any(const std::vector<const ChildProcess*>& children, int most_ms);

    pid_t pid_ = -1;
    int descriptor_ = -1;  ///< of the process, which can be read when it has ended; -1: the system has none
    bool stop_sent_ = false;
    std::optional<ChildEnd> end_;
};

/// Returns when one of them has ended, a signal has come, or after this time at the latest [ms].
void wait_for_any(const std::vector<const ChildProcess*>& children, int most_ms);

}  // namespace dmp::cli
