// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/confinement.hpp"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>

#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "geometry/confinement_filter.hpp"

namespace dmp::geometry {

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

// Landlock as the kernel has it; the headers of Debian 12 know its first versions only.
constexpr long create_ruleset = 444, add_rule = 445, restrict_self = 446;
constexpr unsigned ask_version = 1, beneath_path = 1;

struct RulesetAttributes {
    std::uint64_t files, network, scope;
};
struct __attribute__((packed)) PathRule {
    std::uint64_t allowed;
    std::int32_t parent;
};

/// All that a version can forbid.
RulesetAttributes everything(int version) {
    const auto bits = [](unsigned count) { return (std::uint64_t{1} << count) - 1; };
    return {.files = version >= 5   ? bits(16)
                     : version >= 3 ? bits(15)
                     : version == 2 ? bits(14)
                                    : bits(13),
            .network = version >= 4 ? bits(2) : 0,  // binding and connecting TCP ports
            .scope = version >= 6 ? bits(2) : 0};   // abstract sockets and signals of others
}

std::size_t size_of_attributes(int version) {
    const std::size_t fields = version >= 6 ? 3 : version >= 4 ? 2 : 1;
    return fields * sizeof(std::uint64_t);
}

int landlock_version() {
    const long version = syscall(create_ruleset, nullptr, 0, ask_version);
    return version > 0 ? static_cast<int>(version) : 0;
}

bool confine_files(int readable) {
    const int version = landlock_version();
    if (version == 0) return false;
    const RulesetAttributes attributes = everything(version);
    const int rules = static_cast<int>(syscall(create_ruleset, &attributes, size_of_attributes(version), 0));
    if (rules < 0) return false;
    constexpr std::uint64_t read_file = 1U << 2U;
    const PathRule rule{.allowed = read_file, .parent = readable};
    const bool added = readable < 0 || syscall(add_rule, rules, beneath_path, &rule, 0) == 0;
    const bool done = added && syscall(restrict_self, rules, 0) == 0;
    ::close(rules);
    return done;
}

bool confine_system_calls() {
    std::vector<sock_filter> filter = confinement_filter();
    if (filter.empty()) return false;
    const sock_fprog program{.len = static_cast<unsigned short>(filter.size()), .filter = filter.data()};
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

/// Sets a limit, never above what it may be.
void limit(__rlimit_resource_t what, rlim_t value, bool for_good) {
    rlimit now{};
    if (getrlimit(what, &now) != 0) return;
    now.rlim_cur = std::min(value, now.rlim_max);
    if (for_good) now.rlim_max = now.rlim_cur;
    setrlimit(what, &now);
}

}  // namespace

Confinement confinement_offered() {
    if (sanitized) return {};
    // A null pointer instead of a filter: EFAULT from a kernel that knows filters, EINVAL from others.
    const bool filters =
        !confinement_filter().empty() && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, nullptr) != 0 && errno == EFAULT;
    return {.system_calls = filters, .files = landlock_version()};
}

void confine(int readable) {
    limit(RLIMIT_CORE, 0, true);
    limit(RLIMIT_FSIZE, 0, true);
    limit(RLIMIT_NOFILE, 256, true);
    limit(RLIMIT_STACK, rlim_t{16} << 20U, false);  // gmsh asks for it, which it could not later
    if (sanitized) return;
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return;
    confine_files(readable);
    if (!confine_system_calls()) limit(RLIMIT_NPROC, 0, true);
}

}  // namespace dmp::geometry
