// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <filesystem>
#include <functional>
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

/// A process of its own that a Ctrl-C at the terminal does not reach. It gets SIGTERM when this process ends, in
/// whatever way. All are to be made by the main thread: the process is told when the thread ends that has started it.
class ChildProcess {
  public:
    /// This program, started once more: its output goes to a file, it reads nothing. `words`: the name it is called by,
    /// and its arguments. `program`: path of another one to start instead; "": this one. Throws ResourceError when no
    /// process can be made.
    ChildProcess(std::vector<std::string> words, const std::filesystem::path& output, const std::string& program = "");
    /// The same, reading from a file that is open here, and saying nothing.
    ChildProcess(std::vector<std::string> words, int input);
    /// A copy of this process, which must have one thread only: it does `action` and ends with what that returns. It
    /// has none of the files that are open here; its output goes to a file, it reads nothing. Throws ResourceError
    /// likewise.
    ChildProcess(const std::function<int()>& action, const std::filesystem::path& output);
    /// Asks it to stop, and waits for its end.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    [[nodiscard]] pid_t pid() const { return pid_; }
    /// None while it runs.
    [[nodiscard]] std::optional<ChildEnd> end();
    /// Sends it a signal that asks it to stop; once only, as a second one would end a run before it has written its
    /// checkpoint.
    void stop(int signal = SIGTERM);

  private:
    friend void wait_for_any(const std::vector<const ChildProcess*>& children, int most_ms, int input);

    struct Start;
    void start_program(std::vector<std::string> words, int input, int output, const std::string& program);
    void start(const Start& how);

    pid_t pid_ = -1;
    int descriptor_ = -1;  ///< of the process, which can be read when it has ended; -1: the system has none
    bool stop_sent_ = false;
    std::optional<ChildEnd> end_;
};

/// Returns when one of them has ended, there is something to read from the file `input` (-1: none), a signal has come,
/// or after this time at the latest [ms]; -1: however long it takes.
void wait_for_any(const std::vector<const ChildProcess*>& children, int most_ms, int input = -1);

}  // namespace dmp::cli
