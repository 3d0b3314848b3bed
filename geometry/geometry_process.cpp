// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/geometry_process.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <new>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/shell_word.hpp"
#include "geometry/confinement.hpp"
#include "geometry/geometry_bytes.hpp"
#include "geometry/geometry_file.hpp"
#include "geometry/geometry_source.hpp"
#include "geometry/number_text.hpp"
#include "geometry/read_with_gmsh.hpp"
#include "geometry/select_faces.hpp"
#include "geometry/triangle_file.hpp"

namespace dmp::geometry {

namespace {

constexpr int answer_descriptor = 3;
/// The first byte of an answer.
constexpr char is_geometry = 'G', is_input_error = 'I', is_resource_error = 'R';
/// Before it, any number of times: this byte, what the child does now, and a zero byte.
constexpr char is_stage = 'S';
constexpr std::size_t most_of_stages = 4096;

[[noreturn]] void cannot_start(const std::string& step) {
    throw ResourceError("the process that reads geometries cannot be started: " + step + ": " + std::strerror(errno),
                        "Free memory or processes, and try again.");
}

/// An open file, closed with this object.
class Descriptor {
  public:
    /// Takes an open file over, moved out of the way of those that the child is to find at fixed numbers.
    explicit Descriptor(int open) {
        if (open < 0) cannot_start("files");
        number_ = fcntl(open, F_DUPFD_CLOEXEC, 10);
        ::close(open);
        if (number_ < 0) cannot_start("files");
    }
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    [[nodiscard]] int number() const { return number_; }
    void close() {
        if (number_ >= 0) ::close(number_);
        number_ = -1;
    }

  private:
    int number_ = -1;
};

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

/// A file in memory, as a pipe would end this process when the child has gone before it has read.
int file_with(const std::string& bytes) {
    const int file = memfd_create("dmp_drawing_request", MFD_CLOEXEC);
    if (file < 0 || !write_all(file, bytes) || lseek(file, 0, SEEK_SET) != 0) cannot_start("the request");
    return file;
}

/// A running child, which is ended and collected with this object.
class Child {
  public:
    Child(const std::vector<std::string>& command, int request, int answer) {
        std::vector<std::string> words = command;
        std::vector<char*> argv;
        for (std::string& word : words) argv.push_back(word.data());
        argv.push_back(nullptr);
        posix_spawn_file_actions_t files;
        if (posix_spawn_file_actions_init(&files) != 0) cannot_start("files");
        posix_spawn_file_actions_adddup2(&files, request, STDIN_FILENO);
        posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&files, answer, answer_descriptor);
        const int error = posix_spawn(&id_, argv[0], &files, nullptr, argv.data(), environ);
        posix_spawn_file_actions_destroy(&files);
        if (error != 0) {
            id_ = -1;
            errno = error;
            cannot_start(command.front());
        }
    }
    ~Child() {
        if (id_ < 0) return;
        kill(id_, SIGKILL);
        collect();
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Waits for its end and says how it ended, as waitpid does.
    int collect() {
        int status = 0;
        while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
        }
        id_ = -1;
        return status;
    }

  private:
    pid_t id_ = -1;
};

/// What a child said until it closed the pipe, or the first byte too many.
struct Answer {
    std::string stage = "it was starting";  ///< the last that it said
    std::string bytes;                      ///< the rest
    bool in_time = true;
};

Answer without_stages(std::string bytes, bool in_time) {
    Answer answer{.bytes = std::move(bytes), .in_time = in_time};
    std::size_t begin = 0;
    while (begin < answer.bytes.size() && answer.bytes[begin] == is_stage) {
        const std::size_t end = answer.bytes.find('\0', begin);
        if (end == std::string::npos) break;
        answer.stage = answer.bytes.substr(begin + 1, end - begin - 1);
        begin = end + 1;
    }
    answer.bytes.erase(0, begin);
    return answer;
}

Answer answer_within(int descriptor, const GeometryProcess& child) {
    using Clock = std::chrono::steady_clock;
    const auto span = [](double seconds) {
        return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    };
    const auto begin = Clock::now(), deadline = begin + span(child.seconds);
    auto next_word = begin + span(child.silent_seconds);
    std::string answer;
    std::array<char, 1U << 16U> buffer{};
    for (;;) {
        const auto now = Clock::now();
        if (now >= deadline) return without_stages(std::move(answer), false);
        if (now >= next_word) {
            next_word = now + span(child.silent_seconds);
            if (child.still_reading)
                child.still_reading(std::chrono::duration<double>(now - begin).count(),
                                    without_stages(answer.substr(0, most_of_stages), true).stage);
        }
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(std::min(deadline, next_word) - now).count();
        pollfd waiting{descriptor, POLLIN, 0};
        const int ready = poll(&waiting, 1, static_cast<int>(std::min<long long>(left + 1, 1'000'000)));
        if (ready <= 0) continue;  // a signal came, or it is time for one of the above
        const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return without_stages(std::move(answer), true);
        answer.append(buffer.data(), static_cast<std::size_t>(count));
        if (answer.size() > child.largest_answer) return {.bytes = std::move(answer)};
    }
}

InputError gone_wrong(const GeometryOptions& options, const std::string& what) {
    return {SourceLocation{.file = options.file}, "the geometry cannot be read: " + what,
            "Open it in the program that made it, check it there, and save it again; " +
                quoted_command("gmsh", options.file) + " may tell more."};
}

std::string end_of(int status) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        if (signal == SIGSYS)
            return "it made gmsh start another program, or look into one, and the process that reads it may not";
        return std::string("gmsh crashed on it (") + strsignal(signal) +
               (signal == SIGKILL ? ", perhaps for want of memory)" : ")");
    }
    return "its reader ended with code " + std::to_string(WEXITSTATUS(status)) + " and without a result";
}

Geometry result_of(const GeometryOptions& options, const std::string& answer, int status) {
    const std::string_view content = std::string_view(answer).substr(std::min<std::size_t>(1, answer.size()));
    if (answer.empty() || !WIFEXITED(status) || WEXITSTATUS(status) != 0) throw gone_wrong(options, end_of(status));
    try {
        if (answer[0] == is_geometry) return geometry_of(content);
        const ErrorText error = error_text_of(content);
        if (answer[0] == is_resource_error) throw ResourceError(error.problem, error.what_to_do);
        if (answer[0] == is_input_error) throw InputError(error.location, error.problem, error.what_to_do);
        throw std::runtime_error("an answer of no kind");
    } catch (const Error&) {
        throw;
    } catch (const std::runtime_error&) {
        throw gone_wrong(options, "its reader broke off");
    }
}

void limit_memory() {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
#ifndef __SANITIZE_ADDRESS__  // which takes terabytes of addresses for itself
    const rlim_t all = static_cast<rlim_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
    const rlimit memory{all, all};
    setrlimit(RLIMIT_AS, &memory);
#endif
}

std::string request_from(int descriptor) {
    std::string request;
    std::array<char, 4096> buffer{};
    for (;;) {
        const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return request;
        request.append(buffer.data(), static_cast<std::size_t>(count));
    }
}

void tell_stage(const char* stage) { write_all(answer_descriptor, is_stage + std::string(stage) + '\0'); }

Geometry read_confined(const GeometryOptions& options) {
    check_geometry_file(options);
    const GeometrySource source(options);
    if (options.trust != Trust::full) confine(source.descriptor());
    return read_with_gmsh(options, source, tell_stage);
}

std::string answer_to(const GeometryOptions& options) {
    try {
        return is_geometry + bytes_of(read_confined(options));
    } catch (const InputError& error) {
        return is_input_error + bytes_of(ErrorText{error.where(), error.problem(), error.what_to_do()});
    } catch (const Error& error) {
        return is_resource_error + bytes_of(ErrorText{error.where(), error.problem(), error.what_to_do()});
    } catch (const std::bad_alloc&) {
        ErrorText error;
        error.location.file = options.file;
        error.problem = "the geometry takes more memory than the machine has";
        error.what_to_do = "Check that it is whole, or raise particles.spacing.";
        return is_input_error + bytes_of(error);
    }
}

}  // namespace

Geometry read_geometry_in_process(const GeometryOptions& options, const GeometryProcess& child) {
    check_geometry_file(options);
    if (is_triangle_file(options.file)) return read_geometry(options);
    const Descriptor request(file_with(bytes_of(options)));
    std::array<int, 2> pipe_ends{};
    if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) cannot_start("a pipe");
    const Descriptor read_end(pipe_ends[0]);
    Descriptor write_end(pipe_ends[1]);
    Child process(child.command, request.number(), write_end.number());
    write_end.close();
    const Answer answer = answer_within(read_end.number(), child);
    if (!answer.in_time)
        throw InputError(
            {.file = options.file},
            "the geometry cannot be read: gmsh was not done after " + number_text(child.seconds) + " s, when " +
                answer.stage,
            "Simplify it, if it is no mistake that it takes long; more time is given by --geometry-time on "
            "the command line, such as --geometry-time \"1 h\".");
    if (answer.bytes.size() > child.largest_answer)
        throw gone_wrong(options, "what gmsh made of it takes more than " +
                                      number_text(static_cast<double>(child.largest_answer)) + " bytes");
    Geometry geometry = result_of(options, answer.bytes, process.collect());
    select_faces(geometry, options.selections);
    return geometry;
}

int answer_geometry_request() {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit_memory();
    const GeometryOptions options = geometry_options_from_bytes(request_from(STDIN_FILENO));
    return write_all(answer_descriptor, answer_to(options)) ? 0 : 1;
}

}  // namespace dmp::geometry
