// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/process_identity.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>

#include <unistd.h>

namespace dmp {

namespace {

std::string host_name() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// A reboot changes the first part, a container the second.
std::string machine() {
    std::string boot;
    std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), boot);
    if (boot.empty()) return "";
    std::array<char, 64> numbers{};
    const ssize_t size = ::readlink("/proc/self/ns/pid", numbers.data(), numbers.size());
    return size > 0 ? boot + " " + std::string(numbers.data(), static_cast<std::size_t>(size)) : boot;
}

struct Facts {
    char state = ' ';
    long long started = 0;
};

/// proc(5): the name in parentheses may hold anything; state and start time are the 1st and 20th value after it.
std::optional<Facts> facts_of(long pid) {
    std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto name_end = text.rfind(')');
    if (name_end == std::string::npos) return {};
    std::istringstream values(text.substr(name_end + 1));
    Facts facts;
    values >> facts.state;
    std::string skipped;
    for (int value = 2; value < 20; ++value) values >> skipped;
    if (!(values >> facts.started)) return {};
    return facts;
}

}  // namespace

ProcessIdentity this_process() {
    const long pid = ::getpid();
    const auto facts = facts_of(pid);
    return {host_name(), machine(), pid, facts ? facts->started : 0};
}

ProcessState state_of(const ProcessIdentity& process) {
    if (process.machine.empty() || process.machine != machine()) return ProcessState::unknown;
    if (const auto facts = facts_of(process.pid)) {
        // One that was killed stays as a zombie until its parent asks for its end.
        const bool gone = facts->state == 'Z' || facts->state == 'X' || facts->started != process.started;
        return gone ? ProcessState::ended : ProcessState::running;
    }
    const bool none = ::kill(static_cast<pid_t>(process.pid), 0) != 0 && errno == ESRCH;
    return none ? ProcessState::ended : ProcessState::unknown;
}

}  // namespace dmp
