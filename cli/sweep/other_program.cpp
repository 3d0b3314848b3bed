// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/other_program.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/errors.hpp"

namespace dmp::cli {

namespace {

/// The reading and the writing end.
struct Pipe {
    Pipe() {
        if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::system_category(), "pipe");
    }
    ~Pipe() {
        close_writing();
        close(ends[0]);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_writing() {
        if (ends[1] >= 0) close(ends[1]);
        ends[1] = -1;
    }

    std::array<int, 2> ends{-1, -1};
};

/// Reads both until nobody writes any more.
void read_all(const std::array<int, 2>& sources, const std::array<std::string*, 2>& texts) {
    std::array<pollfd, 2> open{pollfd{sources[0], POLLIN, 0}, pollfd{sources[1], POLLIN, 0}};
    std::array<char, 4096> buffer{};
    while (open[0].fd >= 0 || open[1].fd >= 0) {
        if (poll(open.data(), open.size(), -1) < 0) continue;  // a signal
        for (std::size_t k = 0; k < open.size(); ++k) {
            if (open[k].fd < 0 || open[k].revents == 0) continue;
            const ssize_t count = read(open[k].fd, buffer.data(), buffer.size());
            if (count > 0)
                texts[k]->append(buffer.data(), static_cast<std::size_t>(count));
            else if (count == 0 || errno != EINTR)
                open[k].fd = -1;
        }
    }
}

}  // namespace

std::string program_path(const std::string& name) {
    if (name.find('/') != std::string::npos) return access(name.c_str(), X_OK) == 0 ? name : "";
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        const std::filesystem::path file = std::filesystem::path(folder.empty() ? "." : folder) / name;
        std::error_code none;
        if (std::filesystem::is_regular_file(file, none) && access(file.c_str(), X_OK) == 0) return file.string();
    }
    return "";
}

ProgramOutput output_of(std::vector<std::string> words) {
    Pipe output, errors;
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files, output.ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, errors.ends[1], STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::signal(SIGCHLD, SIG_DFL);  // where it is ignored, the end of a child cannot be asked for
    pid_t pid = 0;
    const int error = posix_spawnp(&pid, arguments[0], &files, &attributes, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    if (error != 0)
        throw ResourceError("'" + words[0] + "' cannot be started: " + std::system_category().message(error),
                            "Make room (memory, processes: 'ulimit -u'), and check that it is installed.");
    output.close_writing();
    errors.close_writing();
    ProgramOutput said;
    read_all({output.ends[0], errors.ends[0]}, {&said.output, &said.errors});
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    said.exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    return said;
}

}  // namespace dmp::cli
