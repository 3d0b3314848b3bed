// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/confinement_filter.hpp"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace dmp::geometry {

namespace {

#if defined(__x86_64__)
constexpr std::uint32_t filtered_processor = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t filtered_processor = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t filtered_processor = 0;
#endif

constexpr std::uint32_t may = SECCOMP_RET_ALLOW, end_process = SECCOMP_RET_KILL_PROCESS;
constexpr std::uint32_t fail_with(int error) { return SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error); }

/// Reading, memory, threads, time, and facts about this process. Some exist on some processors only.
constexpr auto calls_allowed = std::to_array<int>({
    SYS_read, SYS_pread64, SYS_readv, SYS_write, SYS_writev, SYS_close, SYS_fstat, SYS_newfstatat, SYS_statx, SYS_lseek,
        SYS_fadvise64, SYS_getdents64, SYS_getcwd, SYS_readlinkat, SYS_faccessat, SYS_faccessat2, SYS_dup, SYS_ppoll,
        SYS_mmap, SYS_munmap, SYS_mprotect, SYS_mremap, SYS_madvise, SYS_mincore, SYS_brk, SYS_get_mempolicy,
        SYS_membarrier, SYS_futex, SYS_set_robust_list, SYS_get_robust_list, SYS_rseq, SYS_set_tid_address,
        SYS_sched_yield, SYS_sched_getaffinity, SYS_sched_setaffinity, SYS_rt_sigaction, SYS_rt_sigprocmask,
        SYS_rt_sigreturn, SYS_sigaltstack, SYS_restart_syscall, SYS_clock_gettime, SYS_clock_getres,
        SYS_clock_nanosleep, SYS_nanosleep, SYS_gettimeofday, SYS_times, SYS_getrandom, SYS_getpid, SYS_getppid,
        SYS_gettid, SYS_getuid, SYS_geteuid, SYS_getgid, SYS_getegid, SYS_getcpu, SYS_uname, SYS_sysinfo, SYS_getrusage,
        SYS_exit, SYS_exit_group,
#if defined(__x86_64__)
        SYS_stat, SYS_lstat, SYS_access, SYS_readlink, SYS_poll, SYS_time, SYS_getrlimit, SYS_arch_prctl,
#endif
});

/// Nothing that reads a geometry does these by the way.
constexpr auto calls_that_end = std::to_array<int>({
    SYS_execve, SYS_execveat, SYS_ptrace,
#if defined(__x86_64__)
        SYS_fork, SYS_vfork,
#endif
});

/// Writes instructions; each test falls through where it does not apply.
class Program {
  public:
    void load(std::size_t offset) {
        instructions_.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset)));
    }
    void load_call() { load(offsetof(seccomp_data, nr)); }
    /// The lower half of an argument; flags and numbers fit into it.
    void load_argument(std::size_t number) { load(offsetof(seccomp_data, args) + number * sizeof(std::uint64_t)); }
    void load_upper_half(std::size_t number) {
        load(offsetof(seccomp_data, args) + number * sizeof(std::uint64_t) + sizeof(std::uint32_t));
    }
    void end(std::uint32_t action) { instructions_.push_back(BPF_STMT(BPF_RET | BPF_K, action)); }
    void end_if_equal(std::uint32_t value, std::uint32_t action) {
        instructions_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1));
        end(action);
    }
    void end_unless_equal(std::uint32_t value, std::uint32_t action) {
        instructions_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 1, 0));
        end(action);
    }
    void end_if_any_bit(std::uint32_t bits, std::uint32_t action) {
        instructions_.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, bits, 0, 1));
        end(action);
    }
    void end_if_at_least(std::uint32_t value, std::uint32_t action) {
        instructions_.push_back(BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, value, 0, 1));
        end(action);
    }
    /// What `write` adds holds for this call only, which it must end.
    template <class Write>
    void for_call(int call, Write&& write) {
        const std::size_t test = instructions_.size();
        instructions_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 0));
        write();
        instructions_[test].jf = static_cast<std::uint8_t>(instructions_.size() - test - 1);
    }

    [[nodiscard]] std::vector<sock_filter> instructions() const { return instructions_; }

  private:
    std::vector<sock_filter> instructions_;
};

void allow_opening_for_reading(Program& program, int call, std::size_t flags) {
    constexpr int writes = O_ACCMODE | O_CREAT | O_TRUNC | (O_TMPFILE & ~O_DIRECTORY);
    program.for_call(call, [&] {
        program.load_argument(flags);
        program.end_if_any_bit(writes, fail_with(EACCES));
        program.end(may);
    });
}

}  // namespace

std::vector<sock_filter> confinement_filter() {
    if (filtered_processor == 0) return {};
    Program program;
    program.load(offsetof(seccomp_data, arch));
    program.end_unless_equal(filtered_processor, end_process);
    program.load_call();
#if defined(__x86_64__)
    constexpr std::uint32_t other_pointers = 0x40000000;  // x32: the same calls under other numbers
    program.end_if_at_least(other_pointers, end_process);
    allow_opening_for_reading(program, SYS_open, 1);
#endif
    allow_opening_for_reading(program, SYS_openat, 2);
    program.for_call(SYS_clone, [&] {
        program.load_argument(0);
        program.end_if_any_bit(CLONE_THREAD, may);
        program.end(end_process);
    });
    program.end_if_equal(SYS_clone3, fail_with(ENOSYS));   // its flags cannot be seen: libraries then use clone
    program.end_if_equal(SYS_openat2, fail_with(ENOSYS));  // likewise
    program.end_if_equal(SYS_ioctl, fail_with(ENOTTY));
    program.for_call(SYS_fcntl, [&] {
        program.load_argument(1);
        for (const int command : {F_GETFD, F_SETFD, F_GETFL, F_DUPFD, F_DUPFD_CLOEXEC})
            program.end_if_equal(static_cast<std::uint32_t>(command), may);
        program.end(fail_with(EPERM));
    });
    program.for_call(SYS_prctl, [&] {
        program.load_argument(0);
        program.end_if_equal(PR_SET_NAME, may);
        program.end(fail_with(EPERM));
    });
    program.for_call(SYS_tgkill, [&] {  // abort()
        program.load_argument(0);
        program.end_if_equal(static_cast<std::uint32_t>(getpid()), may);
        program.end(fail_with(EPERM));
    });
    program.for_call(SYS_prlimit64, [&] {  // limits may be asked for
        program.load_argument(2);
        program.end_unless_equal(0, fail_with(EPERM));
        program.load_upper_half(2);
        program.end_unless_equal(0, fail_with(EPERM));
        program.end(may);
    });
    for (const int call : calls_that_end) program.end_if_equal(static_cast<std::uint32_t>(call), end_process);
    for (const int call : calls_allowed) program.end_if_equal(static_cast<std::uint32_t>(call), may);
    program.end(fail_with(EPERM));
    return program.instructions();
}

}  // namespace dmp::geometry
