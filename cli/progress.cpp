// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress.hpp"

#include <cmath>
#include <cstdio>
#include <limits>

#include <fmt/format.h>

#include "cli/terminal.hpp"
#include "cli/text.hpp"

namespace dmp::cli {

namespace {

constexpr double memory_of_rate = 15;  ///< [s]

}  // namespace

void TimeLeft::update(double wall, double time, double until) {
    const double elapsed = wall - wall_;
    if (elapsed > 0) {
        const double keep = std::exp(-elapsed / memory_of_rate);
        rate_ = keep * rate_ + (1 - keep) * (time - time_) / elapsed;
        weight_ = keep * weight_ + (1 - keep);
    }
    wall_ = wall;
    time_ = time;
    until_ = until;
}

double TimeLeft::seconds() const {
    if (!(rate_ > 0)) return std::numeric_limits<double>::infinity();
    return (until_ - time_) * weight_ / rate_;
}

std::string progress_text(const RunProgress& progress, double seconds_left) {
    const double part = progress.until > 0 ? progress.time / progress.until : 0;
    std::string text =
        fmt::format("{:3.0f} %  {:.4g} of {:.4g} s  {}  {:.3g} m/s at most  {}", std::floor(100 * part), progress.time,
                    progress.until, count_text(static_cast<std::size_t>(progress.step), "step"), progress.largest_speed,
                    count_text(static_cast<std::size_t>(progress.frames), "frame"));
    if (std::isfinite(seconds_left)) text += "  " + duration_text(seconds_left) + " left";
    return text;
}

ProgressLine::ProgressLine() : on_(is_terminal(Stream::error)), start_(std::chrono::steady_clock::now()) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::show(const RunProgress& progress) {
    if (!on_) return;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start_;
    left_.update(wall.count(), progress.time, progress.until);
    show(progress_text(progress, left_.seconds()));
}

void ProgressLine::show(const std::string& text) {
    if (!on_) return;
    const auto width = static_cast<std::size_t>(terminal_width(Stream::error)) - 1;
    erase_error_line();
    print_error(text.substr(0, width));
    shown_ = true;
}

void ProgressLine::clear() {
    if (!shown_) return;
    erase_error_line();
    shown_ = false;
}

}  // namespace dmp::cli
