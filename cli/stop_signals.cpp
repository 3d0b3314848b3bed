// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/stop_signals.hpp"

#include <algorithm>
#include <array>
#include <csignal>

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
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler may touch lock-free atomics only");

extern "C" void end_without_lock(int number) {
    remove_held_lock();
    std::signal(number, SIG_DFL);
    std::raise(number);
}

extern "C" void note_signal(int number) {
    if (signal_seen == 0) signal_seen = number;
    stop_wanted = true;
    std::signal(number, number == SIGINT || number == SIGTERM ? end_without_lock : SIG_IGN);
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
