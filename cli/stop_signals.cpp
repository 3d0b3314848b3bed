// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/stop_signals.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>

#include "base/folder_lock.hpp"
#include "cli/exit_codes.hpp"

namespace dmp::cli {

namespace {

struct StopSignal {
    int number;
    const char* name;
    ExitCode code;
    bool ends_at_once;  ///< the second one
};
constexpr std::array signals{
    StopSignal{SIGINT, "Ctrl-C", exit_interrupted, true}, StopSignal{SIGTERM, "SIGTERM", exit_terminated, true},
    StopSignal{SIGUSR1, "SIGUSR1", exit_user_signal, false}, StopSignal{SIGHUP, "SIGHUP", exit_hung_up, false},
    StopSignal{SIGPIPE, "SIGPIPE", exit_no_reader, false}};

std::atomic<bool> stop_wanted = false;
std::atomic<int> signal_seen = 0;
std::atomic<std::int64_t> seen_at_ms = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free &&
                  std::atomic<std::int64_t>::is_always_lock_free,
              "a signal handler may touch lock-free atomics only");

extern "C" void end_without_lock(int number) {
    remove_held_lock();
    std::signal(number, SIG_DFL);
    std::raise(number);
}

/// Wall time that does not run backwards [ms]; may be called in a signal handler.
std::int64_t milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1000 * static_cast<std::int64_t>(now.tv_sec) + now.tv_nsec / 1'000'000;
}

/// A second one ends the process, unless it follows at once: the system sends one for each thread of a parent that dies
/// (PR_SET_PDEATHSIG), and those who start processes may repeat theirs.
extern "C" void note_signal(int number) {
    constexpr std::int64_t at_once_ms = 500;
    const std::int64_t now = milliseconds();
    if (signal_seen == 0) {
        signal_seen = number;
        seen_at_ms = now;
    } else if ((number == SIGINT || number == SIGTERM) && now - seen_at_ms > at_once_ms) {
        end_without_lock(number);
        return;
    }
    stop_wanted = true;
    if (number != SIGINT && number != SIGTERM) std::signal(number, SIG_IGN);
}

using Handler = void (*)(int);

/// For each of the signals that nobody has switched off.
void handle_with(Handler handler) {
    for (const StopSignal& each : signals)
        if (std::signal(each.number, handler) == SIG_IGN && signal_seen != each.number)
            std::signal(each.number, SIG_IGN);
}

const StopSignal* seen() {
    const auto* const found = std::ranges::find(signals, signal_seen.load(), &StopSignal::number);
    return found == signals.end() ? nullptr : found;
}

}  // namespace

void remove_lock_on_signals() { handle_with(end_without_lock); }

StopSignals::StopSignals() {
    stop_wanted = false;
    signal_seen = 0;
    handle_with(note_signal);
}

StopSignals::~StopSignals() { handle_with(end_without_lock); }

const std::atomic<bool>& StopSignals::flag() const { return stop_wanted; }

int StopSignals::exit_code() const { return seen() != nullptr ? seen()->code : exit_interrupted; }

const char* StopSignals::name() const { return seen() != nullptr ? seen()->name : ""; }

}  // namespace dmp::cli
