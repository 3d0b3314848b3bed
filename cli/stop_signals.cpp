// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/stop_signals.hpp"

#include <csignal>

#include "base/folder_lock.hpp"
#include "cli/exit_codes.hpp"

namespace dmp::cli {

namespace {

std::atomic<bool> stop_wanted = false;
std::atomic<int> signal_seen = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler may touch lock-free atomics only");

extern "C" void end_without_lock(int number) {
    remove_held_lock();
    std::signal(number, SIG_DFL);
    std::raise(number);
}

extern "C" void note_signal(int number) {
    signal_seen = number;
    stop_wanted = true;
    std::signal(number, end_without_lock);
}

}  // namespace

void remove_lock_on_signals() {
    for (const int number : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(number, end_without_lock) == SIG_IGN) std::signal(number, SIG_IGN);
}

StopSignals::StopSignals() {
    stop_wanted = false;
    signal_seen = 0;
    std::signal(SIGINT, note_signal);
    std::signal(SIGTERM, note_signal);
}

StopSignals::~StopSignals() {
    std::signal(SIGINT, end_without_lock);
    std::signal(SIGTERM, end_without_lock);
}

const std::atomic<bool>& StopSignals::flag() const { return stop_wanted; }

int StopSignals::exit_code() const { return signal_seen == SIGTERM ? exit_terminated : exit_interrupted; }

}  // namespace dmp::cli
