// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/folder_lock.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>
#include <random>
#include <sstream>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/errors.hpp"
#include "base/safe_file.hpp"

namespace dmp {

namespace fs = std::filesystem;

namespace {

/// Of the files that are there for a moment, followed by a token.
constexpr std::string_view passing_start = ".dmp.lock.";
/// How often a lock that comes and goes is looked at before its holder counts as found.
constexpr int most_tries = 200;

std::string reason(int error) { return std::generic_category().message(error); }

std::string new_token() {
    std::random_device device;
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%08x%08x", device(), device());
    return text.data();
}

std::string time_text() {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm parts{};
    std::array<char, 40> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S UTC", gmtime_r(&now, &parts));
    return text.data();
}

std::string content_for(const std::string& token) {
    const ProcessIdentity process = this_process();
    std::ostringstream text;
    text << "# A running dmp writes into this folder. The file goes when it ends; docs/files.md tells more.\n"
         << "host = " << process.host << "\nmachine = " << process.machine << "\npid = " << process.pid
         << "\nstarted = " << process.started << "\nsince = " << time_text() << "\ntoken = " << token << '\n';
    return text.str();
}

double seconds(const timespec& time) {
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Time of the last change by the clock of the file system; none if the file cannot be looked at. Opening it makes NFS
/// ask its server.
std::optional<double> changed(const fs::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) return {};
    struct stat facts {};
    const bool known = ::fstat(descriptor, &facts) == 0;
    ::close(descriptor);
    if (!known) return {};
    return seconds(facts.st_mtim);
}

LockHolder holder_in(const std::string& text) {
    LockHolder holder;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const auto equals = line.find(" = ");
        if (equals == std::string::npos) continue;
        const std::string key = line.substr(0, equals), value = line.substr(equals + 3);
        if (key == "host") holder.process.host = value;
        if (key == "machine") holder.process.machine = value;
        if (key == "pid") holder.process.pid = std::strtol(value.c_str(), nullptr, 10);
        if (key == "started") holder.process.started = std::strtoll(value.c_str(), nullptr, 10);
        if (key == "since") holder.since = value;
        if (key == "token" && value.find('/') == std::string::npos) holder.token = value;
    }
    return holder;
}

/// Makes a file that is not there; false: it is. Throws ResourceError.
bool create_file(const fs::path& file, const std::string& text) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno == EEXIST) return false;
    if (descriptor < 0) throw_write_error(file, reason(errno));
    const bool written = ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    const int error = written ? 0 : errno;
    if ((::close(descriptor) == 0) && written) return true;
    ::unlink(file.c_str());
    throw_write_error(file, reason(error != 0 ? error : errno));
}

/// A file of this process under a name of its own, which is linked to the names that only one may have.
class OwnFile {
  public:
    OwnFile(const fs::path& folder, const std::string& token)
        : path_(folder / (std::string(passing_start) + token + ".own")), text_(content_for(token)) {
        if (!create_file(path_, text_)) throw_write_error(path_, reason(EEXIST));
    }
    ~OwnFile() { ::unlink(path_.c_str()); }
    OwnFile(const OwnFile&) = delete;
    OwnFile& operator=(const OwnFile&) = delete;

    /// Gives the file a second name that nobody has; false: somebody has it. Throws ResourceError.
    [[nodiscard]] bool link_as(const fs::path& name) const {
        if (::link(path_.c_str(), name.c_str()) == 0) return true;
        const int error = errno;
        // NFS may have done it and lost the answer.
        struct stat facts {
        }, named{};
        if (::stat(path_.c_str(), &facts) == 0 && ::lstat(name.c_str(), &named) == 0 && facts.st_ino == named.st_ino &&
            facts.st_dev == named.st_dev)
            return true;
        if (error == EEXIST) return false;
        const bool has_no_links = error == EPERM || error == EOPNOTSUPP || error == ENOSYS || error == EMLINK;
        if (!has_no_links) throw_write_error(name, reason(error));
        return create_file(name, text_);
    }

    /// The time by the clock of the file system [s].
    [[nodiscard]] double now() const {
        ::utimensat(AT_FDCWD, path_.c_str(), nullptr, 0);
        return changed(path_).value_or(0);
    }

  private:
    fs::path path_;
    std::string text_;
};

/// None if there is no such file.
std::optional<LockHolder> holder_of(const fs::path& file, const OwnFile& own) {
    const auto last = changed(file);
    if (!last) {
        if (std::error_code failed; !fs::exists(fs::symlink_status(file, failed))) return {};
        return LockHolder{};  // there, and not readable: somebody's
    }
    LockHolder holder;
    try {
        holder = holder_in(read_file(file));
    } catch (const InputError&) {  // gone between the two, or not readable
    }
    holder.silent_s = own.now() - *last;
    return holder;
}

bool is_stale(const LockHolder& holder) {
    const ProcessState state = holder.process.pid > 0 ? state_of(holder.process) : ProcessState::unknown;
    if (state == ProcessState::unknown) return holder.silent_s > FolderLock::silence_limit_s;
    return state == ProcessState::ended;
}

/// Signals that end the process wait until this goes: between a lock's file and the note of it for the signal handler
/// none may come.
class SignalsWait {
  public:
    SignalsWait() {
        sigset_t ending;
        sigemptyset(&ending);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ending, signal);
        pthread_sigmask(SIG_BLOCK, &ending, &before_);
    }
    ~SignalsWait() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsWait(const SignalsWait&) = delete;
    SignalsWait& operator=(const SignalsWait&) = delete;

  private:
    sigset_t before_{};
};

void wait_a_moment() { std::this_thread::sleep_for(std::chrono::milliseconds(10)); }

/// Gives `own` the name; returns who has it instead, none if `own` does. A stale file in its place is removed, and its
/// holder put into `taken_from`.
std::optional<LockHolder> claim(const fs::path& name, const OwnFile& own, std::optional<LockHolder>& taken_from) {
    LockHolder seen;
    for (int tries = 0; tries < most_tries; ++tries) {
        if (own.link_as(name)) return {};
        const auto holder = holder_of(name, own);
        if (!holder) continue;
        seen = *holder;
        if (!is_stale(seen)) return seen;
        const fs::path right_to_remove =
            name.parent_path() / (std::string(passing_start) + (seen.token.empty() ? "unreadable" : seen.token));
        std::optional<LockHolder> before;
        if (claim(right_to_remove, own, before)) {
            wait_a_moment();
            continue;
        }
        // Only now nobody else can have put another lock in its place.
        const auto still = holder_of(name, own);
        if (still && still->token == seen.token && is_stale(*still) && ::unlink(name.c_str()) == 0) taken_from = seen;
        ::unlink(right_to_remove.c_str());
    }
    return seen;
}

std::array<char, 4096> held_file{};
std::atomic<bool> holds_file = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch lock-free atomics only");

void remember_held(const fs::path& file) {
    const std::string name = fs::absolute(file).string();
    if (holds_file || name.size() >= held_file.size()) return;
    std::memcpy(held_file.data(), name.c_str(), name.size() + 1);
    holds_file = true;
}

void forget_held(const fs::path& file) {
    if (holds_file && fs::absolute(file).string() == held_file.data()) holds_file = false;
}

}  // namespace

void remove_held_lock() noexcept {
    if (holds_file.exchange(false)) ::unlink(held_file.data());
}

bool is_lock_file(const fs::path& file) {
    const std::string name = file.filename().string();
    return name == lock_file_name || name.starts_with(passing_start);
}

std::string LockHolder::text() const {
    if (process.pid == 0) return "a process that cannot be told from its lock";
    return "process " + std::to_string(process.pid) + " on " + process.host + ", since " + since;
}

FolderLock::Outcome FolderLock::take(const fs::path& folder) {
    const SignalsWait until_noted;
    const std::string token = new_token();
    const OwnFile own(folder, token);
    Outcome outcome;
    outcome.holder = claim(folder / lock_file_name, own, outcome.taken_from);
    if (!outcome.holder) outcome.lock.reset(new FolderLock(folder, token));
    return outcome;
}

FolderLock::FolderLock(fs::path folder, std::string token)
    : folder_(std::move(folder)), token_(std::move(token)), renewal_([this](const std::stop_token& ended) {
          std::mutex waiting;
          std::unique_lock wait(waiting);
          while (!ended.stop_requested()) {
              ended_.wait_for(wait, ended, std::chrono::duration<double>(renewal_s), [] { return false; });
              if (!ended.stop_requested()) renew();
          }
      }) {
    remember_held(file());
}

FolderLock::~FolderLock() {
    renewal_.request_stop();
    renewal_.join();
    forget_held(file());
    try {
        if (!lost_ && holder_in(read_file(file())).token == token_) ::unlink(file().c_str());
    } catch (const Error&) {  // removed by somebody else: nothing is left to do
    }
}

void FolderLock::renew() {
    const std::lock_guard guard(mutex_);
    if (lost_) return;
    renewed_ = WallClock::now();
    try {
        if (!fs::exists(fs::symlink_status(file()))) {
            const OwnFile own(folder_, token_);
            if (own.link_as(file())) return;
        }
        // An unreadable file, or a disk that does not answer, is no other process.
        const std::string found = holder_in(read_file(file())).token;
        if (found == token_)
            ::utimensat(AT_FDCWD, file().c_str(), nullptr, 0);
        else if (!found.empty())
            lost_ = true;
    } catch (const std::exception&) {  // the next sign of life may work
    }
    if (lost_) forget_held(file());
}

void FolderLock::check() {
    // A process that was suspended looks before it goes on writing.
    bool due = false;
    {
        const std::lock_guard guard(mutex_);
        due = seconds_since(renewed_) > 2 * renewal_s;
    }
    if (due) renew();
    if (!lost_) return;
    std::string by;
    try {
        by = holder_in(read_file(file())).text();
    } catch (const Error&) {
        by = "a process that has ended";
    }
    throw ResourceError("another dmp has taken over " + folder_.string() + ": " + by,
                        "This one gave no sign of life for more than " +
                            std::to_string(static_cast<int>(silence_limit_s / 60)) +
                            " min: it was suspended, or its disk did not answer. It ends, so that their files do not "
                            "mix.\nRun it again in another folder, with --out.");
}

}  // namespace dmp
