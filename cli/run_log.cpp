// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_log.hpp"

#include <chrono>
#include <cmath>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "base/safe_file.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/version.hpp"

namespace dmp::cli {

namespace {

std::string now_text() {
    const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(now));
}

}  // namespace

std::string log_text(const RunProgress& progress, double seconds_left) {
    std::string text = fmt::format("step {}, t = {:.6g} of {:.6g} s ({:.0f} %), dt {:.4g} s, at most {:.4g} m/s",
                                   progress.step, progress.time, progress.until,
                                   std::floor(progress.until > 0 ? 100 * progress.time / progress.until : 0),
                                   progress.dt, progress.largest_speed);
    if (progress.density_high > 0)
        text +=
            ", density " + percent_text(progress.density_low - 1) + " to " + percent_text(progress.density_high - 1);
    text += ", " + count_text(static_cast<std::size_t>(progress.frames), "frame");
    if (std::isfinite(seconds_left)) text += ", " + duration_text(seconds_left) + " left";
    return text;
}

RunLog::RunLog(const std::filesystem::path& folder, const std::string& command_line, const char* name)
    : file_(folder / name) {
    add(now_text() + "  dmp " + build_facts().version + "\n" + command_line + "\n\n");
}

void RunLog::add(const std::string& text) {
    if (!std::filesystem::exists(file_)) write_file(file_, "");
    append_to_file(file_, printable(without_marks(text), false));
}

void RunLog::say(const std::string& text) {
    print(text);
    flush_output();
    add(text);
}

void RunLog::warn(const std::string& text) {
    std::string lines;
    for (const char c : text) lines += c == '\n' ? std::string("\n  ") : std::string(1, c);
    print_error(Style(Stream::error).warning("warning") + lines + "\n");
    add("warning" + lines + "\n");
}

std::string RunLog::progress(const RunProgress& progress, double wall) {
    left_.update(wall, progress.time, progress.until);
    if (wall < next_) return "";
    next_ = seconds_between_lines * (std::floor(wall / seconds_between_lines) + 1);
    const std::string line = log_text(progress, left_.seconds());
    add(now_text() + "  " + line + "\n");
    return line;
}

}  // namespace dmp::cli
