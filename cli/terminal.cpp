// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/terminal.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>
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

constexpr std::string_view strong_mark = "\033[1m", faint_mark = "\033[2m", good_mark = "\033[32m",
                           warning_mark = "\033[33m", error_mark = "\033[1;31m", end_mark = "\033[0m";

/// The mark of Style that the text begins with; empty where it begins with none.
std::string_view mark_at(std::string_view text) {
    for (const std::string_view mark : {strong_mark, faint_mark, good_mark, warning_mark, error_mark, end_mark})
        if (text.starts_with(mark)) return mark;
    return {};
}

/// Bytes of the character that the text begins with, if a terminal shows it as such; 0 for control characters and for
/// what is no UTF-8.
std::size_t shown_bytes(std::string_view text) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    const unsigned first = byte(0);
    if (first < 0x80) return (first >= 0x20 && first != 0x7f) || first == '\n' || first == '\t' ? 1 : 0;
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
    for (std::size_t k = 1; k < length; ++k)
        if ((byte(k) & 0xc0U) != 0x80U) return 0;
    const bool of_second_set = first == 0xc2 && byte(1) < 0xa0;  // U+0080 to U+009F, control characters too
    return of_second_set ? 0 : length;
}

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

std::string printable(std::string_view text, bool marked) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        std::size_t taken = shown_bytes(text);
        if (taken == 0 && marked) taken = mark_at(text).size();
        result += taken > 0 ? std::string(text.substr(0, taken))
                            : fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
        text.remove_prefix(std::max<std::size_t>(taken, 1));
    }
    return result;
}

std::string without_marks(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t mark = mark_at(text).size();
        if (mark == 0) result += text.front();
        text.remove_prefix(std::max<std::size_t>(mark, 1));
    }
    return result;
}

void print(std::string_view text) {
    const std::string shown = printable(text, colours_on(Stream::output));
    if (std::fwrite(shown.data(), 1, shown.size(), stdout) != shown.size()) output_is_lost();
}

void flush_output() {
    if (std::fflush(stdout) != 0) output_is_lost();
}

void print_error(std::string_view text) {
    const std::string shown = printable(text, colours_on(Stream::error));
    std::fwrite(shown.data(), 1, shown.size(), stderr);
    std::fflush(stderr);
}

void erase_error_line() {
    std::fputs("\r\033[K", stderr);  // not printable()
    std::fflush(stderr);
}

std::string Style::strong(std::string_view text) const { return marked(strong_mark, text); }
std::string Style::faint(std::string_view text) const { return marked(faint_mark, text); }
std::string Style::good(std::string_view text) const { return marked(good_mark, text); }
std::string Style::warning(std::string_view text) const { return marked(warning_mark, text); }
std::string Style::error(std::string_view text) const { return marked(error_mark, text); }

std::string Style::marked(std::string_view mark, std::string_view text) const {
    if (!colour_) return std::string(text);
    return std::string(mark).append(text).append(end_mark);
}

}  // namespace dmp::cli
