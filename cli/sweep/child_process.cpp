// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/child_process.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/errors.hpp"
#include "base/safe_file.hpp"

namespace dmp::cli {

namespace {

constexpr const char* own_program = "/proc/self/exe";
constexpr const char* no_file = "/dev/null";
constexpr int not_started = 127;  ///< exit code, as shells have it

std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// Without what tells a process that mpirun has started it: the new one is on its own.
std::vector<char*> environment_of_its_own() {
    std::vector<char*> kept;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string_view text = *variable;
        if (!text.starts_with("OMPI_COMM_WORLD_SIZE=") && !text.starts_with("PMI_SIZE=")) kept.push_back(*variable);
    }
    kept.push_back(nullptr);
    return kept;
}

/// All signals wait while it lives.
class BlockedSignals {
  public:
    BlockedSignals() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    BlockedSignals(const BlockedSignals&) = delete;
    BlockedSignals& operator=(const BlockedSignals&) = delete;

    [[nodiscard]] const sigset_t& before() const { return before_; }

  private:
    sigset_t before_{};
};

/// The handlers of the process that was copied remove its lock: none of them may run here.
void drop_handlers() {
    for (const int number : {SIGINT, SIGTERM, SIGUSR1, SIGHUP, SIGPIPE}) {
        struct sigaction action {};
        if (sigaction(number, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
        action = {};
        action.sa_handler = SIG_DFL;
        sigaction(number, &action, nullptr);
    }
}

/// To the errors. May be called between fork and exec.
void say(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
        if (written < 0) return;  // nobody is left to be told
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

/// What a new process does first. Between fork and exec only functions may be called that are safe in a signal handler.
/// Signals are blocked.
void settle(int input, int output, pid_t parent, const sigset_t& mask) {
    drop_handlers();
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(not_started);  // it has ended before the line above
    if (dup2(input, STDIN_FILENO) < 0 || dup2(output, STDOUT_FILENO) < 0 || dup2(output, STDERR_FILENO) < 0)
        _exit(not_started);
    pthread_sigmask(SIG_SETMASK, &mask, nullptr);  // a signal that came meanwhile ends it here
}

/// An open file, closed with this object.
class OpenFile {
  public:
    OpenFile(const std::filesystem::path& path, int flags) : descriptor_(open(path.c_str(), flags | O_CLOEXEC)) {
        if (descriptor_ < 0) throw_write_error(path, std::system_category().message(errno));
    }
    ~OpenFile() { close(descriptor_); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    [[nodiscard]] int descriptor() const { return descriptor_; }

  private:
    int descriptor_;
};

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

int descriptor_of(pid_t pid) { return static_cast<int>(syscall(SYS_pidfd_open, pid, 0)); }

}  // namespace

struct ChildProcess::Start {
    int input, output;
    std::function<void()> become;  ///< called in the new process, does not return
};

ChildProcess::ChildProcess(std::vector<std::string> words, const std::filesystem::path& output,
                           const std::string& program) {
    write_file(output, "");
    const OpenFile file(output, O_WRONLY | O_APPEND), nothing(no_file, O_RDONLY);
    start_program(std::move(words), nothing.descriptor(), file.descriptor(), program.empty() ? own_program : program);
}

ChildProcess::ChildProcess(std::vector<std::string> words, int input) {
    const OpenFile nothing(no_file, O_WRONLY);
    start_program(std::move(words), input, nothing.descriptor(), own_program);
}

ChildProcess::ChildProcess(const std::function<int()>& action, const std::filesystem::path& output) {
    write_file(output, "");
    const OpenFile file(output, O_WRONLY | O_APPEND), nothing(no_file, O_RDONLY);
    start({nothing.descriptor(), file.descriptor(), [&] {
               close_range(STDERR_FILENO + 1, ~0U, 0);
               std::exit(action());
           }});
}

void ChildProcess::start_program(std::vector<std::string> words, int input, int output, const std::string& program) {
    std::vector<char*> arguments = pointers_to(words), environment = environment_of_its_own();
    const std::string failed = "error: '" + program + "' cannot be started: ";
    start({input, output, [&] {
               execve(program.c_str(), arguments.data(), environment.data());
               const char* reason = strerrordesc_np(errno);
               say(failed);
               say(reason != nullptr ? reason : "unknown error");
               say("\n");
               _exit(not_started);
           }});
}

void ChildProcess::start(const Start& how) {
    const pid_t parent = getpid();
    // Where it is ignored, which is inherited, the system keeps no child's end to ask for.
    std::signal(SIGCHLD, SIG_DFL);
    int error = 0;
    {
        const BlockedSignals blocked;
        pid_ = fork();
        error = errno;
        if (pid_ == 0) {
            settle(how.input, how.output, parent, blocked.before());
            how.become();
        }
    }
    if (pid_ < 0)
        throw ResourceError("no process can be started: " + std::system_category().message(error),
                            "Make room (memory, processes: 'ulimit -u'), or give fewer --jobs.");
    descriptor_ = descriptor_of(pid_);
}

ChildProcess::~ChildProcess() {
    if (!end_) {
        stop();
        while (!end()) wait_for_any({this}, 1000);
    }
    if (descriptor_ >= 0) close(descriptor_);
}

std::optional<ChildEnd> ChildProcess::end() {
    if (end_) return end_;
    int status = 0;
    rusage used{};
    const pid_t ended = wait4(pid_, &status, WNOHANG, &used);
    if (ended == 0 || (ended < 0 && errno == EINTR)) return {};
    ChildEnd end;
    if (ended < 0) {  // somebody else has asked for its end: how it ended is not known
        end.exit_code = not_started;
        end_ = end;
        return end_;
    }
    end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    end.exit_code = end.signal != 0 ? 128 + end.signal : WEXITSTATUS(status);
    end.processor_s = seconds(used.ru_utime) + seconds(used.ru_stime);
    end.peak_memory = 1024.0 * static_cast<double>(used.ru_maxrss);
    end_ = end;
    return end_;
}

void ChildProcess::stop(int signal) {
    if (end_ || stop_sent_) return;
    stop_sent_ = true;
    kill(pid_, signal);
}

void wait_for_any(const std::vector<const ChildProcess*>& children, int most_ms, int input) {
    constexpr int ask_again_ms = 20;
    std::vector<pollfd> descriptors;
    if (input >= 0) descriptors.push_back({input, POLLIN, 0});
    for (const ChildProcess* child : children) {
        descriptors.push_back({child->descriptor_, POLLIN, 0});
        if (child->descriptor_ < 0)  // it has to be asked
            most_ms = most_ms < 0 ? ask_again_ms : std::min(most_ms, ask_again_ms);
    }
    poll(descriptors.data(), descriptors.size(), most_ms);
}

}  // namespace dmp::cli
