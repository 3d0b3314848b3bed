// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/terminal.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <sys/ioctl.h>
#include <unistd.h>

#include "base/errors.hpp"
#include "cli/uses.hpp"
#include "solver/parallel/ranks.hpp"

namespace dmp::cli {

namespace {

/// Whether stdout is one when dmp starts: of one that is gone nothing can be asked.
const bool output_was_terminal = isatty(STDOUT_FILENO) != 0;

int descriptor(Stream stream) { return stream == Stream::output ? STDOUT_FILENO : STDERR_FILENO; }

/// After a failed write. EIO is what a terminal gives that is gone.
void output_is_lost() {
    if (errno == EPIPE || (errno == EIO && output_was_terminal)) {
        std::clearerr(stdout);
        return;
    }
    throw ResourceError(std::string("cannot write to the standard output: ") + std::strerror(errno),
                        "Is it a file on a full disk? Make room, then try again.");
}

}  // namespace

/// mpirun reads its processes through terminals of its own, wherever it writes to: a job's log in the end.
bool is_terminal(Stream stream) { return !MpiSession::started_by_mpirun() && isatty(descriptor(stream)) != 0; }

bool colours_on(Stream stream) {
    const char* no_colour = std::getenv("NO_COLOR");
    const char* terminal = std::getenv("TERM");
    const bool wanted = no_colour == nullptr || *no_colour == '\0';
    return wanted && is_terminal(stream) && terminal != nullptr && std::string_view(terminal) != "dumb";
}

int terminal_width(Stream stream) {
    winsize size{};
    if (ioctl(descriptor(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
    return 80;
}

void print(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) output_is_lost();
}

void flush_output() {
    if (std::fflush(stdout) != 0) output_is_lost();
}

void print_error(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

std::string Style::marked(std::string_view mark, std::string_view text) const {
    if (!colour_) return std::string(text);
    return std::string(mark).append(text).append("\033[0m");
}

}  // namespace dmp::cli
