// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/virtual_display.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <thread>

#include <X11/Xlib.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/allocation.hpp"

namespace dmp::postproc {

namespace {

constexpr int patience_ms = 30'000;  // starting a server may take seconds on a loaded machine

/// A display forwarded from another machine ("localhost:10.0") rarely supports OpenGL 3, and is slow.
bool is_local(const std::string& display) { return display.starts_with(":") || display.starts_with("unix:"); }

bool can_draw(const std::string& display) {
    Display* connection = XOpenDisplay(display.c_str());
    if (connection == nullptr) return false;
    int opcode = 0, event = 0, error = 0;
    const bool has_opengl = XQueryExtension(connection, "GLX", &opcode, &event, &error) == True;
    XCloseDisplay(connection);
    return has_opengl;
}

/// Full path of a program in $PATH; empty if there is none.
std::string find_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::string file = (folder.empty() ? "." : folder) + "/" + name;
        if (::access(file.c_str(), X_OK) == 0) return file;
    }
    return {};
}

/// Replaces this process by the server; only calls that are safe between fork and exec. The server writes its display
/// number to `number_pipe`.
[[noreturn]] void become_server(const char* program, int number_pipe, pid_t parent) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(127);
    setpgid(0, 0);  // Ctrl-C must reach dmp only, which then ends the server itself
    std::signal(SIGXFSZ, SIG_DFL);
    std::signal(SIGPIPE, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    const int nothing = ::open("/dev/null", O_RDWR);
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDERR_FILENO);
    dup2(number_pipe, STDOUT_FILENO);
    close_range(3, ~0U, 0);
    execl(program, program, "-displayfd", "1", "-screen", "0", "640x480x24", "-nolisten", "tcp", "-noreset",
          static_cast<char*>(nullptr));
    _exit(127);
}

/// The line that the server sends when it is ready, its display number; empty if it fails.
std::string read_number(int pipe) {
    std::string text;
    const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(patience_ms);
    while (text.find('\n') == std::string::npos) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(until - std::chrono::steady_clock::now()).count();
        if (left <= 0) return {};
        pollfd waiting{pipe, POLLIN, 0};
        if (poll(&waiting, 1, static_cast<int>(left)) < 0 && errno != EINTR) return {};
        if (waiting.revents == 0) continue;
        std::array<char, 32> buffer{};
        const ssize_t count = ::read(pipe, buffer.data(), buffer.size());
        if (count <= 0) return {};
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return text.substr(0, text.find('\n'));
}

}  // namespace

VirtualDisplay::VirtualDisplay() {
    constexpr std::size_t memory_to_draw = std::size_t{1} << 30U;  // with less the software renderer crashes
    if (!may_allocate(memory_to_draw)) {
        problem_ = "rendering may take 1 GiB of memory, more than the limit of this process leaves (ulimit -v)";
        return;
    }
    if (const char* given = std::getenv("DISPLAY"); given != nullptr && *given != '\0') {
        display_before_ = given;
        if (is_local(*display_before_) && can_draw(*display_before_)) return;
    }
    const std::string program = find_program("Xvfb");
    if (program.empty()) {
        problem_ =
            "there is no display, and Xvfb, which provides a virtual one, is not installed (Debian: apt install xvfb)";
        return;
    }
    start_server(program);
}

void VirtualDisplay::start_server(const std::string& program) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        problem_ = "no virtual display could be started: out of file descriptors";
        return;
    }
    const pid_t parent = getpid();
    server_ = fork();
    if (server_ == 0) become_server(program.c_str(), ends[1], parent);
    ::close(ends[1]);
    const std::string number = server_ > 0 ? read_number(ends[0]) : std::string();
    ::close(ends[0]);
    if (!number.empty() && can_draw(":" + number)) {
        setenv("DISPLAY", (":" + number).c_str(), 1);
        return;
    }
    stop_server();
    problem_ =
        "no virtual display could be started: '" + program +
        "' did not start or does not support OpenGL; test it with xvfb-run -a true, and check that /tmp is writable";
}

void VirtualDisplay::stop_server() {
    if (server_ <= 0) return;
    kill(server_, SIGTERM);
    for (int tries = 0; tries < 200; ++tries) {
        const pid_t ended = waitpid(server_, nullptr, WNOHANG);
        if (ended == server_ || (ended < 0 && errno != EINTR)) {
            server_ = -1;
            return;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    kill(server_, SIGKILL);
    waitpid(server_, nullptr, 0);
    server_ = -1;
}

VirtualDisplay::~VirtualDisplay() {
    if (server_ <= 0) return;
    stop_server();
    if (display_before_)
        setenv("DISPLAY", display_before_->c_str(), 1);
    else
        unsetenv("DISPLAY");
}

}  // namespace dmp::postproc
